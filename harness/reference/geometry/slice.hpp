// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/into_slice.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

struct GloamSlice {
    dvec3 view;
    dvec3 tangent;
    dvec2 normal;
    double angle;
    double weight;
};

// The normal's part in the plane of the view vector and the direction, by its length and its angle.
inline GloamSlice gloam_slice(dvec2 direction, dvec3 view, dvec3 normal) {
    const dvec3 along(direction, 0.0);
    const dvec3 tangent = gloam_safe_normalize(along - dot(along, view) * view, dvec3(0.0));
    const dvec2 part(dot(normal, view), dot(normal, tangent));
    const double weight = length(part);
    if (!(weight >= float_min && tangent != dvec3(0.0)))
        return {dvec3(0.0, 0.0, 1.0), tangent, {1.0, 0.0}, 0.0, 0.0};
    const dvec3 ahead = gloam_safe_normalize({max(part.x, 0.0), part.y, 0.0}, {1.0, 0.0, 0.0});
    const double angle = std::atan2(ahead.y, ahead.x);
    return {view, tangent, on_circle(angle), angle, min(weight, 1.0)};
}

inline double gloam_slice_whole(const GloamSlice& slice) {
    return cos(slice.angle) + slice.angle * sin(slice.angle);
}

inline dvec2 gloam_slice_direction(dvec3 offset, const GloamSlice& slice) {
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    const dvec3 within(dot(direction, slice.view), dot(direction, slice.tangent), 0.0);
    return gloam_safe_normalize(within, dvec3(0.0));
}

struct GloamSliceAxes {
    dvec3 view;
    dvec3 tangent;
};

// Such that offset . axes = gloam_into_slice(offset) . slice.
inline GloamSliceAxes gloam_slice_axes(const GloamSlice& slice, dvec3 normal) {
    const dvec3 axis = cross(slice.tangent, slice.view);
    const dvec3 across = along_tangent_plane(axis, normal);
    return {slice.view - dot(across, slice.view) * axis, slice.tangent - dot(across, slice.tangent) * axis};
}

}  // namespace gloam::reference
