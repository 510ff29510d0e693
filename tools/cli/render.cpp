// SPDX-License-Identifier: MIT
#include "cli/render.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "cli/environment.hpp"
#include "cli/render_input.hpp"
#include "cli/render_report.hpp"
#include "effect/presets.hpp"
#include "report/image.hpp"
#include "report/output_folder.hpp"
#include "scene/pfm.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// Settings for a view: the preset, then what the options and the view say.
effect::Settings settings_for(const RenderOptions& options, const std::optional<double>& view_radius) {
    effect::Settings settings = effect::preset_named(options.preset).settings;
    settings.method = effect::method_named(options.method);
    if (options.samples) settings.samples = *options.samples;
    if (options.no_filter) settings.filter = false;
    if (!options.radius && !view_radius) {
        throw std::invalid_argument("no radius: the G-buffer has no ao_radius, so give --radius");
    }
    settings = with_radius(settings, options.radius.value_or(static_cast<float>(view_radius.value_or(1.0))));
    if (options.bias) settings.bias = *options.bias;
    validate(settings);
    return settings;
}

void write_gbuffer(report::OutputFolder& folder, int number, const scene::GBuffer& view) {
    const std::string prefix = scene::frame_prefix(number);
    const gpu::Extent size = view.extent;
    const auto write_vectors = [&](const char* name, const std::vector<glm::vec3>& vectors) {
        std::vector<float> texels;
        for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z});
        if (!texels.empty()) folder.write(prefix + name, report::to_pfm(texels, size.width, size.height, 3));
    };
    folder.write(prefix + "_depth.pfm", report::to_pfm(view.depth, size.width, size.height, 1));
    write_vectors("_normal.pfm", view.normal);
    write_vectors("_motion.pfm", view.motion);
    folder.write(prefix + ".json", scene::frame_json(view, number));
}

void write_images(report::OutputFolder& folder, int number, gpu::Extent size, const effect::Frame& frame) {
    const std::string prefix = scene::frame_prefix(number);
    folder.write(prefix + "_ao.pfm", report::to_pfm(frame.filtered, size.width, size.height, 1));
    folder.write(prefix + "_ao.png", report::to_visibility_png(frame.filtered, size.width, size.height));
}

double mean_convergence(const effect::Frame& frame) {
    double sum = 0.0;
    for (const float value : frame.convergence) sum += double{value};
    const std::uint64_t surface = frame.work.pixels - frame.work.background;
    return surface == 0 ? 0.0 : sum / static_cast<double>(surface);
}

// The work of one call.
class Renderer {
  public:
    explicit Renderer(const RenderOptions& options)
        : options_(options),
          input_(open_input(options)),
          reference_(read_reference(options)),
          out_(checked_out(options)),
          device_({.device = options.device,
                   .validation = options.validation ? gpu::Validation::on : gpu::Validation::off,
                   .cache_directory = cache_directory()}),
          passes_(glsl_directory(), cache_directory()) {
        if (!options.write_gbuffer.empty()) gbuffer_out_.emplace(options.write_gbuffer);
        report_ = {.source = input_.name,
                   .preset = options.preset,
                   .truth = reference_ ? options.truth.string() : input_.truth_name,
                   .device = device_.info(),
                   .repeat = options.repeat};
    }

    int run() {
        for (const int number : input_.views) render_view(number);
        out_.write("render.json", to_json(report_));
        if (gbuffer_out_) gbuffer_out_->keep();
        out_.keep();
        if (on_terminal()) fmt::print(stderr, "\r\033[K");
        fmt::print("{}pictures: {}\n", to_text(report_), (out_.path() / "*_ao.png").string());
        const auto messages = device_.take_validation_messages();
        for (const std::string& message : messages) fmt::print(stderr, "gloam: {}\n", message);
        return messages.empty() ? 0 : 1;
    }

  private:
    static std::optional<scene::FloatImage> read_reference(const RenderOptions& options) {
        if (options.truth.empty()) return std::nullopt;
        return scene::read_pfm(options.truth);
    }

    // Names in the options are looked at before the folder is made.
    static std::filesystem::path checked_out(const RenderOptions& options) {
        (void)settings_for(options, 1.0);
        return options.out;
    }

