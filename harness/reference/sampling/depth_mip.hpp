// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_depth_mip_level(double pixels, double first, int last) {
    int level = 0;
    if (!(first > 0.0)) return level;
    double edge = first;
    for (int i = 0; i < std::min(last, 30) && pixels >= edge; ++i) {
        edge = edge * 2.0;
        level = i + 1;
    }
    return level;
}

inline glm::ivec2 gloam_depth_mip_size(glm::ivec2 size, int level) {
    const glm::ivec2 one(1);
    return glm::max(glm::max(size, one) >> std::clamp(level, 0, 30), one);
}

inline glm::ivec2 gloam_depth_mip_pixel(glm::ivec2 tap, glm::ivec2 size, int level) {
    return glm::clamp(tap >> std::clamp(level, 0, 30), glm::ivec2(0), gloam_depth_mip_size(size, level) - 1);
}

inline glm::ivec2 gloam_rotated_grid(glm::ivec2 pixel, glm::ivec2 size) {
    const glm::ivec2 source = 2 * pixel + glm::ivec2(pixel.y & 1, pixel.x & 1);
    return glm::clamp(source, glm::ivec2(0), glm::max(size, glm::ivec2(1)) - 1);
}

inline glm::ivec2 gloam_depth_mip_source(glm::ivec2 pixel, glm::ivec2 size, int level) {
    for (int l = std::clamp(level, 0, 30); l > 0; --l) {
        pixel = gloam_rotated_grid(pixel, gloam_depth_mip_size(size, l - 1));
    }
    return pixel;
}

}  // namespace gloam::reference
