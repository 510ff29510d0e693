// SPDX-License-Identifier: MIT
#include "cli/bench/temporal.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "cli/bench/image_size.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "effect/methods.hpp"
#include "report/image.hpp"
#include "report/output.hpp"
#include "report/plot.hpp"
#include "scene/truth.hpp"

namespace gloam::cli {
namespace {

using namespace effect;

constexpr double full_error = 0.1;  // as bright as the scale of the error maps goes

report::Curve curve_of(const std::string& name, const std::vector<int>& frames,
                       const std::vector<Score>& scores, PixelClass which) {
    report::Curve curve{.name = name};
    for (std::size_t i = 0; i < scores.size(); ++i)
        curve.points.emplace_back(frames[i], scores[i].rmse_filtered(Against::limit, which));
    return curve;
}

report::Plot convergence_plot(const TemporalReport& report) {
    report::Plot plot{.title = report.scene + ", still view",
                      .x = "samples",
                      .y = "RMSE against the limit",
                      .logarithmic = true};
    report::Curve raw{.name = "raw"};
    report::Curve filtered{.name = "filtered"};
    report::Curve independent{.name = "independent samples"};
    const double first = report.still.front().raw[0] * std::sqrt(report.still.front().samples);
    for (std::size_t i = 0; i < report.still.size(); ++i) {
        if (i >= 64 && i % 16 != 0) continue;  // a long run needs no more
        const StillFrame& frame = report.still[i];
        raw.points.emplace_back(frame.samples, frame.raw[0]);
        filtered.points.emplace_back(frame.samples, frame.filtered[0]);
        independent.points.emplace_back(frame.samples, first / std::sqrt(frame.samples));
    }
    plot.curves = {raw, filtered, independent};
    return plot;
}

// Errors of a class, frame by frame; nullopt where the scene has no such pixels.
std::optional<report::Plot> class_plot(const TemporalReport& report, PixelClass which) {
    const MotionStudy& study = report.motion;
    if (std::isnan(total(study.single).rmse_filtered(Against::limit, which))) return std::nullopt;
    report::Plot plot{.title = fmt::format("{}, {} pixels, filtered", report.scene, name_of(which)),
                      .x = "frame",
                      .y = "RMSE against the limit"};
    for (const MotionRun& run : study.runs) {
        const std::string& name = run.variant.name;
        if (name == "full" || name == "preset moving" || name == "neighbourhood (9)")
            plot.curves.push_back(curve_of(name == "full"            ? name
                                           : name == "preset moving" ? name
                                                                     : "without (9)",
                                           study.frames, run.scores, which));
    }
    plot.curves.push_back(curve_of("single frame", study.frames, study.single, which));
    plot.curves.push_back(curve_of("same view, still", study.frames, study.still, which));
    return plot;
}

void write_last(report::OutputFolder& folder, const std::string& prefix, gpu::Extent size,
                const MotionRun& run, const Truth& limit) {
    const Frame& frame = run.last;
    std::vector<float> errors;
    for (std::size_t i = 0; i < limit.size(); ++i) errors.push_back(std::abs(frame.filtered[i] - limit[i]));
    const auto heat = [&](const char* name, const std::vector<float>& values, double full) {
        folder.write(prefix + name, report::to_heat_png(values, size.width, size.height, full));
    };
    folder.write(prefix + "ao.png", report::to_visibility_png(frame.filtered, size.width, size.height));
    heat("error.png", errors, full_error);
    heat("convergence.png", frame.convergence, 1.0);
    heat("samples.png", frame.kept, double{run.variant.settings.weight_max});
}

// Settings for half a minute instead of minutes.
BenchTemporalOptions quickened(BenchTemporalOptions options) {
    if (!options.quick) return options;
    options.size = "96x54";
    options.every = 8;
    options.rays = 64;
    options.scenes.resize(1);
    return options;
}

// The work of one call.
class TemporalBench {
  public:
    explicit TemporalBench(const BenchTemporalOptions& options)
        : options_(options),
          extent_(image_size(options.size)),
          scenes_(scenes_named(options.scenes)),
          preset_(preset_named(options.preset).settings),
          json_(options.json),
          device_(open_device(options.device, options.validation)),
          passes_(glsl_directory(), cache_directory()),
          cache_(truth_cache_directory()),
          limit_(device_, passes_, extent_) {
        if (!options.out.empty()) out_.emplace(options.out);
    }

    int run() {
        std::vector<TemporalReport> reports;
        for (const scene::Scene& scene : scenes_) {
            reports.push_back(measured(scene));
            const std::string text = to_markdown(reports.back());
            fmt::print("{}\n", text);
            std::fflush(stdout);
            if (!out_) continue;
            write_pictures(*out_, reports.back());
            out_->write(scene.name + ".md", text);
        }
        if (out_) out_->keep();
        json_.write(to_json(reports));
        return validation_status(device_);
    }

