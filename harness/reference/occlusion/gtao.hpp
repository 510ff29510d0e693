// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

inline double gloam_gtao_horizon(double horizon, double lowest, dvec3 offset, dvec3 view, double weight) {
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    if (!(weight > 0.0 && dot(direction, direction) > 0.5)) return horizon;
    const double cosine = lowest + (dot(direction, view) - lowest) * min(weight, 1.0);
    return cosine > horizon ? min(cosine, 1.0) : horizon;
}

inline dvec2 gloam_gtao_lowest(GloamSlice slice) {
    return dvec2(slice.normal.y, -slice.normal.y);
}

inline double gloam_gtao_elevation(double horizon, double angle) {
    const double e = 1.570796327 + angle - gloam_acos(horizon);
    return e > 0.0 ? min(e, 3.141592654) : 0.0;
}

inline double gloam_gtao_inner(double horizon, double angle) {
    const dvec2 n = gloam_sincos(angle);
    const double visible = 0.25 * (n.x - gloam_sincos(2.0 * horizon - angle).x + 2.0 * horizon * n.y);
    return visible > 0.0 ? min(visible, 1.570796327) : 0.0;
}

inline double gloam_gtao_arc(double elevation, dvec2 horizon, dvec2 normal) {
    if (!(elevation > 0.0)) return 0.0;
    const double arc = 0.5 * (min(elevation, 3.141592654) * normal.y + horizon.x * dot(horizon, normal));
    return arc > 0.0 ? min(arc, 1.570796327) : 0.0;
}

inline double gloam_gtao_arc_uniform(double horizon, double sine) {
    const double arc = 0.5 * (sine + horizon);
    return arc > 0.0 ? min(arc, 1.0) : 0.0;
}

inline double gloam_gtao_side(double horizon, double angle, dvec2 normal) {
    const double c = horizon > -1.0 ? min(horizon, 1.0) : -1.0;
    const double s = gloam_sqrt((1.0 - c) * (1.0 + c));
    return gloam_gtao_arc(gloam_gtao_elevation(c, angle), dvec2(c, s), normal);
}

inline dvec2 gloam_gtao_add(dvec2 accumulated, GloamSlice slice, dvec2 horizons) {
    if (!(slice.weight > 0.0 && slice.weight <= float_max)) return accumulated;
    const double occluded =
        gloam_gtao_side(horizons.x, -slice.angle, dvec2(slice.normal.x, -slice.normal.y)) +
        gloam_gtao_side(horizons.y, slice.angle, slice.normal);
    return accumulated + dvec2(occluded, gloam_slice_whole(slice)) * slice.weight;
}

inline dvec2 gloam_gtao_add_uniform(dvec2 accumulated, GloamSlice slice, dvec2 horizons) {
    if (!(slice.weight > 0.0)) return accumulated;
    const double occluded = gloam_gtao_arc_uniform(horizons.x, -slice.normal.y) +
                            gloam_gtao_arc_uniform(horizons.y, slice.normal.y);
    return accumulated + dvec2(occluded, 1.0);
}

inline double gloam_gtao_occlusion(dvec2 accumulated) {
    if (!(accumulated.x > 0.0 && accumulated.y >= float_min && accumulated.y <= 0x1p126)) return 0.0;
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, 1.0) : 1.0;
}

}  // namespace gloam::reference
