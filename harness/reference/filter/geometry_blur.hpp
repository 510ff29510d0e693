// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/geometry_weight.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/background.hpp"

namespace gloam::reference {

// fetch_occlusion, fetch_depth: double(glm::ivec2); fetch_normal: dvec3(glm::ivec2).
inline GloamWeightedMean gloam_geometry_blur_tap(GloamWeightedMean mean, double center, dvec3 normal,
                                                 glm::ivec2 tap, glm::ivec2 size, dvec2 powers,
                                                 const Fetch<double>& fetch_occlusion,
                                                 const Fetch<double>& fetch_depth,
                                                 const Fetch<dvec3>& fetch_normal) {
    if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) return mean;
    const double depth = fetch_depth(tap);
    if (gloam_is_background(depth)) return mean;
    const double weight =
        gloam_geometry_weight(normal, fetch_normal(tap), center - depth, powers.x, powers.y);
    return gloam_weighted_mean_add(mean, fetch_occlusion(tap), weight);
}

inline double gloam_geometry_blur(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                  dvec2 powers, const Fetch<double>& fetch_occlusion,
                                  const Fetch<double>& fetch_depth, const Fetch<dvec3>& fetch_normal) {
    const double own = fetch_occlusion(pixel);
    const double center = fetch_depth(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    const dvec3 normal = fetch_normal(pixel);
    mean = gloam_weighted_mean_add(mean, own, 1.0);
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
