// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

// How many of first, 2 first, 4 first... the distance reaches.
inline int gloam_depth_mip_level(double pixels, double first, int last) {
    int level = 0;
    for (int i = 0; i < std::min(last, 30) && first > 0.0; ++i)
        level += pixels >= std::ldexp(first, i) ? 1 : 0;
    return level;
}

inline glm::ivec2 gloam_depth_mip_size(glm::ivec2 size, int level) {
    return max(max(size, 1) / (1 << std::clamp(level, 0, 30)), 1);
}

inline glm::ivec2 gloam_depth_mip_pixel(glm::ivec2 tap, glm::ivec2 size, int level) {
    return clamp(tap >> std::clamp(level, 0, 30), glm::ivec2(0), gloam_depth_mip_size(size, level) - 1);
}

inline glm::ivec2 gloam_rotated_grid(glm::ivec2 pixel, glm::ivec2 size) {
    const glm::ivec2 source(2 * pixel.x + (pixel.y & 1), 2 * pixel.y + (pixel.x & 1));
    return clamp(source, glm::ivec2(0), max(size, 1) - 1);
}

// Each level takes from the one before.
inline glm::ivec2 gloam_depth_mip_source(glm::ivec2 pixel, glm::ivec2 size, int level) {
    if (level <= 0) return pixel;
    const int before = std::min(level, 30) - 1;
    return gloam_depth_mip_source(gloam_rotated_grid(pixel, gloam_depth_mip_size(size, before)), size,
                                  before);
}

}  // namespace gloam::reference
