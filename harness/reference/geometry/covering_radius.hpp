// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"
#include "reference/geometry/projected_radius.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
T gloam_covering_radius_parallel(vec3<T> position, T radius, T largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > T(0) && largest > T(0)))
        return T(0);
    const T depth = clamp(-position.z, float_min<T>(), T(0x1p126));
    const T r = radius / depth;
    return min(r, gloam_positive_length(largest));
}

template <class T>
T gloam_covering_radius_perpendicular(vec3<T> position, T radius, T largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > T(0) && largest > T(0)))
        return T(0);
    const T depth = -position.z;
    const T across = gloam_sqrt(dot(vec2<T>(position.x, position.y), vec2<T>(position.x, position.y)));
    const T along = gloam_sqrt(dot(position, position));
    const T denominator = (depth / along) * (depth - radius * (across / along));
    if (!(denominator >= float_min<T>())) return gloam_positive_length(largest);
    const T r = radius / min(denominator, T(0x1p126));
    return min(r, gloam_positive_length(largest));
}

}  // namespace gloam::reference
