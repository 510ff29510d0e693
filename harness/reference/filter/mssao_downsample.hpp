// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline int gloam_depth_rank(dvec4 depths, int index) {
    const int own = std::clamp(index, 0, 3);
    int rank = 0;
    for (int i = 0; i < 4; ++i) rank += std::pair(depths[i], i) < std::pair(depths[own], own) ? 1 : 0;
    return rank;
}

// A half each for the two in the middle of the order of depth, or one for the second.
inline dvec4 gloam_mssao_weights(dvec4 depths, double tolerance) {
    std::array<std::pair<double, int>, 4> order;
    for (int i = 0; i < 4; ++i) order[i] = {gloam_is_background(depths[i]) ? infinity : depths[i], i};
    std::ranges::sort(order);
    dvec4 weights(0.0);
    if (std::isinf(order[0].first)) return weights;
    if (std::isinf(order[1].first)) {
        weights[order[0].second] = 1.0;
        return weights;
    }
    const bool together = order[3].first - order[0].first <= tolerance && is_finite(order[3].first);
    weights[order[1].second] = together ? 0.5 : 1.0;
    weights[order[2].second] = together ? 0.5 : 0.0;
    return weights;
}

inline dvec3 gloam_mssao_normal(dvec3 second, dvec3 third) {
    return gloam_safe_normalize((second + third) / 2.0, gloam_safe_normalize(second, dvec3(0.0)));
}

}  // namespace gloam::reference
