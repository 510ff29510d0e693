// SPDX-License-Identifier: MIT
#include "cli/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>

#include "cli/drivers.hpp"
#include "cli/environment.hpp"
#include "cli/open_device.hpp"
#include "cli/progress.hpp"
#include "cli/render_directions.hpp"
#include "cli/render_files.hpp"
#include "cli/render_history.hpp"
#include "cli/render_input.hpp"
#include "cli/render_report.hpp"
#include "cli/render_settings.hpp"
#include "cli/render_truth.hpp"
#include "report/output_folder.hpp"
#include "scene/frame_link.hpp"
#include "scene/guard_band.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// depth: the truth of the depth buffer, compared with that of the geometry.
TruthReport report_of(const TracedView& traced, const effect::Truth& truth, const effect::Truth& depth) {
    const scene::TracedTruth& best = traced.geometry ? *traced.geometry : traced.depth;
    double squares = 0.0;
    for (const float error : best.standard_error) squares += double{error} * double{error};
    TruthReport report{.rays = best.rays, .pixels = best.pixels, .unmatched = best.unmatched};
    report.standard_error = std::sqrt(squares / static_cast<double>(std::max<std::uint64_t>(1, best.pixels)));
    if (traced.geometry) report.depth = effect::errors_of(depth, truth);
    return report;
}

// Over the pixels with geometry.
double mean_convergence(const effect::Frame& frame, const scene::GBuffer& view) {
    double sum = 0.0;
    for (const float value : frame.convergence) sum += double{value};
    const auto surface = std::ranges::count_if(view.depth, [](float d) { return std::isfinite(d); });
    return surface == 0 ? 0.0 : sum / static_cast<double>(surface);
}

HistoryReport history_of(const effect::Frame& frame, const scene::GBuffer& view) {
    double surface = 0.0;
    double kept = 0.0;
    double samples = 0.0;
    for (std::size_t i = 0; i < frame.kept.size(); ++i) {
        if (!std::isfinite(view.depth[i])) continue;
        surface += 1.0;
        kept += frame.kept[i] > 0.0F ? 1.0 : 0.0;
        samples += double{frame.kept[i]};
    }
    return {.kept = kept / std::max(surface, 1.0), .samples = samples / std::max(kept, 1.0)};
}

// The work of one call.
class Renderer {
  public:
    explicit Renderer(const RenderOptions& options)
        : options_(options),
          input_(open_input(options)),
          truth_(options, input_),
          out_(checked_out(options)),
          device_(open_device(options.device, options.validation)),
          passes_(glsl_directory(), cache_directory()),
          progress_(progress_bar(input_.name + ": frames")) {
        if (options.light) environment_ = environment_named(*options.light);
        if (!options.write_gbuffer.empty()) gbuffer_out_.emplace(options.write_gbuffer);
        report_ = {.source = input_.name,
                   .preset = options.preset,
                   .truth = truth_.name(),
                   .device = device_.info(),
                   .repeat = options.repeat};
    }

    int run() {
        for (const int number : input_.views) render_view(number);
        out_.write("render.json", to_json(report_));
        if (gbuffer_out_) gbuffer_out_->keep();
        out_.keep();
        fmt::print("{}pictures: {}\n", to_text(report_), (out_.path() / "*_ao.png").string());
        return validation_status(device_);
    }

  private:
    // Names in the options are looked at before the folder is made.
    static std::filesystem::path checked_out(const RenderOptions& options) {
        (void)settings_for(options, 1.0);
        return options.out;
    }

    void render_view(int number) {
        scene::GBuffer wide = input_.load(device_, passes_, number);  // with its guard band
        const effect::Settings settings = settings_for(options_, wide.ao_radius);
        const std::string cut = cut_before(number, wide, settings);
        if (cut.empty()) link(wide, before_->view);
        const scene::GBuffer view = scene::cropped(wide);
        const ViewTruth truth = truth_at(number, view, settings);
        if (gbuffer_out_) write_gbuffer(*gbuffer_out_, number, wide);
        if (!effect_ || before_->view.extent != wide.extent) effect_.emplace(device_, passes_, wide.extent);
        cut.empty() ? effect_->advance(wide) : effect_->begin(wide, settings);
        for (int i = 0; i < input_.frames_per_view; ++i) {
            const ViewLink linked = i > 0 ? ViewLink::same : cut.empty() ? ViewLink::follows : ViewLink::cut;
            const effect::Frame frame = effect_->next(options_.repeat);
            write_images(out_, number + i, frame);
            history_.advance(view, linked, double{settings.radius}, frame.filtered);
            FrameReport entry = entry_of(number + i, settings, frame, view);
            if (i == 0) entry.history.cut = cut;
            compare(entry, view, frame, truth, i + 1 == input_.frames_per_view);
            report_.frames.push_back(std::move(entry));
            progress_(static_cast<double>(report_.frames.size()) / static_cast<double>(frame_count()));
        }
        write_directions(number + input_.frames_per_view - 1, wide, settings);
        before_ = Before{number, settings.radius, std::move(wide)};
    }

