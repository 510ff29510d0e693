// SPDX-License-Identifier: MIT
#include "experiment/benchmark_views.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace gloam::experiment {

BenchmarkViews::BenchmarkViews(const gpu::Device& device, const scene::PassLibrary& passes,
                               scene::Scene scene, const BenchmarkFrames& frames,
                               const scene::TruthCache& cache, const std::function<void(double)>& progress)
    : device_(&device), passes_(passes), scene_(std::move(scene)), frames_(frames) {
    if (frames.scored < 1 || frames.scored > frames.frames) {
        throw std::invalid_argument(fmt::format("{} scored frames of {}: expected 1 to {}", frames.scored,
                                                frames.frames, frames.frames));
    }
    for (std::size_t i = 0; i < frames.shown.size(); ++i)
        numbers_.insert(numbers_.end(), static_cast<std::size_t>(frames.shown[i]), static_cast<int>(i));
    for (int i = 0; frames.shown.empty() && i < frames.frames; ++i) numbers_.push_back(i);
    if (frames.rays == 0) return;
    const scene::TruthSettings traced{.rays = {.radius = scene_.ao_radius, .rays = frames.rays},
                                      .thickness = frames.depth_thickness * scene_.ao_radius};
    for (int i = first_scored(); i < frames.frames; ++i) {
        const scene::GBuffer& view = this->view(i, {});
        ScoredFrame truth{.geometry =
                              effect::truth_from(view, cache.geometry(scene_, i, view, traced).occlusion)};
        if (frames.depth_truth) truth.depth = effect::truth_from(view, cache.depth(view, traced).occlusion);
        if (i > 0 && is_new(i)) truth.history.emplace(view, this->view(i - 1, {}));
        scored_.push_back(std::move(truth));
        if (progress) progress(static_cast<double>(scored_.size()) / static_cast<double>(frames.scored));
    }
}

const scene::GBuffer& BenchmarkViews::view(int frame, const effect::Settings& settings) {
    return views_with(double{settings.guard}, static_cast<int>(settings.layers))
        .at(static_cast<std::size_t>(numbers_.at(static_cast<std::size_t>(frame))));
}

bool BenchmarkViews::is_new(int frame) const {
    const auto at = static_cast<std::size_t>(frame);
    return frame == 0 || numbers_.at(at) != numbers_.at(at - 1);
}

const ScoredFrame& BenchmarkViews::scored(int frame) const {
    return scored_.at(static_cast<std::size_t>(frame - first_scored()));
}

std::vector<scene::GBuffer>& BenchmarkViews::views_with(double guard, int layers) {
    std::vector<scene::GBuffer>& views = views_[{guard, layers}];
    for (int i = static_cast<int>(views.size()); i <= numbers_.back(); ++i) {
        views.push_back(scene::rasterize(*device_, passes_, scene_, frames_.extent,
                                         {.frame = frames_.still ? 0 : i,
                                          .motion = frames_.motion && !scene_.objects.empty(),
                                          .layers = layers,
                                          .guard = guard}));
        if (frames_.edit) frames_.edit(views.back(), i);
    }
    return views;
}

}  // namespace gloam::experiment
