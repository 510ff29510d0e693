// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline int gloam_depth_rank(dvec4 depths, int index) {
    const int own = std::clamp(index, 0, 3);
    const double depth = depths[own];
    int rank = 0;
    for (int i = 0; i < 4; ++i) {
        if (depths[i] < depth || (depths[i] == depth && i < own)) ++rank;
    }
    return rank;
}

inline dvec4 gloam_mssao_weights(dvec4 depths, double tolerance) {
    dvec4 weights(0.0, 0.0, 0.0, 0.0);
    dvec4 d = depths;
    int surfaces = 0;
    for (int i = 0; i < 4; ++i) {
        const bool background = gloam_is_background(depths[i]);
        if (background) d[i] = gloam_background_depth();
        if (!background) ++surfaces;
    }
    if (surfaces == 0) return weights;
    const int chosen = surfaces == 1 ? 0 : 1;
    const double nearest = min(min(d.x, d.y), min(d.z, d.w));
    const double farthest = max(max(d.x, d.y), max(d.z, d.w));
    const bool together = surfaces == 4 && farthest - nearest <= tolerance;
    for (int i = 0; i < 4; ++i) {
        const int rank = gloam_depth_rank(d, i);
        const bool taken = rank == chosen || (together && rank == 2);
        weights[i] = taken ? (together ? 0.5 : 1.0) : 0.0;
    }
    return weights;
}

inline dvec3 gloam_mssao_normal(dvec3 second, dvec3 third) {
    const dvec3 alone = gloam_safe_normalize(second, dvec3(0.0));
    return gloam_safe_normalize(0.5 * (second + third), alone);
}

}  // namespace gloam::reference
