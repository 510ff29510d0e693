// SPDX-License-Identifier: MIT
#include "effect/pixel_classes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/gbuffer.hpp"

namespace gloam::effect {
namespace {

constexpr int always = 1 << 20;  // frames

using scene::is_surface;

}  // namespace

void PixelClasses::advance(const scene::GBuffer& view, const std::optional<HistoryMap>& history) {
    const std::size_t pixels = view.depth.size();
    if (history && age_.size() != pixels)
        throw std::invalid_argument("pixel classes: the size changed without a cut");
    // Pixels whose surface moved in this frame, or that showed a moving surface in the previous one.
    Mask moved(pixels, 0);
    Mask swept(pixels, 0);
    for (std::size_t i = 0; history && i < pixels; ++i) {
        moved[i] = history->moved(i) ? 1 : 0;
        swept[i] = moved[i] != 0 || moving_[i] != 0 ? 1 : 0;
    }
    const std::vector<float> distance = distance_to(swept, view.extent);
    const scene::PixelPositions positions(view);
    std::vector<int> age(pixels, 0);
    std::vector<int> calm(pixels, always);
    disoccluded_.assign(pixels, 0);
    near_moving_.assign(pixels, 0);
    settled_.assign(pixels, 0);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!is_surface(view.depth[i])) continue;
        const bool seen = history && history->seen(i);
        if (seen) {
            age[i] = std::min(always, age_[history->nearest(i)] + 1);
            calm[i] = std::min(always, calm_[history->nearest(i)] + 1);
        }
        const double reach = positions.pixels_of_length(settings_.radius, double{view.depth[i]});
        if (double{distance[i]} <= reach) calm[i] = 0;
        const bool near = calm[i] <= settings_.memory;
        disoccluded_[i] = seen ? 0 : 1;
        near_moving_[i] = seen && near ? 1 : 0;
        settled_[i] = seen && !near && age[i] >= settings_.settled_frames ? 1 : 0;
    }
    age_ = std::move(age);
    calm_ = std::move(calm);
    moving_ = std::move(moved);
}

}  // namespace gloam::effect
