// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline bool gloam_upsample_continues(double depth, double first, double second, bool orthographic) {
    for (const double each : {depth, first, second})
        if (gloam_is_background(each)) return false;
    const double ratio =
        orthographic ? (first + second) / 2.0 / depth : (1.0 / first + 1.0 / second) / 2.0 * depth;
    return abs(ratio - 1.0) <= double{0.006F};
}

inline double gloam_upsample_nearest(double depth, glm::dvec4 depths, glm::dvec4 values) {
    int nearest = -1;
    for (int i = 0; i < 4; ++i) {
        if (gloam_is_background(depths[i])) continue;
        if (nearest < 0 || abs(depths[i] - depth) < abs(depths[nearest] - depth)) nearest = i;
    }
    return nearest < 0 ? 0.0 : values[nearest];
}

inline double gloam_upsample(double depth, glm::dvec4 depths, glm::dvec4 occlusions, bool orthographic) {
    if (gloam_is_background(depth)) return 0.0;
    double sum = 0.0;
    int pairs = 0;
    for (const auto& [a, b] : {std::pair{0, 3}, std::pair{1, 2}}) {
        if (!gloam_upsample_continues(depth, depths[a], depths[b], orthographic)) continue;
        sum += (occlusions[a] + occlusions[b]) / 2.0;
        ++pairs;
    }
    return gloam_unit_interval(pairs > 0 ? sum / pairs : gloam_upsample_nearest(depth, depths, occlusions));
}

}  // namespace gloam::reference
