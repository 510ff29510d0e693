// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

template <class T>
T gloam_lifted_cosine(vec3<T> offset, vec3<T> normal, vec3<T> view) {
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    const T above = dot(direction, normal);
    const vec3<T> lifted = above < T(0) ? vec3<T>(direction - normal * above) : direction;
    const T squared = dot(lifted, lifted);
    if (!(squared > T(1e-10))) return T(0);
    const T cosine = dot(view, lifted) * inversesqrt(squared);
    return abs(cosine) <= T(1) ? cosine : (cosine > T(1) ? T(1) : (cosine < T(-1) ? T(-1) : T(0)));
}

template <class T>
bool gloam_sample_near(vec3<T> offset, T range) {
    return offset.z <= range;
}

template <class T>
vec3<T> gloam_angle_pair(vec3<T> first, vec3<T> second, vec3<T> normal, vec3<T> view, T range) {
    const bool a = gloam_sample_near(first, range);
    const bool b = gloam_sample_near(second, range);
    if (a && b)
        return vec3<T>(gloam_lifted_cosine(first, normal, view), gloam_lifted_cosine(second, normal, view),
                       T(1));
    if (!a && !b) return vec3<T>(T(0), T(0), T(0));
    const T valid = gloam_lifted_cosine(a ? first : second, normal, view);
    const T mirrored =
        gloam_unit_interval(-dot(view, gloam_safe_normalize(a ? first : second, vec3<T>(T(0), T(0), T(0)))));
    return a ? vec3<T>(valid, mirrored, T(0.5)) : vec3<T>(mirrored, valid, T(0.5));
}

template <class T>
vec2<T> gloam_angle_add(vec2<T> accumulated, T weight, T angles) {
    const T occluded = T(1) - angles * T(0.3183098862);
    if (!(weight > T(0) && weight <= float_max<T>() && abs(occluded) <= float_max<T>())) return accumulated;
    return accumulated + vec2<T>(occluded, T(1)) * weight;
}

template <class T>
T gloam_angle_occlusion(vec2<T> accumulated) {
    if (!(accumulated.x > T(0) && accumulated.y >= T(1e-4) && accumulated.y <= T(0x1p126))) return T(0);
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, T(1)) : T(1);
}

template <class T>
T gloam_contribution_unreal(vec3<T> offset, vec3<T> normal, T scale) {
    const T squared = dot(offset, offset);
    const T above = dot(offset, normal);
    if (!(above > T(0) && scale > T(0) && squared >= float_min<T>() && squared <= T(0x1p126))) return T(0);
    return gloam_unit_interval(scale * (above / squared));
}

template <class T>
T gloam_unreal_side(T occlusion) {
    const T open = T(1) - gloam_unit_interval(occlusion);
    return open * open;
}

template <class T>
T gloam_unreal_visibility(T ao, T power, T intensity) {
    const T visibility = T(1) - (T(1) - gloam_remap(ao, T(0), T(1), power)) * intensity;
    return visibility < T(1) ? (visibility > T(0) ? visibility : T(0)) : T(1);
}

}  // namespace gloam::reference
