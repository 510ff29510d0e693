// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "cli/environment.hpp"
#include "cli/framework/open_device.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "scene/draw.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

// Follows the frames of one candidate: the change of the picture from frame to frame, and the pixels that a
// temporal method treats differently.
class RenderHistory {
  public:
    std::optional<double> flicker;  // mean change at the same surface points; nullopt in the first frame

    // Takes the next frame. follows: it has a relation to the one before; again: it shows the same view.
    // Views without normals have no relation to earlier ones.
    void advance(const scene::GBuffer& view, bool follows, bool again, double radius,
                 const std::vector<float>& image) {
        flicker.reset();
        if (view.normal.empty()) return view_.reset();
        std::optional<effect::HistoryMap> history;
        if (view_ && follows) {
            history.emplace(again ? standing_still(view) : view, *view_);
            flicker = effect::mean_change(*history, image, image_);
        } else {
            classes_.emplace(effect::PixelClasses::Settings{.radius = radius});
        }
        classes_->advance(view, history);
        view_ = view;
        image_ = image;
    }

    // Of the last frame's pixels; nullptr if there was no frame before it.
    [[nodiscard]] const effect::PixelClasses* classes() const { return flicker ? &*classes_ : nullptr; }

  private:
    static scene::GBuffer standing_still(scene::GBuffer view) {
        view.motion.clear();
        view.previous_position.clear();
        view.camera.previous_view.reset();
        view.camera.previous_from_current.reset();
        return view;
    }

    std::optional<scene::GBuffer> view_;
    std::vector<float> image_;
    std::optional<effect::PixelClasses> classes_;
};

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

// The light of the view of an input that was shaded last. It does not depend on the candidate.
class Lights {
  public:
    Lights(const RenderOptions& options, const RenderInput& input, const gpu::Device& device)
        : options_(options), input_(input), device_(device) {}

    [[nodiscard]] const pictures::PictureLight& of(int number, const scene::GBuffer& view) {
        if (number_ == number) return light_;
        pictures::LightingOptions options{.frame = input_.first_frame + number};
        if (!options_.quiet && input_.views.size() == 1)
            options.progress = progress_bar(input_.name + ": light");
        // Fewer where the device has no images of that size.
        const auto most = device_.info().max_image_size / std::max(view.extent.width, view.extent.height);
        const std::uint32_t side =
            std::clamp(most, 1U, input_.scene ? static_cast<std::uint32_t>(options_.antialias) : 1U);
        // As many rays as one sample would send, so that smooth edges cost little.
        if (side > 1) options.rays = std::max(1, options.rays / static_cast<int>(side * side));
        const scene::GBuffer fine =
            side == 1 ? view
                      : scene::draw(*input_.scene, {view.extent.width * side, view.extent.height * side},
                                    {.frame = options.frame, .color = true});
        light_ = pictures::picture_light(view, fine, static_cast<int>(side), input_.scene.get(), options);
        number_ = number;
        return light_;
    }

  private:
    const RenderOptions& options_;
    const RenderInput& input_;
    const gpu::Device& device_;
    std::optional<int> number_;
    pictures::PictureLight light_;
};

// The work of one candidate.
class Renderer {
  public:
    Renderer(const RenderOptions& options, const RenderInput& input, const RenderCandidate& candidate,
             const RenderBench& bench, Lights& lights, record::OutputFolder* folder)
        : options_(options),
          input_(input),
          candidate_(candidate),
          bench_(bench),
          lights_(lights),
          folder_(folder),
          progress_(progress_bar(input_.name + ": frames", !options.quiet)) {
        if (!options.write_gbuffer.empty()) gbuffer_out_.emplace(options.write_gbuffer);
    }

    Rendered run() {
        for (const int number : input_.views) render_view(number);
        made_.name = candidate_.name;
        made_.report = report_of(options_, input_, candidate_, bench_.device.info(), made_, frames_);
        if (folder_ != nullptr)
            folder_->write(candidate_.prefix + "render.json", made_.report.dump(2) + "\n");
        if (gbuffer_out_) gbuffer_out_->keep();
        return std::move(made_);
    }

  private:
    void render_view(int number) {
        scene::GBuffer wide =
            input_.load(bench_.device, number, settings_for(options_, candidate_, 1.0));  // with guard band
        const effect::Settings settings = settings_for(options_, candidate_, wide.ao_radius);
        if (!before_) require_fitting(wide, double{settings.radius});
        const std::string cut = cut_before(number, wide, settings);
        if (cut.empty()) link(wide, before_->view);
        const scene::GBuffer view = scene::cropped(wide);
        const ViewTruth truth = truth_at(number, view, double{settings.radius});
        if (gbuffer_out_) write_gbuffer(*gbuffer_out_, number, wide);
        if (!effect_ || before_->view.extent != wide.extent)
            effect_.emplace(bench_.device, bench_.passes, wide.extent);
        cut.empty() ? effect_->advance(wide) : effect_->begin(wide, settings);
        made_.settings = settings;
        for (int i = 0; i < input_.frames_per_view; ++i) {
            made_.frame = effect_->next(options_.repeat);
            history_.advance(view, i > 0 || cut.empty(), i > 0, double{settings.radius},
                             made_.frame.filtered);
            const bool last = i + 1 == input_.frames_per_view;
            add_report(number + i, view, truth, i == 0 ? cut : "", last);
            if (last) show(number, number + i, view, truth);
            if (folder_ != nullptr) write_files(number + i, wide, last);
            progress_(static_cast<double>(frames_.size()) /
                      static_cast<double>(input_.views.size() * std::size_t(input_.frames_per_view)));
        }
        before_ = Before{number, settings.radius, std::move(wide)};
    }

