// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/bilateral_weight.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/background.hpp"

namespace gloam::reference {

// fetch_occlusion, fetch_depth: double(glm::ivec2).
inline GloamWeightedMean gloam_bilateral_tap(GloamWeightedMean mean, glm::ivec2 pixel, double center,
                                             glm::ivec2 tap, glm::ivec2 size, double sigma_d, double sigma_r,
                                             const Fetch<double>& fetch_occlusion,
                                             const Fetch<double>& fetch_depth) {
    if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) return mean;
    const double depth = fetch_depth(tap);
    if (gloam_is_background(depth)) return mean;
    const dvec2 offset(double(tap.x - pixel.x), double(tap.y - pixel.y));
    const double weight = gloam_bilateral_weight(offset, depth - center, sigma_d, sigma_r);
    return gloam_weighted_mean_add(mean, fetch_occlusion(tap), weight);
}

inline double gloam_bilateral_filter(glm::ivec2 pixel, glm::ivec2 half_width, glm::ivec2 size, double sigma_d,
                                     double sigma_r, const Fetch<double>& fetch_occlusion,
                                     const Fetch<double>& fetch_depth) {
    const double own = fetch_occlusion(pixel);
    const double center = fetch_depth(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    const glm::ivec2 reach(clamp(half_width.x, 0, 16), clamp(half_width.y, 0, 16));
    for (int y = -reach.y; y <= reach.y; ++y) {
        for (int x = -reach.x; x <= reach.x; ++x) {
            mean = gloam_bilateral_tap(mean, pixel, center, pixel + glm::ivec2(x, y), size, sigma_d, sigma_r,
                                       fetch_occlusion, fetch_depth);
        }
    }
    return gloam_weighted_mean_value(mean, own);
}

}  // namespace gloam::reference