    // What is asked for beside the occlusion, of the view alone.
    void write_directions(int number, const scene::GBuffer& wide, const effect::Settings& settings) {
        if (!options_.bent_normals && !environment_) return;
        if (!directional_) directional_.emplace(device_, passes_);
        if (options_.bent_normals)
            write_bent_normals(out_, number, directional_->bent_normals(wide, settings));
        if (environment_) write_light(out_, number, directional_->light(wide, settings, *environment_));
    }

    // Why the view has no history; empty: it has.
    [[nodiscard]] std::string cut_before(int number, const scene::GBuffer& view,
                                         const effect::Settings& settings) const {
        if (!before_) return "the first frame";
        if (number != before_->number + 1) return "frames are missing before it";
        if (settings.radius != before_->radius) return "the radius has changed";
        return cut_between(before_->view, view);
    }

    // Empty where nothing is known, or it is not asked for in this view.
    [[nodiscard]] ViewTruth truth_at(int number, const scene::GBuffer& view,
                                     const effect::Settings& settings) {
        if (number != input_.views.back() && !truth_.every_view()) return {};
        ViewTruth truth = truth_.of(view, input_.first_frame + number, double{settings.radius});
        if (truth.traced) {
            const bool only = input_.views.size() == 1 || !truth_.every_view();
            write_truth(out_, only ? "" : scene::frame_prefix(number) + "_", view.extent, *truth.traced);
        }
        return truth;
    }

    [[nodiscard]] FrameReport entry_of(int number, const effect::Settings& settings,
                                       const effect::Frame& frame, const scene::GBuffer& view) const {
        FrameReport entry{.number = number,
                          .extent = frame.extent,
                          .settings = settings,
                          .times = frame.times,
                          .work = frame.work,
                          .mean_convergence = mean_convergence(frame, view),
                          .history = history_of(frame, view),
                          .flicker = history_.flicker()};
        const bool follows = input_.frames_per_view == 1;
        if (input_.scene) entry.scene_frame = input_.first_frame + (follows ? number : 0);
        return entry;
    }

    void compare(FrameReport& entry, const scene::GBuffer& view, const effect::Frame& frame,
                 const ViewTruth& truth, bool last) {
        if (truth.truth.empty()) return;
        entry.errors = {effect::errors_of(frame.occlusion, truth.truth),
                        effect::errors_of(frame.filtered, truth.truth)};
        if (truth.traced) {
            const effect::Truth depth = effect::truth_from(view, truth.traced->depth.occlusion);
            entry.truth = report_of(*truth.traced, truth.truth, depth);
            if (truth.traced->geometry)
                entry.errors->filtered_depth = effect::errors_of(frame.filtered, depth);
        }
        if (history_.flicker() && history_.classes()) {
            entry.errors->by_class =
                effect::class_errors_of(frame.filtered, truth.truth, *history_.classes());
        }
        if (!last) return;
        entry.errors->metrics = effect::metrics_of(frame.filtered, truth.truth, view.extent);
        write_error(out_, entry.number, frame, truth.truth);
    }

    [[nodiscard]] std::size_t frame_count() const {
        return input_.views.size() * static_cast<std::size_t>(input_.frames_per_view);
    }

    // The view before, with its guard band.
    struct Before {
        int number;
        float radius;
        scene::GBuffer view;
    };

    const RenderOptions& options_;
    RenderInput input_;
    TruthSource truth_;
    report::OutputFolder out_;
    std::optional<report::OutputFolder> gbuffer_out_;
    gpu::Device device_;
    scene::PassLibrary passes_;
    std::optional<effect::AmbientOcclusion> effect_;
    std::optional<effect::Directional> directional_;
    std::optional<scene::Environment> environment_;
    std::optional<Before> before_;
    RenderHistory history_;
    std::function<void(double)> progress_;
    RenderReport report_;
};

