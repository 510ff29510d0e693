// SPDX-License-Identifier: MIT
#include "effect/study/benchmark_views.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace gloam::effect {

BenchmarkViews::BenchmarkViews(const gpu::Device& device, const scene::PassLibrary& passes,
                               scene::Scene scene, const BenchmarkFrames& frames,
                               const scene::TruthCache& cache, const std::function<void(double)>& progress)
    : device_(&device), passes_(passes), scene_(std::move(scene)), frames_(frames) {
    if (frames.scored < 1 || frames.scored > frames.frames) {
        throw std::invalid_argument(fmt::format("{} scored frames of {}: expected 1 to {}", frames.scored,
                                                frames.frames, frames.frames));
    }
    const std::vector<scene::GBuffer>& views = views_with(0.0, 1);
    const scene::TruthSettings traced{.rays = {.radius = scene_.ao_radius, .rays = frames.rays},
                                      .thickness = frames.depth_thickness * scene_.ao_radius};
    for (int i = first_scored(); i < frames.frames; ++i) {
        const scene::GBuffer& view = views[static_cast<std::size_t>(i)];
        ScoredFrame truth{.geometry = truth_from(view, cache.geometry(scene_, i, view, traced).occlusion)};
        if (frames.depth_truth) truth.depth = truth_from(view, cache.depth(view, traced).occlusion);
        if (i > 0) truth.history.emplace(view, views[static_cast<std::size_t>(i) - 1]);
        scored_.push_back(std::move(truth));
        if (progress) progress(static_cast<double>(scored_.size()) / static_cast<double>(frames.scored));
    }
}

const scene::GBuffer& BenchmarkViews::view(int frame, const Settings& settings) {
    return views_with(double{settings.guard}, static_cast<int>(settings.layers))
        .at(static_cast<std::size_t>(frame));
}

const ScoredFrame& BenchmarkViews::scored(int frame) const {
    return scored_.at(static_cast<std::size_t>(frame - first_scored()));
}

std::vector<scene::GBuffer>& BenchmarkViews::views_with(double guard, int layers) {
    std::vector<scene::GBuffer>& views = views_[{guard, layers}];
    for (int i = static_cast<int>(views.size()); i < frames_.frames; ++i) {
        views.push_back(scene::rasterize(
            *device_, passes_, scene_, frames_.extent,
            {.frame = i, .motion = !scene_.objects.empty(), .layers = layers, .guard = guard}));
    }
    return views;
}

}  // namespace gloam::effect
