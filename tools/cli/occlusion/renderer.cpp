// SPDX-License-Identifier: MIT
#include "cli/occlusion/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cli/environment.hpp"
#include "cli/occlusion/settings.hpp"
#include "cli/progress.hpp"
#include "scene/draw.hpp"
#include "scene/read_gbuffer.hpp"

namespace gloam::cli {
namespace {

scene::GBuffer standing_still(scene::GBuffer view) {
    view.motion.clear();
    view.previous_position.clear();
    view.camera.previous_view.reset();
    view.camera.previous_from_current.reset();
    return view;
}

// Takes the next frame. previous: the view of the frame before, which may be this one; nullptr: there is
// none. Views without normals have no relation to others.
void follow(FrameChange& change, const ShadedView& shown, const scene::GBuffer* previous,
            const std::vector<float>& image, const std::vector<float>& image_before) {
    change.flicker.reset();
    const scene::GBuffer& view = shown.view;
    if (view.normal.empty()) return;
    std::optional<effect::HistoryMap> history;
    if (previous != nullptr && !previous->normal.empty()) {
        history.emplace(previous == &view ? standing_still(view) : view, *previous);
        change.flicker = effect::mean_change(*history, image, image_before);
    } else {
        change.classes.emplace(effect::PixelClasses::Settings{.radius = double{shown.settings.radius}});
    }
    change.classes->advance(view, history);
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

void require_fitting(const std::string& name, const scene::GBuffer& view, double radius) {
    const std::string misfit = scene::radius_out_of_proportion(view, radius);
    if (!misfit.empty()) throw std::invalid_argument(name + ": " + misfit);
    const std::string coarse = scene::too_coarse_steps(view, radius);
    if (!coarse.empty()) fmt::print(stderr, "gloam: {}: {}\n", name, coarse);
}

// The reason why the view has no history; empty: it has one.
std::string cut_before(const ShadedView& shown, const std::optional<ShadedView>& before) {
    if (!before) return "the first frame";
    if (shown.number != before->number + 1) return "frames are missing before it";
    if (shown.settings.radius != before->settings.radius) return "the radius has changed";
    return cut_between(before->wide, shown.wide);
}

// Renders an input with one candidate after the other.
class Renderer {
  public:
    Renderer(const RenderOptions& options, const RenderInput& input, const backend::vulkan::Device& device,
             record::OutputFolder* folder)
        : options_(options), input_(input), device_(device), folder_(folder) {
        if (!options.write_gbuffer.empty()) gbuffer_out_.emplace(options.write_gbuffer);
    }

    Rendered render(const RenderCandidate& candidate) {
        Rendered made{.name = candidate.name};
        nlohmann::ordered_json frames = nlohmann::ordered_json::array();
        std::optional<effect::AmbientOcclusion> effect;
        std::optional<ShadedView> before;
        FrameChange change;
        const auto progress = progress_bar(input_.name + ": frames", !options_.quiet);
        for (const int number : input_.views) {
            ShadedView shown = next_view(number, candidate, before);
            if (!effect) effect.emplace(device_, passes_);
            shown.cut.empty() ? effect->advance(shown.wide) : effect->begin(shown.wide, shown.settings);
            made.settings = shown.settings;
            const scene::GBuffer* previous = shown.cut.empty() ? &before->view : nullptr;
            for (int i = 0; i < input_.frames_per_view; ++i) {
                const std::vector<float> image_before = std::move(made.frame.filtered);
                made.frame = effect->next(options_.repeat);
                follow(change, shown, previous, made.frame.filtered, image_before);
                previous = &shown.view;
                frames.push_back(frame_json(input_, shown, i, made.frame, change));
                show(candidate, shown, i, made);
                progress(static_cast<double>(frames.size()) /
                         static_cast<double>(input_.views.size() * std::size_t(input_.frames_per_view)));
            }
            before = std::move(shown);
        }
        if (frames.back().contains("errors"))
            made.error = frames.back()["errors"]["filtered"]["rmse"].get<double>();
        made.report = report_of(options_, input_, candidate, device_.info(), made, frames);
        if (folder_ != nullptr) folder_->write(candidate.prefix + "render.json", made.report.dump(2) + "\n");
        if (gbuffer_out_) gbuffer_out_->keep();
        return made;
    }

  private:
    ShadedView next_view(int number, const RenderCandidate& candidate,
                         const std::optional<ShadedView>& before) {
        ShadedView shown{.number = number};
        shown.wide = input_.load(device_, number, settings_for(candidate, 1.0));
        shown.settings = settings_for(candidate, shown.wide.ao_radius);
        const double radius{shown.settings.radius};
        if (!before) require_fitting(input_.name, shown.wide, radius);
        shown.cut = cut_before(shown, before);
        if (shown.cut.empty()) link(shown.wide, before->wide);
        shown.view = scene::cropped(shown.wide);
        if (input_.truth && (number == input_.views.back() || input_.every_truth))
            input_.truth(shown, input_.first_frame + number, folder_ != nullptr);
        if (shown.depth && folder_ != nullptr) {
            const bool only = input_.views.size() == 1 || !input_.every_truth;
            const std::string prefix = candidate.prefix + (only ? "" : scene::frame_prefix(number) + "_");
            write_truth(*folder_, prefix, shown);
        }
        if (gbuffer_out_) write_gbuffer(*gbuffer_out_, number, shown.wide);
        return shown;
    }

    // Makes the pictures and files of a view's i-th frame. Its last frame is lit: that of the last view, and
    // of each view where a single candidate is written. What is asked for besides the occlusion is written of
    // each view's last frame.
    void show(const RenderCandidate& candidate, const ShadedView& shown, int i, Rendered& made) {
        const bool last = i + 1 == input_.frames_per_view;
        const bool alone = folder_ != nullptr && candidate.prefix.empty();
        const std::string stem = candidate.prefix + scene::frame_prefix(shown.number + i);
        const bool lit = last && (alone || shown.number == input_.views.back());
        if (!lit && folder_ == nullptr) return;
        const base::RgbBytes tiles = tinted_tiles(shown, made.frame);
        if (lit) {
            made.pictures = pictures_of(composite_, stem, light_of(shown), made.frame.filtered, shown.truth,
                                        options_.multi_bounce);
            made.pictures.tiles = tiles;
        }
        if (folder_ == nullptr) return;
        write_frame(*folder_, stem, made.frame, tiles);
        if (made.pictures.name == stem) write_pictures(*folder_, made.pictures);
        if (!last || !(candidate.bent_normals || options_.light)) return;
        if (!directional_) directional_.emplace(device_, passes_);
        // The frame's own if it has some and the view has normals.
        if (candidate.bent_normals)
            write_bent(
                *folder_, stem,
                shown.settings.bent_normals && !shown.wide.normal.empty()
                    ? bent_of(made.frame, shown.view)
                    : directional_->bent_normals(shown.wide, shown.settings, candidate.bent_interleave));
        if (options_.light)
            write_light(*folder_, stem,
                        directional_->light(shown.wide, shown.settings,
                                            *options_.light == "sky" ? effect::clear_sky : effect::Sky{}));
    }

    // The light of a view. It does not depend on the candidate.
    [[nodiscard]] const pictures::PictureLight& light_of(const ShadedView& shown) {
        if (light_number_ == shown.number) return light_;
        const scene::GBuffer& view = shown.view;
        pictures::LightingOptions lighting{.frame = input_.first_frame + shown.number};
        if (!options_.quiet && input_.views.size() == 1)
            lighting.progress = progress_bar(input_.name + ": light");
        // Fewer samples where the device has no images of that size.
        const auto most = device_.info().max_image_size / std::max(view.extent.width, view.extent.height);
        const std::uint32_t side =
            std::clamp(most, 1U, input_.scene ? static_cast<std::uint32_t>(options_.antialias) : 1U);
        // As many rays as one sample would send, so that smooth edges cost little.
        if (side > 1) lighting.rays = std::max(1, lighting.rays / static_cast<int>(side * side));
        const scene::GBuffer fine =
            side == 1 ? view
                      : scene::draw(*input_.scene, {view.extent.width * side, view.extent.height * side},
                                    {.frame = lighting.frame, .color = true});
        light_ = pictures::picture_light(view, fine, static_cast<int>(side), input_.scene.get(), lighting);
        light_number_ = shown.number;
        return light_;
    }

    const RenderOptions& options_;
    const RenderInput& input_;
    const backend::vulkan::Device& device_;
    record::OutputFolder* folder_;
    std::optional<record::OutputFolder> gbuffer_out_;
    scene::PassLibrary passes_{glsl_directory(), cache_directory()};
    effect::Composite composite_{device_, passes_};
    std::optional<effect::Directional> directional_;
    std::optional<int> light_number_;  // of the view that was lit last
    pictures::PictureLight light_;     // of it
};

}  // namespace

std::vector<Rendered> render(const RenderOptions& options, const RenderInput& input,
                             const backend::vulkan::Device& device, record::OutputFolder* folder) {
    Renderer renderer(options, input, device, folder);
    std::vector<Rendered> runs;
    for (const RenderCandidate& candidate : input.candidates) runs.push_back(renderer.render(candidate));
    return runs;
}

}  // namespace gloam::cli
