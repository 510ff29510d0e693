// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/sampling/depth_mip.hpp"

namespace gloam::reference {

inline constexpr int gloam_last_tap_level = 5;

inline glm::ivec2 gloam_tap_pixel(glm::ivec2 at, glm::ivec2 center, glm::ivec2 size, double mip_distance) {
    const glm::ivec2 apart = glm::abs(at - center);
    const int level = gloam_depth_mip_level(std::max(apart.x, apart.y), mip_distance, gloam_last_tap_level);
    return level == 0 ? at : gloam_depth_mip_source(gloam_depth_mip_pixel(at, size, level), size, level);
}

}  // namespace gloam::reference
