// SPDX-License-Identifier: MIT
#include "cli/bench/views.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>

#include "cli/bench/image_size.hpp"
#include "cli/bench/page_blocks.hpp"
#include "cli/bench/view_options.hpp"
#include "cli/bench/views_report.hpp"
#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/render_settings.hpp"
#include "report/benchmark/summary.hpp"
#include "report/output_file.hpp"

namespace gloam::cli {
namespace {

constexpr const char* views_block = "views";

// The views asked for, in the order of the list.
std::vector<scene::ViewInfo> views_asked(const BenchViewsOptions& options) {
    std::vector<scene::ViewInfo> asked = views_named(options.views);
    if (!options.half.empty())
        std::erase_if(asked,
                      [&](const scene::ViewInfo& view) { return scene::name_of(view.half) != options.half; });
    return asked;
}

void require_possible(const BenchViewsOptions& options) {
    (void)views_named(options.views);
    if (options.single.empty() && options.sequence.empty())
        throw std::invalid_argument("nothing to measure: give --single or --sequence");
    require_scored(options.scored, options.frames);
}

std::vector<ViewCandidate> candidates_of(const BenchViewsOptions& options) {
    std::vector<ViewCandidate> candidates;
    const auto add = [&](const std::string& preset, bool sequence) {
        const RenderOptions render{.preset = preset, .set = options.set};
        candidates.push_back({.name = preset + (sequence ? ", sequence" : ", single"),
                              .settings = settings_for(render, 1.0),
                              .sequence = sequence});
    };
    for (const std::string& preset : options.single) add(preset, false);
    for (const std::string& preset : options.sequence) add(preset, true);
    return candidates;
}

double sum_of(const effect::FrameReading& reading) {
    double sum = 0.0;
    for (const effect::PassTime& pass : reading.passes) sum += pass.ms;
    return sum;
}

// The work of one call. The options are checked before any of it.
class ViewsBench {
  public:
    explicit ViewsBench(const BenchViewsOptions& options)
        : options_(options),
          frames_(
              {.extent = image_size(options.size),
               .frames = options.frames,
               .scored = options.scored,
               .rays = options.rays,
               .depth_truth = !options.no_depth_truth,
               .depth_thickness = options.depth_thickness.value_or(std::numeric_limits<double>::infinity())}),
          old_page_(options.page.empty() ? "" : read_page(options.page)),
          page_(options.page),
          json_(options.json) {
        require_possible(options);
        report_.candidates = candidates_of(options);
        report_.extent = frames_.extent;
        if (!options.page.empty()) (void)with_blocks(old_page_, {{views_block, ""}});
    }

    int run() {
        gpu::Device device = open_device(options_.device, options_.validation);
        if (options_.rounds > 0) effect::require_timestamps(device.info());
        const scene::PassLibrary passes(glsl_directory(), cache_directory());
        report_.device = device.info();
        effect::ConfigurationStudy study(device, passes, frames_.extent);
        for (const scene::ViewInfo& view : views_asked(options_))
            report_.rows.push_back(measured(device, passes, study, view));
        const std::string text = to_text(report_, options_);
        fmt::print("{}", text);
        json_.write(to_json(report_, options_));
        if (!options_.page.empty()) page_.write(with_blocks(old_page_, {{views_block, text}}));
        return validation_status(device);
    }

  private:
    [[nodiscard]] ViewRow measured(const gpu::Device& device, const scene::PassLibrary& passes,
                                   effect::ConfigurationStudy& study, const scene::ViewInfo& info) const {
        const scene::TruthCache cache(truth_cache_directory());
        const std::filesystem::path meshes =
            options_.meshes.empty() ? scene::installed_meshes() : options_.meshes;
        effect::BenchmarkViews views(device, passes, scene::make_view(info.name, meshes), frames_, cache,
                                     progress_bar(info.name + ", truth"));
        ViewRow row{.view = info};
        if (frames_.depth_truth) row.depth_truth = depth_truth_error(views);
        std::vector<std::vector<double>> copies(report_.candidates.size());
        row.cells.resize(report_.candidates.size());
        const auto progress = progress_bar(info.name);
        for (int round = 0; round <= options_.rounds; ++round) {
            for (std::size_t i = 0; i < row.cells.size(); ++i)
                visit(study, views, i, round, row.cells[i], copies[i]);
            progress(static_cast<double>(round + 1) / (options_.rounds + 1));
        }
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            if (!copies[i].empty()) row.cells[i].copies = report::spread_of(copies[i]).median;
        return row;
    }

    [[nodiscard]] static double depth_truth_error(const effect::BenchmarkViews& views) {
        double sum = 0.0;
        for (int i = views.first_scored(); i < views.frames().frames; ++i)
            sum += errors_of(views.scored(i).depth, views.scored(i).geometry).rmse;
        return sum / views.frames().scored;
    }

    // Round 0 gives the errors and warms up; the others give times.
    void visit(effect::ConfigurationStudy& study, effect::BenchmarkViews& views, std::size_t index, int round,
               ViewCell& cell, std::vector<double>& copies) const {
        const ViewCandidate& candidate = report_.candidates[index];
        const effect::Settings settings =
            with_radius(candidate.settings, static_cast<float>(views.scene().ao_radius));
        const effect::ConfigurationVisit found = study.visit(views, settings, candidate.sequence, round);
        if (found.quality) cell.quality = *found.quality;
        if (round == 0) return;
        for (const effect::FrameReading& reading : found.readings)
            copies.push_back(sum_of(reading) / reading.copy_ms);
    }

    const BenchViewsOptions& options_;
    effect::BenchmarkFrames frames_;
    ViewsReport report_;
    std::string old_page_;
    report::OutputFile page_;
    report::OutputFile json_;
};

void add_what(CLI::App& command, BenchViewsOptions& options) {
    command.add_option("--view", options.views, "views; without it all (gloam list views)");
    command.add_option("--half", options.half, "only the views of this half")
        ->check(CLI::IsMember({"tuning", "unseen"}));
    command.add_option("--single", options.single,
                       "presets, each frame alone; the first is the base of the ratios");
    command.add_option("--sequence", options.sequence, "presets, in sequence with their history");
    command
        .add_option("--set", options.set, "NAME=VALUE: any setting of all of them, lengths for a radius of 1")
        ->allow_extra_args(false);
}

}  // namespace

int run_bench_views(const BenchViewsOptions& options) {
    return ViewsBench(options).run();
}

void add_bench_views(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchViewsOptions>();
    CLI::App* command = bench.add_subcommand(
        "views", "error of presets on two halves of views, of which one is never used for tuning");
    add_what(*command, *options);
    add_view_options(*command, *options);
    command->add_option("--rounds", options->rounds, "that are timed, 0: only errors")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    command
        ->add_option("--depth-thickness", options->depth_thickness,
                     "thickness of the surface of (D), in radii; without it (D) is solid")
        ->check(CLI::PositiveNumber);
    command->add_flag("--no-depth-truth", options->no_depth_truth,
                      "do not trace the depth buffer's truth (D): half the time of a first run");
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--page", options->page, "page whose tables are written anew (docs/data/views.md)");
    command->callback([options, &status] { status = run_bench_views(*options); });
}

}  // namespace gloam::cli
