// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
T gloam_neighborhood_change(vec3<T> sample_position, vec3<T> position, vec3<T> previous_sample,
                            vec3<T> previous_position) {
    vec3<T> a = sample_position - position;
    vec3<T> b = previous_sample - previous_position;
    if (!(gloam_is_finite3(a) && gloam_is_finite3(b))) return float_max<T>();
    const vec3<T> bounds = max(abs(a), abs(b));
    const T largest = max(max(bounds.x, bounds.y), bounds.z);
    if (!(largest >= float_min<T>())) return T(0);
    const T scale = detail::squarable_scale(largest);
    a = a * scale;
    b = b * scale;
    const T sum = gloam_sqrt(dot(a, a)) + gloam_sqrt(dot(b, b));
    return min(abs(dot(a - b, a + b)) / sum / scale, float_max<T>());
}

template <class T>
bool gloam_neighborhood_unchanged(T change, T epsilon) {
    return change < epsilon;
}

template <class T>
bool gloam_probe_useful(vec3<T> offset, vec3<T> normal) {
    return gloam_is_finite3(offset) && dot(offset, normal) > T(0);
}

}  // namespace gloam::reference
