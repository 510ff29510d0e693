// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/geometry_weight.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/background.hpp"

namespace gloam::reference {

// fetch_occlusion, fetch_depth: T(glm::ivec2); fetch_normal: vec3<T>(glm::ivec2).
template <class T, class FetchOcclusion, class FetchDepth, class FetchNormal>
GloamWeightedMean<T> gloam_geometry_blur_tap(GloamWeightedMean<T> mean, T center, vec3<T> normal,
                                             glm::ivec2 tap, glm::ivec2 size, vec2<T> powers,
                                             FetchOcclusion&& fetch_occlusion, FetchDepth&& fetch_depth,
                                             FetchNormal&& fetch_normal) {
    if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) return mean;
    const T depth = fetch_depth(tap);
    if (gloam_is_background(depth)) return mean;
    const T weight = gloam_geometry_weight(normal, fetch_normal(tap), center - depth, powers.x, powers.y);
    return gloam_weighted_mean_add(mean, fetch_occlusion(tap), weight);
}

template <class T, class FetchOcclusion, class FetchDepth, class FetchNormal>
T gloam_geometry_blur(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width, vec2<T> powers,
                      FetchOcclusion&& fetch_occlusion, FetchDepth&& fetch_depth,
                      FetchNormal&& fetch_normal) {
    const T own = fetch_occlusion(pixel);
    const T center = fetch_depth(pixel);
    GloamWeightedMean<T> mean = gloam_weighted_mean_empty<T>();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    const vec3<T> normal = fetch_normal(pixel);
    mean = gloam_weighted_mean_add(mean, own, T(1));
    const auto add = [&](glm::ivec2 tap) {
        mean = gloam_geometry_blur_tap(mean, center, normal, tap, size, powers, fetch_occlusion, fetch_depth,
                                       fetch_normal);
    };
    const int last = min(half_width, 64);
    for (int i = 1; i <= last; ++i) {
        add(pixel - i * axis);
        add(pixel + i * axis);
    }
    return gloam_weighted_mean_value(mean, own);
}

}  // namespace gloam::reference
