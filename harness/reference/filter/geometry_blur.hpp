// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/filter/geometry_weight.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline GloamWeightedMean gloam_geometry_blur_tap(GloamWeightedMean mean, double center, dvec3 normal,
                                                 glm::ivec2 tap, glm::ivec2 size, dvec2 powers,
                                                 const Fetch<double>& fetch_occlusion,
                                                 const Fetch<double>& fetch_depth,
                                                 const Fetch<dvec3>& fetch_normal) {
    if (tap != clamp(tap, glm::ivec2(0), size - 1) || gloam_is_background(fetch_depth(tap))) return mean;
    const double apart = center - fetch_depth(tap);
    return gloam_weighted_mean_add(
        mean, fetch_occlusion(tap),
        gloam_geometry_weight(normal, fetch_normal(tap), apart, powers.x, powers.y));
}

// The sum over the window, the pixel itself with weight 1.
inline double gloam_geometry_blur(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                  dvec2 powers, const Fetch<double>& fetch_occlusion,
                                  const Fetch<double>& fetch_depth, const Fetch<dvec3>& fetch_normal) {
    const double own = fetch_occlusion(pixel);
    const double center = fetch_depth(pixel);
    if (gloam_is_background(center)) return gloam_unit_interval(own);
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own, 1.0);
    const int reach = std::min(half_width, 64);
    for (int i = -reach; i <= reach; ++i) {
        if (i != 0)
            mean = gloam_geometry_blur_tap(mean, center, fetch_normal(pixel), pixel + i * axis, size, powers,
                                           fetch_occlusion, fetch_depth, fetch_normal);
    }
    return gloam_weighted_mean_value(mean, own);
}

}  // namespace gloam::reference
