// SPDX-License-Identifier: MIT
#include "cli/bench/methods.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "cli/bench/image_size.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "report/image.hpp"
#include "report/output.hpp"

namespace gloam::cli {
namespace {

using namespace effect;

std::vector<MethodConfiguration> configurations_of(const std::vector<std::string>& methods) {
    for (const std::string& name : methods) (void)method_named(name);
    std::vector<MethodConfiguration> list = method_configurations();
    std::erase_if(list, [&](const MethodConfiguration& configuration) {
        return !methods.empty() && std::ranges::find(methods, configuration.settings.method) == methods.end();
    });
    return list;
}

std::vector<scene::Scene> scenes_named(const std::vector<std::string>& names) {
    std::vector<scene::Scene> scenes;
    for (const std::string& name : names) scenes.push_back(scene::make_scene(name));
    return scenes;
}

// The work of one call. The options are checked before any of it.
class MethodsBench {
  public:
    explicit MethodsBench(const BenchMethodsOptions& options)
        : options_(options),
          extent_(image_size(options.size)),
          configurations_(configurations_of(options.methods)),
          scenes_(scenes_named(options.scenes)),
          old_page_(options.page.empty() ? "" : read_page(options.page)),
          page_(options.page),
          json_(options.json),
          device_(open_device(options.device, options.validation)),
          passes_(glsl_directory(), cache_directory()),
          cache_(truth_cache_directory()) {
        if (!options.page.empty()) (void)with_blocks(old_page_, to_blocks(empty_report()));
        if (!options.out.empty()) out_.emplace(options.out);
    }

    int run() {
        MethodsReport report = empty_report();
        for (const MethodConfiguration& configuration : configurations_)
            report.rows.push_back({.configuration = configuration});
        measure_views(report);
        for (const scene::Scene& scene : scenes_) measure_scene(report, scene);
        const std::vector<PageBlock> blocks = to_blocks(report);
        for (const PageBlock& block : blocks) fmt::print("{}\n", block.text);
        if (out_) out_->keep();
        json_.write(to_json(report));
        if (!options_.page.empty()) page_.write(with_blocks(old_page_, blocks));
        return validation_status(device_);
    }

  private:
    [[nodiscard]] MethodsReport empty_report() const {
        MethodsReport report{.device = device_.info(), .extent = extent_, .pixels = options_.pixels};
        for (const scene::Scene& scene : scenes_) report.scenes.push_back(scene.name);
        return report;
    }

    void measure_views(MethodsReport& report) {
        const auto progress = progress_bar("views in closed form");
        const ClosedFormOptions options{.pixels = static_cast<std::uint32_t>(options_.pixels),
                                        .frames = options_.frames};
        ClosedFormStudy study(device_, passes_, options.pixels);
        for (std::size_t i = 0; i < report.rows.size(); ++i) {
            report.rows[i].views = study_views(study, report.rows[i].configuration, options);
            progress(static_cast<double>(i + 1) / static_cast<double>(report.rows.size()));
        }
    }

    void measure_scene(MethodsReport& report, const scene::Scene& scene) {
        SceneStudy study(
            device_, passes_, cache_, scene,
            {.extent = extent_, .rays = options_.rays, .progress = progress_bar(scene.name + ": truth")});
        report.depth.push_back(metrics_of(study.depth(), study.geometry(), extent_));
        write_picture(scene.name, "truth", study.geometry());
        write_picture(scene.name, "depth", study.depth());
        const auto progress = progress_bar(scene.name);
        for (std::size_t i = 0; i < report.rows.size(); ++i) {
            MethodRow& row = report.rows[i];
            row.scenes.push_back(study.run(row.configuration));
            if (row.configuration.name == row.configuration.settings.method)
                write_picture(scene.name, row.configuration.name, row.scenes.back().limit);
            progress(static_cast<double>(i + 1) / static_cast<double>(report.rows.size()));
        }
    }

    void write_picture(const std::string& scene, const std::string& what,
                       const std::vector<float>& occlusion) {
        if (!out_) return;
        out_->write(picture_name(scene, what),
                    report::to_visibility_png(occlusion, extent_.width, extent_.height));
    }

    BenchMethodsOptions options_;
    gpu::Extent extent_;
    std::vector<MethodConfiguration> configurations_;
    std::vector<scene::Scene> scenes_;
    std::string old_page_;
    report::OutputFile page_;
    report::OutputFile json_;
    gpu::Device device_;
    scene::PassLibrary passes_;
    scene::TruthCache cache_;
    std::optional<report::OutputFolder> out_;
};

}  // namespace

int run_bench_methods(const BenchMethodsOptions& options) {
    return MethodsBench(options).run();
}

void add_bench_methods(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchMethodsOptions>();
    CLI::App* command =
        bench.add_subcommand("methods", "errors of every method on views in closed form and on scenes");
    command->add_option("--scene", options->scenes, "built-in scenes")->capture_default_str();
    command->add_option("--method", options->methods, "methods; all when not given");
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the scenes' images")->capture_default_str();
    command->add_option("--pixels", options->pixels, "of a side of the views in closed form, odd")
        ->check(CLI::Range(33, 1025) & CLI::Validator(
                                           [](const std::string& text) {
                                               return (text.back() - '0') % 2 == 0 ? "expected an odd number"
                                                                                   : std::string{};
                                           },
                                           "ODD"))
        ->capture_default_str();
    command->add_option("--frames", options->frames, "of 1024 samples, of the views in closed form")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--out", options->out, "folder for pictures");
    command->add_option(
        "--page", options->page,
        "page whose tables are written anew, between <!-- begin NAME --> and <!-- end NAME -->");
    command->callback([options, &status] { status = run_bench_methods(*options); });
}

}  // namespace gloam::cli
