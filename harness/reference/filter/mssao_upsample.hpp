// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

template <class T>
T gloam_mssao_upsample_weight(T bilinear, T depth_difference, T normal_cosine, T depth_power,
                              T normal_power) {
    const T apart = abs(depth_difference);
    const bool known =
        apart <= T(1e30) && abs(normal_cosine) >= T(0) && depth_power >= T(0) && normal_power >= T(0);
    if (!known) return T(0);
    const T depth = gloam_remap(T(1) / (T(1) + apart), T(0), T(1), depth_power);
    const T facing = gloam_unit_interval(T(0.5) * normal_cosine + T(0.5));
    const T normal = gloam_remap(facing, T(0), T(1), normal_power);
    return gloam_unit_interval(bilinear) * depth * normal;
}

}  // namespace gloam::reference
