// SPDX-License-Identifier: MIT
#include "cli/bench/bar.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "cli/bench/bar_report.hpp"
#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/bench/slice_taps.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/render_settings.hpp"
#include "effect/study/copy_clock.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

constexpr int most_scored = 8;
constexpr const char* block_name = "bar";

std::vector<scene::Scene> scenes_asked(const std::vector<std::string>& names) {
    std::vector<scene::Scene> scenes;
    for (const std::string& name : names) {
        scenes.push_back(scene::make_scene(name));
        if (!scenes.back().camera_path)
            throw std::invalid_argument(
                fmt::format("--scene {}: its camera stands still, expected one that moves", name));
    }
    if (!names.empty()) return scenes;
    for (const scene::SceneInfo& info : scene::built_in_scenes()) {
        scene::Scene scene = scene::make_scene(info.name);
        if (scene.camera_path) scenes.push_back(std::move(scene));
    }
    return scenes;
}

effect::BarSettings settings_of(const BenchBarOptions& options, double radius) {
    const RenderOptions candidate{
        .method = options.method, .preset = options.preset, .samples = options.samples, .set = options.set};
    return {with_radius(settings_for(candidate, 1.0), static_cast<float>(radius)), slice_taps(options.exact),
            slice_taps(options.fast)};
}

// The work of one call. The options are checked before any of it.
class BarBench {
  public:
    explicit BarBench(const BenchBarOptions& options)
        : options_(options),
          scenes_(scenes_asked(options.scenes)),
          frames_({.extent = image_size(options.size),
                   .frames = options.frames,
                   .scored = std::min(most_scored, options.frames / 2),
                   .rays = options.rays}),
          old_page_(options.page.empty() ? "" : read_page(options.page)),
          page_(options.page),
          json_(options.json) {
        (void)settings_of(options, 1.0);
        if (!options.page.empty()) (void)with_blocks(old_page_, {{block_name, ""}});
    }

    int run() {
        gpu::Device device = open_device(options_.device, options_.validation);
        effect::require_timestamps(device.info());
        const scene::PassLibrary passes(glsl_directory(), cache_directory());
        BarReport report{.device = device.info(), .extent = frames_.extent};
        for (const scene::Scene& scene : scenes_)
            report.rows.push_back({scene.name, measured(device, passes, scene)});
        const std::string text = to_text(report, options_);
        fmt::print("{}", text);
        json_.write(to_json(report, options_));
        if (!options_.page.empty()) page_.write(with_blocks(old_page_, {{block_name, text}}));
        const int messages = validation_status(device);
        const bool met = std::ranges::all_of(report.rows, &BarRow::met);
        return met || !options_.fail_if_missed ? messages : 1;
    }

  private:
    [[nodiscard]] effect::Bar measured(const gpu::Device& device, const scene::PassLibrary& passes,
                                       const scene::Scene& scene) const {
        const scene::TruthCache cache(truth_cache_directory());
        effect::BenchmarkViews views(device, passes, scene, frames_, cache,
                                     progress_bar(scene.name + ", truth"));
        return effect::study_bar(device, passes, views, settings_of(options_, scene.ao_radius),
                                 options_.rounds, progress_bar(scene.name));
    }

    const BenchBarOptions& options_;
    std::vector<scene::Scene> scenes_;
    effect::BenchmarkFrames frames_;
    std::string old_page_;
    report::OutputFile page_;
    report::OutputFile json_;
};

void add_run_options(CLI::App& command, BenchBarOptions& options) {
    command.add_option("--scene", options.scenes,
                       "built-in scenes; without it all of those whose camera moves");
    command.add_option("--preset", options.preset, "of the temporal run")->capture_default_str();
    command.add_option("--method", options.method, "instead of the preset's");
    command.add_option("--samples", options.samples, "instead of the preset's")
        ->check(CLI::Range(std::uint32_t{1}, effect::most_samples));
    command.add_option("--set", options.set, "NAME=VALUE: any setting of the run, lengths for a radius of 1")
        ->allow_extra_args(false);
    command.add_option("--error-of", options.exact, "SLICESxSTEPS of the plain loop that bounds the error")
        ->capture_default_str();
    command
        .add_option("--time-of", options.fast,
                    "SLICESxSTEPS of the plain loop, with its blur, that bounds the time")
        ->capture_default_str();
}

}  // namespace

int run_bench_bar(const BenchBarOptions& options) {
    return BarBench(options).run();
}

void add_bench_bar(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchBarOptions>();
    CLI::App* command = bench.add_subcommand(
        "bar", "error and time of a temporal run against single frames of a plain loop over slices");
    add_run_options(*command, *options);
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command->add_option("--frames", options->frames, "of the run; half of them, at most 8, are scored")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    command->add_option("--rounds", options->rounds, "over the frames")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    command->add_flag("--fail-if-missed", options->fail_if_missed, "status 1 where a scene misses the bar");
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page, "page whose table is written anew (docs/temporal.md)");
    command->callback([options, &status] { status = run_bench_bar(*options); });
}

}  // namespace gloam::cli
