// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "effect/directional.hpp"
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"
#include "pictures/sheet.hpp"
#include "scene/draw.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// A view that does not move.
scene::GBuffer standing_still(scene::GBuffer view) {
    view.motion.clear();
    view.previous_position.clear();
    view.camera.previous_view.reset();
    view.camera.previous_from_current.reset();
    return view;
}

// The relation of a view to the previous one.
enum class ViewLink {
    same,     // the same view again
    follows,  // the next of a sequence
    cut       // an unrelated view
};

// Follows the frames of one call of `gloam render`: the change of the picture from frame to frame, and the
// pixels that a temporal method treats differently.
class RenderHistory {
  public:
    // Takes the next frame. Views without normals have no relation to earlier ones.
    void advance(const scene::GBuffer& view, ViewLink link, double radius, const std::vector<float>& image) {
        flicker_.reset();
        if (view.normal.empty()) {
            view_.reset();
            classes_.reset();
            return;
        }
        const bool follows = view_ && link != ViewLink::cut;
        if (!follows) classes_.emplace(effect::PixelClasses::Settings{.radius = radius});
        std::optional<effect::HistoryMap> history;
        if (follows) history.emplace(link == ViewLink::same ? standing_still(view) : view, *view_);
        if (history) flicker_ = effect::mean_change(*history, image, image_);
        classes_->advance(view, history);
        view_ = view;
        image_ = image;
    }

    // Mean change at the same surface points since the frame before; nullopt in the first.
    [[nodiscard]] const std::optional<double>& flicker() const { return flicker_; }

    // The classes of the last frame's pixels; nullopt if there was no frame before it.
    [[nodiscard]] const std::optional<effect::PixelClasses>& classes() const { return classes_; }

  private:
    std::optional<scene::GBuffer> view_;
    std::vector<float> image_;
    std::optional<double> flicker_;
    std::optional<effect::PixelClasses> classes_;
};

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

}  // namespace

std::string name_of(const RenderOptions& options) {
    if (options.presets.size() > 1) return std::filesystem::path(options.preset).stem().string();
    return settings_for(options, 1.0).method;
}

namespace {

// STEM_bent.pfm (x, y, z in view space) and .png (0.5 + 0.5 of it), STEM_cone.pfm (half angle, radians).
void write_bent_normals(record::OutputFolder& folder, const std::string& stem,
                        const effect::BentNormals& bent) {
    const auto [width, height] = bent.extent;
    const std::vector<float> texels = components_of(bent.direction);
    std::vector<std::uint8_t> picture;
    for (const float value : texels) picture.push_back(byte_of(0.5F + 0.5F * value));
    folder.write(stem + "_bent.pfm", base::to_pfm(texels, width, height, 3));
    folder.write(stem + "_bent.png", base::to_png(picture, width, height));
    folder.write(stem + "_cone.pfm", base::to_pfm(bent.half_angle, width, height, 1));
}

// STEM_light.pfm (linear radiance, direct and bounced) and .png (sRGB, white from 1 on), STEM_bounce.pfm (the
// bounced part).
void write_light(record::OutputFolder& folder, const std::string& stem,
                 const effect::DirectionalLight& light) {
    const auto [width, height] = light.extent;
    std::vector<float> texels = components_of(light.direct);
    const std::vector<float> bounced = components_of(light.bounced);
    std::ranges::transform(texels, bounced, texels.begin(), std::plus{});
    folder.write(stem + "_light.pfm", base::to_pfm(texels, width, height, 3));
    folder.write(stem + "_light.png", base::to_png(base::srgb_of(texels), width, height));
    folder.write(stem + "_bounce.pfm", base::to_pfm(bounced, width, height, 3));
}

// depth: the truth of the depth buffer, which is compared with that of the geometry.
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

// With the cones whose visibility, by the cosine around their axis, the pixels have.
effect::BentNormals bent_of(const effect::Frame& frame, const scene::GBuffer& view) {
    effect::BentNormals bent{.extent = frame.extent, .direction = view.normal, .half_angle = frame.filtered};
    for (std::size_t i = 0; i < bent.half_angle.size(); ++i) {
        const bool surface = scene::is_surface(view.depth[i]);
        bent.direction[i] = surface ? glm::normalize(view.normal[i] + frame.bent[i]) : glm::vec3(0.0F);
        bent.half_angle[i] = surface ? std::acos(std::sqrt(frame.filtered[i])) : 0.0F;
    }
    return bent;
}

// The work of one call.
class Renderer {
  public:
    Renderer(const RenderOptions& options, const RenderInput& input, RenderBench& bench,
             const RenderOutput& output)
        : options_(options),
          input_(input),
          bench_(bench),
          output_(output),
          truth_(options, input_),
          progress_(progress_bar(input_.name + ": frames", !options.quiet)) {
        if (!options.write_gbuffer.empty()) gbuffer_out_.emplace(options.write_gbuffer);
        report_ = {.source = input_.name,
                   .name = name_of(options),
                   .preset = options.preset,
                   .truth = truth_.name(),
                   .device = bench_.device.info(),
                   .repeat = options.repeat};
    }