  private:
    static std::vector<scene::Scene> scenes_named(const std::vector<std::string>& names) {
        std::vector<scene::Scene> scenes;
        for (const std::string& name : names) scenes.push_back(scene::make_scene(name));
        return scenes;
    }

    [[nodiscard]] References truth_of_frame(const scene::Scene& scene, int frame, const scene::GBuffer& view,
                                            const Settings& settings) {
        const scene::TruthSettings traced{.rays = {.radius = scene.ao_radius, .rays = options_.rays}};
        return {truth_from(view, limit_.of(view, settings)),
                truth_from(view, cache_.depth(view, traced).occlusion),
                truth_from(view, cache_.geometry(scene, frame, view, traced).occlusion)};
    }

    [[nodiscard]] TemporalReport measured(const scene::Scene& scene) {
        const auto radius = static_cast<float>(scene.ao_radius);
        const Settings settings = with_radius(preset_, radius);
        const auto sequence = sequence_of(device_, passes_, scene, extent_, options_.frames);
        TemporalReport report{.scene = scene.name,
                              .preset = options_.preset,
                              .device = device_.info(),
                              .extent = extent_,
                              .weight_max = double{settings.weight_max}};
        const scene::GBuffer& first = sequence.front().view;
        report.still =
            study_still(device_, passes_, first, settings, truth_of_frame(scene, 0, first, settings),
                        options_.still_frames, progress_bar(scene.name + ", still"));
        std::vector<Variant> variants = ablations_of(settings);
        variants.push_back({"preset moving", "128 samples in the mean, always k1 and rotated, trust capped",
                            with_radius(preset_named("moving").settings, radius)});
        report.motion =
            study_motion(device_, passes_, sequence, variants,
                         [&](int frame, const SequenceFrame& now) {
                             return truth_of_frame(scene, frame, now.view, settings);
                         },
                         {.every = options_.every, .progress = progress_bar(scene.name + ", moving")});
        return report;
    }

    BenchTemporalOptions options_;
    gpu::Extent extent_;
    std::vector<scene::Scene> scenes_;
    Settings preset_;
    report::OutputFile json_;
    gpu::Device device_;
    scene::PassLibrary passes_;
    scene::TruthCache cache_;
    Limit limit_;
    std::optional<report::OutputFolder> out_;
};

}  // namespace

void write_pictures(report::OutputFolder& folder, const TemporalReport& report) {
    const MotionStudy& study = report.motion;
    folder.write(report.scene + "-convergence.svg", report::to_svg(convergence_plot(report)));
    for (const PixelClass which : {PixelClass::settled, PixelClass::disoccluded, PixelClass::near_moving}) {
        if (const auto plot = class_plot(report, which))
            folder.write(fmt::format("{}-{}.svg", report.scene, name_of(which)), report::to_svg(*plot));
    }
    folder.write(report.scene + "-limit-ao.png",
                 report::to_visibility_png(study.last[0], report.extent.width, report.extent.height));
    for (const MotionRun& run : study.runs) {
        const std::string& name = run.variant.name;
        if (name == "full") write_last(folder, report.scene + "-full-", report.extent, run, study.last[0]);
        if (name == "preset moving")
            write_last(folder, report.scene + "-moving-", report.extent, run, study.last[0]);
        if (name == "neighbourhood (9)")
            write_last(folder, report.scene + "-without-9-", report.extent, run, study.last[0]);
    }
}

int run_bench_temporal(BenchTemporalOptions options) {
    return TemporalBench(quickened(std::move(options))).run();
}

void add_bench_temporal(CLI::App& bench, int& status) {
    auto options = std::make_shared<BenchTemporalOptions>();
    CLI::App* command = bench.add_subcommand(
        "temporal", "the temporal effect on still and moving views, and each mechanism switched off alone");
    command->add_option("--scene", options->scenes, "built-in scenes")->capture_default_str();
    command->add_option("--preset", options->preset, "what the full effect is")->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the images")->capture_default_str();
    command
        ->add_option("--frames", options->frames,
                     "frames of the moving scene; 33 and more have settled pixels")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    command->add_option("--still-frames", options->still_frames, "frames of the still view")
        ->check(CLI::Range(2, 100'000))
        ->capture_default_str();
    command->add_option("--every", options->every, "frames from one that is scored to the next")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_option("--rays", options->rays, "rays of the truth for each pixel")
        ->check(CLI::Range(32, 65'536))
        ->capture_default_str();
    command->add_flag("--quick", options->quick, "one scene, 96x54 pixels, coarse truth: half a minute");
    add_device_options(*command, options->device, options->validation);
    command->add_option("--json", options->json, "write every number to this file");
    command->add_option("--out", options->out, "folder for tables, curves and pictures");
    command->callback([options, &status] { status = run_bench_temporal(*options); });
}

}  // namespace gloam::cli
