// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_contribution_crytek(double sample_depth, double buffer_depth) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return 0.0;
    return buffer_depth <= sample_depth ? 1.0 : 0.0;
}

inline double gloam_contribution_crytek_buffer(double sample_value, double buffer_value) {
    return buffer_value < 1.0 && buffer_value <= sample_value ? 1.0 : 0.0;
}

inline dvec3 gloam_crytek_sample(dvec2 uv, double buffer_value, dvec3 s, double radius, double depth,
                                 double z_far) {
    const dvec3 center(uv, buffer_value);
    if (gloam_is_background(depth) || !(z_far >= 1e-30 && z_far <= 0x1p126)) return center;
    return center + radius / depth * s * dvec3(1.0, 1.0, 100.0 / z_far * buffer_value);
}

}  // namespace gloam::reference
