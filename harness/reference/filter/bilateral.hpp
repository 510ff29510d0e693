// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/bilateral_weight.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline GloamWeightedMean gloam_bilateral_tap(GloamWeightedMean mean, glm::ivec2 pixel, double center,
                                             glm::ivec2 tap, glm::ivec2 size, double sigma_d, double sigma_r,
                                             const Fetch<double>& fetch_occlusion,
                                             const Fetch<double>& fetch_depth) {
    if (tap != clamp(tap, glm::ivec2(0), size - 1) || gloam_is_background(fetch_depth(tap))) return mean;
    const double weight = gloam_bilateral_weight(tap - pixel, fetch_depth(tap) - center, sigma_d, sigma_r);
    return gloam_weighted_mean_add(mean, fetch_occlusion(tap), weight);
}

// The sum over every pixel of the image that lies in the window.
inline double gloam_bilateral_filter(glm::ivec2 pixel, glm::ivec2 half_width, glm::ivec2 size, double sigma_d,
                                     double sigma_r, const Fetch<double>& fetch_occlusion,
                                     const Fetch<double>& fetch_depth) {
    const double center = fetch_depth(pixel);
    const glm::ivec2 reach = clamp(half_width, 0, 16);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    for (int i = 0; i < size.x * size.y && !gloam_is_background(center); ++i) {
        const glm::ivec2 tap(i % size.x, i / size.x);
        if (glm::abs(tap - pixel) != min(glm::abs(tap - pixel), reach)) continue;
        mean = gloam_bilateral_tap(mean, pixel, center, tap, size, sigma_d, sigma_r, fetch_occlusion,
                                   fetch_depth);
    }
    return gloam_weighted_mean_value(mean, fetch_occlusion(pixel));
}

}  // namespace gloam::reference
