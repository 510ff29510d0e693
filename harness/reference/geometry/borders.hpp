// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline glm::ivec2 gloam_clamp_to_edge(glm::ivec2 pixel, glm::ivec2 size) {
    return clamp(pixel, glm::ivec2(0), max(size, 1) - 1);
}

inline glm::ivec2 gloam_guard_band_border(glm::ivec2 size, double guard) {
    return {glm::round(gloam_unit_interval(guard) * dvec2(max(size, 0)))};
}

inline glm::ivec2 gloam_guard_band_size(glm::ivec2 size, double guard) {
    return max(size, 0) + 2 * gloam_guard_band_border(size, guard);
}

inline dvec2 gloam_guard_band_guard(glm::ivec2 size, double guard) {
    return dvec2(gloam_guard_band_border(size, guard)) / dvec2(max(size, 1));
}

inline double gloam_guard_band_tan_half_fov(double tan_half_fov, double guard) {
    const double wider = (1.0 + 2.0 * guard) * tan_half_fov;
    return is_finite(wider) ? wider : 0.0;
}

inline dvec2 gloam_guard_band_inner_uv(dvec2 outer_uv, dvec2 guard) {
    const dvec2 uv = (1.0 + 2.0 * guard) * outer_uv - guard;
    return is_finite(uv) ? uv : dvec2(2.0);
}

inline dvec2 gloam_guard_band_outer_uv(dvec2 inner_uv, dvec2 guard) {
    const dvec2 uv = (inner_uv + guard) / (1.0 + 2.0 * guard);
    return is_finite(uv) ? uv : dvec2(2.0);
}

}  // namespace gloam::reference
