// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"

namespace gloam::reference {

template <class T>
struct GloamSlice {
    vec3<T> view;
    vec3<T> tangent;
    vec2<T> normal;
    T angle;
    T weight;
};

template <class T>
GloamSlice<T> gloam_slice(vec2<T> direction, vec3<T> view, vec3<T> normal) {
    const vec3<T> none(T(0), T(0), T(0));
    const vec3<T> along(direction.x, direction.y, T(0));
    const vec3<T> tangent = gloam_safe_normalize(along - view * dot(along, view), none);
    const T x = dot(normal, tangent);
    const T y = dot(normal, view);
    const T weight = gloam_sqrt(x * x + y * y);
    if (!(weight > T(0) && dot(tangent, tangent) > T(0.5)))
        return GloamSlice<T>{vec3<T>(T(0), T(0), T(1)), tangent, vec2<T>(T(1), T(0)), T(0), T(0)};
    const vec3<T> ahead(T(1), T(0), T(0));
    const vec3<T> projected = gloam_safe_normalize(vec3<T>(max(y, T(0)), x, T(0)), ahead);
    return GloamSlice<T>{view, tangent, vec2<T>(projected.x, projected.y),
                         gloam_atan2(projected.y, projected.x), min(weight, T(1))};
}

template <class T>
T gloam_slice_whole(GloamSlice<T> slice) {
    return slice.normal.x + slice.angle * slice.normal.y;
}

template <class T>
vec2<T> gloam_slice_direction(vec3<T> offset, GloamSlice<T> slice) {
    const vec3<T> none(T(0), T(0), T(0));
    const vec3<T> direction = gloam_safe_normalize(offset, none);
    const vec3<T> within(dot(direction, slice.view), dot(direction, slice.tangent), T(0));
    const vec3<T> unit = gloam_safe_normalize(within, none);
    return vec2<T>(unit.x, unit.y);
}

template <class T>
struct GloamSliceAxes {
    vec3<T> view;
    vec3<T> tangent;
};

// The products of the slice's vectors with offset - (offset . axis) across, as products with the offset.
template <class T>
GloamSliceAxes<T> gloam_slice_axes(GloamSlice<T> slice, vec3<T> normal) {
    const vec3<T> axis = cross(slice.tangent, slice.view);
    const T turned = dot(axis, normal);
    const T steep = T(1) - turned * turned;
    vec3<T> across = axis;
    if (steep > T(1e-3F)) across = (axis - turned * normal) / steep;
    return {slice.view - dot(across, slice.view) * axis, slice.tangent - dot(across, slice.tangent) * axis};
}

}  // namespace gloam::reference
