// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline glm::ivec2 gloam_clamp_to_edge(glm::ivec2 pixel, glm::ivec2 size) {
    return glm::ivec2(clamp(pixel.x, 0, max(size.x, 1) - 1), clamp(pixel.y, 0, max(size.y, 1) - 1));
}

inline glm::ivec2 gloam_guard_band_border(glm::ivec2 size, double guard) {
    const double part = guard > 0.0 ? (guard < 1.0 ? guard : 1.0) : 0.0;
    const auto axis = [&](int extent) {
        const double width = part * double(max(extent, 0));
        const double whole = floor(width);
        return int(whole + (width - whole >= 0.5 ? 1.0 : 0.0));
    };
    return glm::ivec2(axis(size.x), axis(size.y));
}

inline glm::ivec2 gloam_guard_band_size(glm::ivec2 size, double guard) {
    const glm::ivec2 border = gloam_guard_band_border(size, guard);
    return glm::ivec2(max(size.x, 0) + 2 * border.x, max(size.y, 0) + 2 * border.y);
}

inline dvec2 gloam_guard_band_guard(glm::ivec2 size, double guard) {
    const glm::ivec2 border = gloam_guard_band_border(size, guard);
    return dvec2(double(border.x) / double(max(size.x, 1)), double(border.y) / double(max(size.y, 1)));
}

inline double gloam_guard_band_tan_half_fov(double tan_half_fov, double guard) {
    const double wider = tan_half_fov * (1.0 + 2.0 * guard);
    return gloam_is_finite(wider) ? wider : 0.0;
}

inline dvec2 gloam_guard_band_inner_uv(dvec2 outer_uv, dvec2 guard) {
    const dvec2 uv = outer_uv + guard * (2.0 * outer_uv - 1.0);
    if (gloam_is_finite2(uv)) return uv;
    return dvec2(2.0, 2.0);
}

inline dvec2 gloam_guard_band_outer_uv(dvec2 inner_uv, dvec2 guard) {
    const dvec2 uv = (inner_uv + guard) / (1.0 + 2.0 * guard);
    if (gloam_is_finite2(uv)) return uv;
    return dvec2(2.0, 2.0);
}

}  // namespace gloam::reference
