// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_nearest_index(double u, int resolution) {
    const int last = max(resolution, 1) - 1;
    const double scaled = u * double(resolution);
    return scaled >= 1.0 ? (scaled < double(last) ? int(scaled) : last) : 0;
}

inline glm::ivec2 gloam_nearest_pixel(dvec2 uv, glm::ivec2 resolution) {
    return glm::ivec2(gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y));
}

inline dvec2 gloam_pixel_center(dvec2 uv, glm::ivec2 resolution) {
    const glm::ivec2 size(max(resolution.x, 1), max(resolution.y, 1));
    const glm::ivec2 pixel = gloam_nearest_pixel(uv, size);
    return dvec2((double(pixel.x) + 0.5) / double(size.x), (double(pixel.y) + 0.5) / double(size.y));
}

inline bool gloam_inside_unit(dvec2 uv) {
    return uv.x >= 0.0 && uv.x <= 1.0 && uv.y >= 0.0 && uv.y <= 1.0;
}

}  // namespace gloam::reference