void add_view_options(CLI::App& command, RenderOptions& options) {
    command.add_option("source", options.source,
                       "scene (gloam list scenes) or mesh file, stood on a ground plane");
    command.add_option("--gbuffer", options.gbuffer, "folder of G-buffers of an engine, instead of a scene");
    command.add_option("--size", options.size, "WIDTHxHEIGHT of a scene or mesh, pixels")
        ->capture_default_str();
    command
        .add_option("--frames", options.frames,
                    "frames: of a scene that moves, followed from --frame on; of a G-buffer sequence, the "
                    "first N (default all); else accumulated on the one view (default 1)")
        ->check(CLI::Range(1, 9999));
    command.add_option("--frame", options.frame, "of a scene that moves: the first frame shown, 0 and up")
        ->check(CLI::Range(0, 1'000'000));
    command.add_flag("--still", options.still, "hold the scene at --frame and accumulate frames there");
    command.add_option("--write-gbuffer", options.write_gbuffer, "folder for the G-buffers that were shaded");
    command.add_option("--out", options.out, "folder for pictures and render.json")->capture_default_str();
}

void add_effect_options(CLI::App& command, RenderOptions& options) {
    command.add_option("--method", options.method, "gloam list methods (default: the preset's)");
    command.add_option("--preset", options.preset, "gloam list presets")->capture_default_str();
    command
        .add_option("--samples", options.samples,
                    "samples for each pixel in each frame (default: the preset's)")
        ->check(CLI::Range(1U, effect::most_samples));
    command.add_option("--radius", options.radius, "world units (default: the view's)");
    command.add_option("--bias", options.bias, "world units (default: the preset's part of the radius)");
    command.add_option(
        "--guard", options.guard,
        "guard band: part of the image rendered around it on each side, so that what lies near "
        "its edge has its neighbourhood; 0 to 0.5, usually 0.05 to 0.1 (default: none)");
    command.add_flag("--no-filter", options.no_filter, "show the estimate as it is");
    command.add_flag("--bent-normals", options.bent_normals,
                     "write the directions in which points are open, and the cones around them, too");
    command.add_option(
        "--light", options.light,
        "white, sky, or an environment as .exr or .pfm: write the scene in its light, with what "
        "blocks it and what bounces once, too");
    command
        .add_option("--set", options.set, "NAME=VALUE: any setting (gloam list settings); may be repeated")
        ->allow_extra_args(false);
}

void add_truth_options(CLI::App& command, RenderOptions& options) {
    CLI::Option* truth = command
                             .add_option_function<std::vector<std::string>>(
                                 "--truth",
                                 [&options](const std::vector<std::string>& files) {
                                     options.truth = files.empty() ? "" : files.front();
                                     options.trace_truth = options.truth.empty();
                                 },
                                 "compare with true occlusion: traced now, or given as a PFM file")
                             ->expected(0, 1)
                             ->type_name("[FILE]");
    command
        .add_flag(
            "--truth-every", options.truth_every,
            "trace the truth of every frame of a sequence, not of the last alone: it takes as long for each")
        ->needs(truth);
    command.add_option("--truth-rays", options.truth_rays, "rays for each pixel, 32 to 16777216")
        ->needs(truth)
        ->capture_default_str();
    command.add_option("--truth-falloff", options.truth_falloff, "linear, quadratic or step")
        ->needs(truth)
        ->capture_default_str();
    command
        .add_option("--truth-thickness", options.truth_thickness,
                    "of what the depth buffer shows, world units (default: solid behind its surface)")
        ->needs(truth);
}

// `render --truth columns`: with nothing else to render, what follows is the scene and not its truth.
void take_scene_from_truth(RenderOptions& options) {
    if (!options.source.empty() || !options.gbuffer.empty() || options.truth.empty()) return;
    options.source = std::exchange(options.truth, "");
    options.trace_truth = true;
}

}  // namespace

int run_render(const RenderOptions& options) {
    return Renderer(options).run();
}

void add_render(CLI::App& app, int& status) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App* command =
        app.add_subcommand("render", "ambient occlusion of a scene, a mesh or an engine's G-buffer");
    add_view_options(*command, *options);
    add_effect_options(*command, *options);
    add_truth_options(*command, *options);
    command->add_option("--repeat", options->repeat, "runs of each frame, of which times are the median")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    command->add_option("--device", options->device, "name or index of the device (gloam devices)");
    command->add_flag("--validation", options->validation, "Vulkan validation layers on; any message fails");
    add_driver_option(*command);
    command->callback([options, &status] {
        take_scene_from_truth(*options);
        status = run_render(*options);
    });
}

}  // namespace gloam::cli