    effect::Truth truth_for(const scene::GBuffer& view, double radius) const {
        if (!reference_) return input_.truth ? effect::truth_of(view, radius, input_.truth) : effect::Truth{};
        if (reference_->extent == view.extent && reference_->channels == 1) {
            return effect::truth_from(view, reference_->texels);
        }
        throw std::invalid_argument(fmt::format("{}: {} x {} with {} channels, expected {} x {} with 1",
                                                options_.truth.string(), reference_->extent.width,
                                                reference_->extent.height, reference_->channels,
                                                view.extent.width, view.extent.height));
    }

    void render_view(int number) {
        const scene::GBuffer view = input_.load(device_, passes_, number);
        const effect::Settings settings = settings_for(options_, view.ao_radius);
        const effect::Truth truth = truth_for(view, double{settings.radius});
        if (gbuffer_out_) write_gbuffer(*gbuffer_out_, number, view);
        if (!effect_ || extent_ != view.extent) effect_.emplace(device_, passes_, view.extent);
        extent_ = view.extent;
        effect_->begin(view, settings);
        for (int i = 0; i < input_.frames_per_view; ++i) {
            show_progress();
            const effect::Frame frame = effect_->next(options_.repeat);
            write_images(out_, number + i, view.extent, frame);
            FrameReport entry{.number = number + i,
                              .extent = view.extent,
                              .settings = settings,
                              .times = frame.times,
                              .work = frame.work,
                              .mean_convergence = mean_convergence(frame)};
            if (!truth.empty()) {
                entry.errors = {effect::errors_of(frame.occlusion, truth),
                                effect::errors_of(frame.filtered, truth)};
            }
            report_.frames.push_back(std::move(entry));
        }
    }

    void show_progress() const {
        if (!on_terminal()) return;
        fmt::print(stderr, "\r{}: frame {} of {}", input_.name, report_.frames.size() + 1,
                   input_.views.size() * static_cast<std::size_t>(input_.frames_per_view));
        std::fflush(stderr);
    }

    const RenderOptions& options_;
    RenderInput input_;
    std::optional<scene::FloatImage> reference_;
    report::OutputFolder out_;
    std::optional<report::OutputFolder> gbuffer_out_;
    gpu::Device device_;
    scene::PassLibrary passes_;
    std::optional<effect::AmbientOcclusion> effect_;
    gpu::Extent extent_;
    RenderReport report_;
};

void add_view_options(CLI::App& command, RenderOptions& options) {
    command.add_option("source", options.source,
                       "scene (gloam list scenes) or mesh file, stood on a ground plane");
    command.add_option("--gbuffer", options.gbuffer, "folder of G-buffers of an engine, instead of a scene");
    command.add_option("--size", options.size, "WIDTHxHEIGHT of a scene or mesh, pixels")
        ->capture_default_str();
    command
        .add_option(
            "--frames", options.frames,
            "frames accumulated on a still view: a scene, a mesh, a G-buffer of one frame (default 1); of a "
            "G-buffer sequence, the first N, each of which starts afresh (default all)")
        ->check(CLI::Range(1, 9999));
    command.add_option("--write-gbuffer", options.write_gbuffer, "folder for the G-buffer that was shaded");
    command.add_option("--out", options.out, "folder for pictures and render.json")->capture_default_str();
}

void add_effect_options(CLI::App& command, RenderOptions& options) {
    command.add_option("--method", options.method, "gloam list methods")->capture_default_str();
    command.add_option("--preset", options.preset, "gloam list presets")->capture_default_str();
    command
        .add_option("--samples", options.samples,
                    "samples for each pixel in each frame (default: the preset's)")
        ->check(CLI::Range(1U, 65'536U));
    command.add_option("--radius", options.radius, "world units (default: the view's)");
    command.add_option("--bias", options.bias, "world units (default: the preset's part of the radius)");
    command.add_flag("--no-filter", options.no_filter, "show the estimate as it is");
    command.add_option("--truth", options.truth, "PFM of true occlusion to compare with");
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
    command->add_option("--repeat", options->repeat, "runs of each frame, of which times are the median")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    command->add_option("--device", options->device, "name or index of the device (gloam devices)");
    command->add_flag("--validation", options->validation, "Vulkan validation layers on; any message fails");
    command->callback([options, &status] { status = run_render(*options); });
}

}  // namespace gloam::cli
