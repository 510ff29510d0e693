// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

struct GloamSlice {
    dvec3 view;
    dvec3 tangent;
    dvec2 normal;
    double angle;
    double weight;
};

inline GloamSlice gloam_slice(dvec2 direction, dvec3 view, dvec3 normal) {
    const dvec3 none(0.0);
    const dvec3 along(direction.x, direction.y, 0.0);
    const dvec3 tangent = gloam_safe_normalize(along - view * dot(along, view), none);
    const double x = dot(normal, tangent);
    const double y = dot(normal, view);
    const double weight = gloam_sqrt(x * x + y * y);
    if (!(weight > 0.0 && dot(tangent, tangent) > 0.5))
        return GloamSlice{dvec3(0.0, 0.0, 1.0), tangent, dvec2(1.0, 0.0), 0.0, 0.0};
    const dvec3 ahead(1.0, 0.0, 0.0);
    const dvec3 projected = gloam_safe_normalize(dvec3(max(y, 0.0), x, 0.0), ahead);
    return GloamSlice{view, tangent, dvec2(projected.x, projected.y), gloam_atan2(projected.y, projected.x),
                      min(weight, 1.0)};
}

inline double gloam_slice_whole(GloamSlice slice) {
    return slice.normal.x + slice.angle * slice.normal.y;
}

inline dvec2 gloam_slice_direction(dvec3 offset, GloamSlice slice) {
    const dvec3 none(0.0);
    const dvec3 direction = gloam_safe_normalize(offset, none);
    const dvec3 within(dot(direction, slice.view), dot(direction, slice.tangent), 0.0);
    const dvec3 unit = gloam_safe_normalize(within, none);
    return dvec2(unit.x, unit.y);
}

struct GloamSliceAxes {
    dvec3 view;
    dvec3 tangent;
};

// The products of the slice's vectors with offset - (offset . axis) across, as products with the offset.
inline GloamSliceAxes gloam_slice_axes(GloamSlice slice, dvec3 normal) {
    const dvec3 axis = cross(slice.tangent, slice.view);
    const double turned = dot(axis, normal);
    const double steep = 1.0 - turned * turned;
    dvec3 across = axis;
    if (steep > double(1e-3F)) across = (axis - turned * normal) / steep;
    return {slice.view - dot(across, slice.view) * axis, slice.tangent - dot(across, slice.tangent) * axis};
}

}  // namespace gloam::reference
