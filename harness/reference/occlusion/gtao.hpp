// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/slice.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_gtao_horizon(double horizon, double lowest, dvec3 offset, dvec3 view, double weight) {
    if (!(weight > 0.0) || !has_direction(offset)) return horizon;
    const double cosine = mix(lowest, dot(normalize(offset), view), min(weight, 1.0));
    return cosine > horizon ? min(cosine, 1.0) : horizon;
}

// cos(n - pi / 2) and cos(n + pi / 2).
inline dvec2 gloam_gtao_lowest(const GloamSlice& slice) {
    return {slice.normal.y, -slice.normal.y};
}

// The angle of a horizon of that cosine; NaN has seen nothing.
inline double horizon_angle(double cosine) {
    return std::isnan(cosine) ? pi : acos(gloam_clamp_cosine(cosine));
}

// (n + pi / 2) - h, the horizon at h = acos(c).
inline double gloam_gtao_elevation(double horizon, double angle) {
    const double e = angle + pi / 2.0 - gloam_acos(horizon);
    return std::isnan(e) ? 0.0 : clamp(e, 0.0, pi);
}

inline double gloam_gtao_inner(double horizon, double angle) {
    const dvec2 n = gloam_sincos(angle);
    const dvec2 turned = gloam_sincos(2.0 * horizon - angle);
    const double visible = 0.25 * (-turned.x + n.x + 2.0 * horizon * n.y);
    return std::isnan(visible) ? 0.0 : clamp(visible, 0.0, pi / 2.0);
}

// (e sin n + cos h cos(h - n)) / 2.
inline double gloam_gtao_arc(double elevation, dvec2 horizon, dvec2 normal) {
    if (!(elevation > 0.0)) return 0.0;
    const double arc = (min(elevation, pi) * normal.y + horizon.x * dot(horizon, normal)) / 2.0;
    return std::isnan(arc) ? 0.0 : clamp(arc, 0.0, pi / 2.0);
}

inline double gloam_gtao_arc_uniform(double horizon, double sine) {
    return gloam_unit_interval((sine + horizon) / 2.0);
}

inline double gloam_gtao_side(double horizon, double angle, dvec2 normal) {
    const double h = horizon_angle(horizon);
    const double c = std::isnan(horizon) ? -1.0 : gloam_clamp_cosine(horizon);
    return gloam_gtao_arc(angle + pi / 2.0 - h, {c, sin(h)}, normal);
}

// Cosine-weighted: all of the slice, cos n + n sin n, less what is visible between the horizons, the printed
// inner integrals; the horizons lie within the hemisphere.
inline dvec2 gloam_gtao_add(dvec2 accumulated, const GloamSlice& slice, dvec2 horizons) {
    if (!(slice.weight > 0.0 && is_finite(slice.weight))) return accumulated;
    const double n = slice.angle;
    const double h_1 = n + max(-horizon_angle(horizons.x) - n, -pi / 2.0);
    const double h_2 = n + min(horizon_angle(horizons.y) - n, pi / 2.0);
    const double whole = gloam_slice_whole(slice);
    const double visible = gloam_gtao_inner(h_1, n) + gloam_gtao_inner(h_2, n);
    return accumulated + slice.weight * dvec2(whole - visible, whole);
}

inline dvec2 gloam_gtao_add_uniform(dvec2 accumulated, const GloamSlice& slice, dvec2 horizons) {
    if (!(slice.weight > 0.0)) return accumulated;
    const double n = slice.angle;
    return accumulated +
           dvec2(gloam_gtao_arc_uniform(horizons.x, sin(-n)) + gloam_gtao_arc_uniform(horizons.y, sin(n)),
                 1.0);
}

inline double gloam_gtao_occlusion(dvec2 accumulated) {
    if (!(accumulated.x > 0.0 && accumulated.y >= float_min && accumulated.y <= 0x1p126)) return 0.0;
    return min(accumulated.x / accumulated.y, 1.0);
}

}  // namespace gloam::reference
