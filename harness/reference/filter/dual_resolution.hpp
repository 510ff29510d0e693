// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_dual_resolution_disagrees(glm::ivec2 pixel, glm::ivec2 size, double tolerance,
                                            const Fetch<double>& fetch_occlusion) {
    double low = 1.0;
    double high = 0.0;
    for (int i = 0; i < 9; ++i) {
        const glm::ivec2 at = pixel + glm::ivec2(i % 3, i / 3) - 1;
        if (at != clamp(at, glm::ivec2(0), size - 1)) continue;
        const double occlusion = fetch_occlusion(at);
        if (!(occlusion >= 0.0 && occlusion <= 1.0)) return true;
        low = min(low, occlusion);
        high = max(high, occlusion);
    }
    return !(high - low <= tolerance);
}

}  // namespace gloam::reference
