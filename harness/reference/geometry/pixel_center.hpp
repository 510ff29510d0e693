// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_nearest_index(double u, int resolution) {
    if (std::isnan(u)) return 0;
    return int(clamp(floor(u * resolution), 0.0, max(resolution, 1) - 1.0));
}

inline glm::ivec2 gloam_nearest_pixel(dvec2 uv, glm::ivec2 resolution) {
    return {gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y)};
}

inline dvec2 gloam_pixel_center(dvec2 uv, glm::ivec2 resolution) {
    const glm::ivec2 size = max(resolution, 1);
    return (dvec2(gloam_nearest_pixel(uv, size)) + 0.5) / dvec2(size);
}

inline bool gloam_inside_unit(dvec2 uv) {
    return uv == clamp(uv, 0.0, 1.0);
}

}  // namespace gloam::reference
