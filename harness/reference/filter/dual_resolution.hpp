// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T, class Fetch>
bool gloam_dual_resolution_disagrees(glm::ivec2 pixel, glm::ivec2 size, T tolerance,
                                     Fetch&& fetch_occlusion) {
    T low = T(1);
    T high = T(0);
    const glm::ivec2 first = glm::max(pixel - 1, glm::ivec2(0));
    const glm::ivec2 last = glm::min(pixel + 1, size - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            const T occlusion = fetch_occlusion(glm::ivec2(x, y));
            if (!(occlusion >= T(0) && occlusion <= T(1))) return true;
            low = min(low, occlusion);
            high = max(high, occlusion);
        }
    }
    return !(high - low <= tolerance);
}

}  // namespace gloam::reference
