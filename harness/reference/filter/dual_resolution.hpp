// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_dual_resolution_disagrees(glm::ivec2 pixel, glm::ivec2 size, double tolerance,
                                            const Fetch<double>& fetch_occlusion) {
    double low = 1.0;
    double high = 0.0;
    const glm::ivec2 first = glm::max(pixel - 1, glm::ivec2(0));
    const glm::ivec2 last = glm::min(pixel + 1, size - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const double occlusion = fetch_occlusion(glm::ivec2(x, y));
            if (!(occlusion >= 0.0 && occlusion <= 1.0)) return true;
            low = min(low, occlusion);
            high = max(high, occlusion);
        }
    }
    return !(high - low <= tolerance);
}

}  // namespace gloam::reference