    Rendered run() {
        for (const int number : input_.views) render_view(number);
        if (output_.folder != nullptr)
            output_.folder->write(output_.prefix + "render.json", to_json(report_));
        if (gbuffer_out_) gbuffer_out_->keep();
        return {std::move(report_), std::move(pictures_)};
    }

  private:
    void render_view(int number) {
        scene::GBuffer wide = input_.load(bench_.device, number);  // with its guard band
        const effect::Settings settings = settings_for(options_, wide.ao_radius);
        const std::string misfit =
            before_ ? "" : scene::radius_out_of_proportion(wide, double{settings.radius});
        if (!misfit.empty()) throw std::invalid_argument(input_.name + ": " + misfit);
        const std::string coarse = before_ ? "" : scene::too_coarse_steps(wide, double{settings.radius});
        if (!coarse.empty()) fmt::print(stderr, "gloam: {}: {}\n", input_.name, coarse);
        const std::string cut = cut_before(number, wide, settings);
        if (cut.empty()) link(wide, before_->view);
        const scene::GBuffer view = scene::cropped(wide);
        const ViewTruth truth = truth_at(number, view, settings);
        if (gbuffer_out_) write_gbuffer(*gbuffer_out_, number, wide);
        if (!effect_ || before_->view.extent != wide.extent)
            effect_.emplace(bench_.device, bench_.passes, wide.extent);
        cut.empty() ? effect_->advance(wide) : effect_->begin(wide, settings);
        for (int i = 0; i < input_.frames_per_view; ++i) {
            const ViewLink linked = i > 0 ? ViewLink::same : cut.empty() ? ViewLink::follows : ViewLink::cut;
            const effect::Frame frame = effect_->next(options_.repeat);
            if (output_.folder != nullptr) write_images(*output_.folder, stem(number + i), frame);
            history_.advance(view, linked, double{settings.radius}, frame.filtered);
            FrameReport entry = entry_of(number + i, settings, frame, view);
            if (i == 0) entry.history.cut = cut;
            const bool last = i + 1 == input_.frames_per_view;
            compare(entry, view, frame, truth, last);
            if (last && is_shown(number)) show(number, number + i, view, frame, truth);
            if (last) write_directions(number + i, wide, settings, frame);
            if (output_.folder != nullptr && settings.resolution == effect::Resolution::tiles)
                write_tiles(*output_.folder, stem(number + i), frame, wide);
            report_.frames.push_back(std::move(entry));
            progress_(static_cast<double>(report_.frames.size()) / static_cast<double>(frame_count()));
        }
        before_ = Before{number, settings.radius, std::move(wide)};
    }

    // Writes the requested results besides the occlusion: bent normals, of the frame if it has some and the
    // view has normals, and light.
    void write_directions(int number, const scene::GBuffer& wide, const effect::Settings& settings,
                          const effect::Frame& frame) {
        if (output_.folder == nullptr || !(options_.bent_normals || options_.light)) return;
        if (!directional_) directional_.emplace(bench_.device, bench_.passes);
        if (options_.bent_normals)
            write_bent_normals(
                *output_.folder, stem(number),
                settings.bent_normals && !wide.normal.empty()
                    ? bent_of(frame, scene::cropped(wide))
                    : directional_->bent_normals(wide, settings, {.interleave = options_.bent_interleave}));
        if (options_.light) {
            const effect::Sky sky = *options_.light == "sky" ? effect::clear_sky : effect::Sky{};
            write_light(*output_.folder, stem(number), directional_->light(wide, settings, sky));
        }
    }

