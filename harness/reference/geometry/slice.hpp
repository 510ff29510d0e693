// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"

namespace gloam::reference {

template <class T>
struct GloamSlice {
    vec3<T> view;
    vec3<T> tangent;
    T angle;
    T weight;
};

template <class T>
GloamSlice<T> gloam_slice(vec2<T> direction, vec3<T> view, vec3<T> normal) {
    const vec3<T> along(direction.x, direction.y, T(0));
    const vec3<T> tangent = gloam_safe_normalize(along - view * dot(along, view), vec3<T>(T(0), T(0), T(0)));
    const T x = dot(normal, tangent);
    const T y = dot(normal, view);
    const T weight = gloam_sqrt(x * x + y * y);
    if (!(weight > T(0) && dot(tangent, tangent) > T(0.5)))
        return GloamSlice<T>{vec3<T>(T(0), T(0), T(1)), tangent, T(0), T(0)};
    return GloamSlice<T>{view, tangent, clamp(gloam_atan2(x, y), T(-1.570796327), T(1.570796327)),
                         min(weight, T(1))};
}

template <class T>
T gloam_slice_angle(vec3<T> offset, GloamSlice<T> slice) {
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    return gloam_atan2(dot(direction, slice.tangent), dot(direction, slice.view));
}

}  // namespace gloam::reference