    void require_fitting(const scene::GBuffer& view, double radius) const {
        const std::string misfit = scene::radius_out_of_proportion(view, radius);
        if (!misfit.empty()) throw std::invalid_argument(input_.name + ": " + misfit);
        const std::string coarse = scene::too_coarse_steps(view, radius);
        if (!coarse.empty()) fmt::print(stderr, "gloam: {}: {}\n", input_.name, coarse);
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
    [[nodiscard]] ViewTruth truth_at(int number, const scene::GBuffer& view, double radius) const {
        if (!input_.truth || (number != input_.views.back() && !input_.every_truth)) return {};
        ViewTruth truth = input_.truth(view, input_.first_frame + number, radius);
        if (truth.depth && folder_ != nullptr) {
            const bool only = input_.views.size() == 1 || !input_.every_truth;
            write_truth(*folder_, candidate_.prefix + (only ? "" : scene::frame_prefix(number) + "_"),
                        view.extent, truth);
        }
        return truth;
    }

    void add_report(int number, const scene::GBuffer& view, const ViewTruth& truth, const std::string& cut,
                    bool last) {
        nlohmann::ordered_json& report =
            frames_.emplace_back(frame_json(number, made_.settings, made_.frame, view, cut));
        const bool follows = input_.frames_per_view == 1;
        if (input_.scene) report["scene_frame"] = input_.first_frame + (follows ? number : 0);
        if (history_.flicker) report["flicker"] = *history_.flicker;
        if (truth.known.empty()) return made_.error.reset();
        add_errors(report, made_.frame, view, truth, history_.classes(), last);
        made_.error = report.at("errors").at("filtered").at("rmse").get<double>();
    }

    // Makes the pictures of a view's last frame: of the last view, and of one candidate all that are written.
    void show(int view_number, int frame_number, const scene::GBuffer& view, const ViewTruth& truth) {
        const bool all = folder_ != nullptr && candidate_.prefix.empty();
        if (view_number != input_.views.back() && !all) return;
        made_.pictures = pictures_of(bench_.composite, stem(frame_number), lights_.of(view_number, view),
                                     made_.frame.filtered, truth.known, options_.multi_bounce);
        if (folder_ != nullptr) write_pictures(*folder_, made_.pictures);
    }

    // last: of its view, with the requested results besides the occlusion: bent normals, of the frame if it
    // has some and the view has normals, and light.
    void write_files(int number, const scene::GBuffer& wide, bool last) {
        write_images(*folder_, stem(number), made_.frame);
        if (made_.settings.resolution == effect::Resolution::tiles)
            write_tiles(*folder_, stem(number), made_.frame, wide);
        if (!last || !(options_.bent_normals || options_.light)) return;
        if (!directional_) directional_.emplace(bench_.device, bench_.passes);
        if (options_.bent_normals)
            write_bent_normals(
                *folder_, stem(number),
                made_.settings.bent_normals && !wide.normal.empty()
                    ? bent_of(made_.frame, scene::cropped(wide))
                    : directional_->bent_normals(wide, made_.settings, options_.bent_interleave));
        if (options_.light)
            write_light(*folder_, stem(number),
                        directional_->light(wide, made_.settings,
                                            *options_.light == "sky" ? effect::clear_sky : effect::Sky{}));
    }

    [[nodiscard]] std::string stem(int number) const {
        return candidate_.prefix + scene::frame_prefix(number);
    }

    // The view before, with its guard band.
    struct Before {
        int number;
        float radius;
        scene::GBuffer view;
    };

    const RenderOptions& options_;
    const RenderInput& input_;
    const RenderCandidate& candidate_;
    const RenderBench& bench_;
    Lights& lights_;
    record::OutputFolder* folder_;
    std::optional<record::OutputFolder> gbuffer_out_;
    std::optional<effect::AmbientOcclusion> effect_;
    std::optional<effect::Directional> directional_;
    std::optional<Before> before_;
    RenderHistory history_;
    std::function<void(double)> progress_;
    nlohmann::ordered_json frames_ = nlohmann::ordered_json::array();
    Rendered made_;
};

}  // namespace

RenderBench::RenderBench(const RenderOptions& options)
    : device(open_device(options.device, options.validation)),
      passes(glsl_directory(), cache_directory()),
      composite(device, passes) {}

std::vector<Rendered> render(const RenderOptions& options, const RenderInput& input, const RenderBench& bench,
                             record::OutputFolder* folder) {
    std::vector<Rendered> runs;
    Lights lights(options, input, bench.device);
    for (const RenderCandidate& candidate : input.candidates)
        runs.push_back(Renderer(options, input, candidate, bench, lights, folder).run());
    return runs;
}

}  // namespace gloam::cli
