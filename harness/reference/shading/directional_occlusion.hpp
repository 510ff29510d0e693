// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_ssdo_radiance(vec3<T> radiance) {
    return map(radiance, [](const T& x) { return x > T(0) ? min(x, T(65504)) : T(0); });
}

template <class T>
vec3<T> gloam_ssdo_direct(vec3<T> direction, vec3<T> normal, vec3<T> radiance, T visibility) {
    return T(2) * gloam_unit_interval(visibility) * gloam_sample_cosine(direction, normal) *
           gloam_ssdo_radiance(radiance);
}

template <class T>
vec3<T> gloam_ssdo_bounce(vec3<T> offset, vec3<T> normal, vec3<T> sender_normal, vec3<T> radiance, T radius,
                          T least_distance, T visibility) {
    const T reach = max(gloam_length(offset), least_distance);
    const bool sized = radius >= float_min<T>() && least_distance >= float_min<T>() && reach <= T(0x1p126);
    if (!sized) return vec3<T>(T(0), T(0), T(0));
    const T ratio = min(radius / reach, T(1024));
    const T cosines = gloam_sample_cosine(offset, normal) *
                      gloam_sample_cosine(vec3<T>(-offset.x, -offset.y, -offset.z), sender_normal);
    return (T(1) - gloam_unit_interval(visibility)) * cosines * (ratio * ratio) *
           gloam_ssdo_radiance(radiance);
}

template <class T>
vec3<T> gloam_ssdo_light(vec3<T> sum, T count, vec3<T> albedo) {
    if (!(count >= T(1) && count <= T(16777216))) return vec3<T>(T(0), T(0), T(0));
    const vec3<T> inside = map(albedo, [](const T& x) { return gloam_unit_interval(x); });
    const vec3<T> mean =
        map(sum, [&](const T& x) { return (x >= T(0) && x <= float_max<T>() ? x : T(0)) / count; });
    return inside * mean;
}

}  // namespace gloam::reference