    // The reason why the view has no history; empty: it has one.
    [[nodiscard]] std::string cut_before(int number, const scene::GBuffer& view,
                                         const effect::Settings& settings) const {
        if (!before_) return "the first frame";
        if (number != before_->number + 1) return "frames are missing before it";
        if (settings.radius != before_->radius) return "the radius has changed";
        return cut_between(before_->view, view);
    }

    // Empty if the truth is unknown, or not requested for this view.
    [[nodiscard]] ViewTruth truth_at(int number, const scene::GBuffer& view,
                                     const effect::Settings& settings) {
        if (number != input_.views.back() && !truth_.every_view()) return {};
        ViewTruth truth = truth_.of(view, input_.first_frame + number, double{settings.radius});
        if (truth.traced && output_.folder != nullptr) {
            const bool only = input_.views.size() == 1 || !truth_.every_view();
            write_truth(*output_.folder, output_.prefix + (only ? "" : scene::frame_prefix(number) + "_"),
                        view.extent, *truth.traced);
        }
        return truth;
    }

    [[nodiscard]] FrameReport entry_of(int number, const effect::Settings& settings,
                                       const effect::Frame& frame, const scene::GBuffer& view) const {
        FrameReport entry{.number = number,
                          .extent = frame.extent,
                          .settings = settings,
                          .times = frame.times,
                          .tiles = shares_of(frame.tiles),
                          .samples = frame.samples,
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
    }

    // Whether there are pictures of a view: the last, and of one run all that are written.
    [[nodiscard]] bool is_shown(int number) const {
        return number == input_.views.back() || (output_.folder != nullptr && output_.prefix.empty());
    }

    // Makes the pictures of a view's last frame.
    void show(int view_number, int frame_number, const scene::GBuffer& view, const effect::Frame& frame,
              const ViewTruth& truth) {
        const bool watched = !options_.quiet && input_.views.size() == 1;
        const pictures::PictureLight& light = bench_.light_of(input_, view_number, view, watched);
        pictures_ = pictures_of(bench_.composite, stem(frame_number), light, frame.filtered, truth.truth,
                                options_.multi_bounce);
        if (output_.folder != nullptr) write_pictures(*output_.folder, pictures_);
    }

    [[nodiscard]] std::string stem(int number) const { return output_.prefix + scene::frame_prefix(number); }

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
    const RenderInput& input_;
    RenderBench& bench_;
    const RenderOutput& output_;
    TruthSource truth_;
    std::optional<record::OutputFolder> gbuffer_out_;
    std::optional<effect::AmbientOcclusion> effect_;
    std::optional<effect::Directional> directional_;
    std::optional<Before> before_;
    RenderHistory history_;
    std::function<void(double)> progress_;
    RenderReport report_;
    Pictures pictures_;  // of the last view
};

}  // namespace

RenderBench::RenderBench(const RenderOptions& options)
    : device(open_device(options.device, options.validation)),
      passes(glsl_directory(), cache_directory()),
      composite(device, passes) {}

const pictures::PictureLight& RenderBench::light_of(const RenderInput& input, int number,
                                                    const scene::GBuffer& view, bool watched) {
    if (lit_ == number) return light_;
    pictures::LightingOptions options{.frame = input.first_frame + number};
    if (watched) options.progress = progress_bar(input.name + ": light");
    // Fewer where the device has no images of that size.
    const std::uint32_t most = device.info().max_image_size / std::max(view.extent.width, view.extent.height);
    const int samples = std::min(input.picture_samples, static_cast<int>(std::max(most, 1U)));
    if (samples == 1) {
        light_ = pictures::picture_light(view, view, samples, input.scene.get(), options);
    } else {
        // As many rays as one sample would send, so that smooth edges cost little.
        options.rays = std::max(1, options.rays / (samples * samples));
        const auto side = static_cast<std::uint32_t>(samples);
        const scene::GBuffer fine =
            scene::draw(*input.scene, {view.extent.width * side, view.extent.height * side},
                        {.frame = options.frame, .color = true});
        light_ = pictures::picture_light(view, fine, samples, input.scene.get(), options);
    }
    lit_ = number;
    return light_;
}

Rendered render(const RenderOptions& options, const RenderInput& input, RenderBench& bench,
                const RenderOutput& output) {
    return Renderer(options, input, bench, output).run();
}

}  // namespace gloam::cli
