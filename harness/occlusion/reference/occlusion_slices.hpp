// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/shading.hpp"

// Horizons, sectors and sweeps of slices.
namespace gloam::reference {

inline double gloam_tangent_slope(dvec2 direction, dvec3 dpdu, dvec3 dpdv) {
    const dvec3 t = direction.x * dpdu + direction.y * dpdv;
    return has_direction(t) ? clamp(t.z / length(dvec2(t)), -1e6, 1e6) : 0.0;
}

inline double gloam_sine_of_tangent(double tangent) {
    return std::isnan(tangent) ? 0.0 : sin(atan(tangent));
}

inline double gloam_tangent_elevation(dvec3 normal, dvec2 direction) {
    return clamp(gloam_atan2(-dot(dvec2(normal), direction), normal.z), -pi / 2.0, pi / 2.0);
}

inline dvec2 gloam_hbao_start(double tangent, double bias) {
    const double elevation = tangent + bias;
    return {std::isnan(elevation) ? 1.0 : sin(clamp(elevation, -pi / 2.0, pi / 2.0)), 0.0};
}

inline dvec2 gloam_hbao_horizon(dvec3 normal, dvec2 direction, dvec2 bias) {
    const double across = dot(dvec2(normal), direction);
    const double away = across > 0.0 ? -pi / 2.0 : pi / 2.0;
    const double elevation = normal.z > 0.0 ? -atan(across / normal.z) : away;
    return on_circle(min(elevation + std::atan2(bias.y, bias.x), pi / 2.0));
}

inline dvec2 gloam_hbao_start_slope(double slope, double bias) {
    if (!(bias >= 0.0 && bias < 1.57079625F) || std::isnan(slope)) return {1.0, 0.0};
    return {sin(atan(slope + tan(bias))), 0.0};
}

inline dvec2 gloam_hbao_step(dvec2 horizon, dvec3 offset, double radius) {
    const double r = length(offset);
    if (!(has_direction(offset) && radius >= float_min && radius <= 0x1p126 && r < radius)) return horizon;
    const double sine = offset.z / r;
    if (!(sine > horizon.x)) return horizon;
    return {sine, horizon.y + (1.0 - pow(r / radius, 2)) * (sine - horizon.x)};
}

inline dvec2 gloam_hbao_step_size(double radius, double largest, double steps, double extra) {
    const double reach = radius < largest ? radius : largest;
    if (!(reach >= 1.0 && reach <= 0x1p126 && steps >= 1.0 && extra >= 0.0)) return dvec2(0.0);
    const double count = floor(min(steps, reach));
    return {reach / (count + extra), count};
}

inline double gloam_hbao_visibility(double occlusion, double bias, double contrast) {
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    return max(1.0 - contrast * occlusion / (1.0 - sin(bias)), 0.0);
}

inline double gloam_contribution_hbao_simplified(dvec3 offset, dvec3 normal, double radius, double bias) {
    const double r = length(offset);
    const bool near = has_direction(offset) && radius >= float_min && radius <= 0x1p126 && r < radius;
    const double above = dot(normal, offset) / r - bias;
    if (!(near && above > 0.0 && bias >= 0.0 && bias < 1.0)) return 0.0;
    return min(above / (1.0 - bias), 1.0) * (1.0 - pow(r / radius, 2));
}

inline double gloam_visibility_hbao_simplified(dvec2 accumulated, double power) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * accumulated.x / accumulated.y, 0.0, 1.0, power);
}

inline double gloam_gtao_horizon(double horizon, double lowest, dvec3 offset, dvec3 view, double weight) {
    if (!(weight > 0.0) || !has_direction(offset)) return horizon;
    const double cosine = mix(lowest, dot(normalize(offset), view), min(weight, 1.0));
    return cosine > horizon ? min(cosine, 1.0) : horizon;
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

inline dvec2 gloam_bitmask_back(dvec3 offset, const GloamSlice& slice, double thickness) {
    const dvec3 behind = offset - thickness * slice.view;
    const bool thick = thickness > 0.0 && has_direction(offset) && is_finite(behind);
    return gloam_slice_direction(thick ? behind : offset, slice);
}

inline double gloam_slice_fraction_angle(dvec2 direction, const GloamSlice& slice) {
    return gloam_unit_interval((gloam_atan2(direction.y, direction.x) - slice.angle) / pi + 0.5);
}

// The part of the slice's integral below the direction: on the negative side what a horizon there takes, on
// the positive side all but that.
inline double gloam_slice_fraction_cosine(dvec2 direction, const GloamSlice& slice) {
    const double side = direction.y < 0.0 ? -1.0 : 1.0;
    const double elevation = side * slice.angle + pi / 2.0 - gloam_atan2(abs(direction.y), direction.x);
    const double taken =
        gloam_gtao_arc(elevation, {direction.x, side * direction.y}, {slice.normal.x, side * slice.normal.y});
    const double part = taken / gloam_slice_whole(slice);
    return gloam_unit_interval(side < 0.0 ? part : 1.0 - part);
}

inline double gloam_slice_fraction_uniform(dvec2 direction, const GloamSlice& slice) {
    const double side = direction.y < 0.0 ? -1.0 : 1.0;
    const double part = gloam_gtao_arc_uniform(direction.x, side * slice.normal.y);
    return side < 0.0 ? part : 1.0 - part;
}

inline unsigned gloam_bit_range(unsigned first, unsigned last) {
    unsigned bits = 0U;
    for (unsigned i = first; i < std::min(last, 32U); ++i) bits |= 1U << i;
    return bits;
}

// Each sector by its centre.
inline unsigned gloam_bitmask_sectors(dvec2 fractions) {
    unsigned bits = 0U;
    for (unsigned i = 0; i < 32U; ++i) {
        const double center = (i + 0.5) / 32.0;
        if (gloam_unit_interval(fractions.x) <= center && center < gloam_unit_interval(fractions.y))
            bits |= 1U << i;
    }
    return bits;
}

inline unsigned gloam_bitmask_sectors_outward(dvec2 fractions) {
    const double lower = gloam_unit_interval(fractions.x);
    const double width = gloam_unit_interval(fractions.y) - lower;
    const auto first = static_cast<unsigned>(32.0 * lower);
    return width > 0.0 ? gloam_bit_range(first, first + static_cast<unsigned>(std::ceil(32.0 * width))) : 0U;
}

inline double gloam_bitmask_occlusion(unsigned sectors) {
    return gloam_bit_count(sectors) / 32.0;
}

struct GloamSweepSide {
    double horizon;
    double behind;
    double before;
    double occluded;
    double feature;
    double rise;
    double start;
    dvec2 last;
};

inline GloamSweepSide gloam_sweep_side(double lowest) {
    return {lowest, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, dvec2(0.0)};
}

inline double gloam_sweep_distance(double before, double here) {
    return (before + here) / 2.0;
}

inline GloamSlice gloam_sweep_slice(GloamSlice slice, double towards) {
    slice.tangent *= towards;
    slice.normal.y *= towards;
    slice.angle *= towards;
    return slice;
}

// By the printed inner integral: I(n + pi / 2) - I(h).
inline double gloam_sweep_behind(dvec2 direction, const GloamSlice& slice) {
    const double n = slice.angle;
    const auto inner = [n](double h) { return (cos(n) - cos(2.0 * h - n) + 2.0 * h * sin(n)) / 4.0; };
    return inner(n + pi / 2.0) - inner(gloam_atan2(abs(direction.y), direction.x));
}

inline GloamSweepSide gloam_sweep_uncover(GloamSweepSide side, const GloamSlice& slice, dvec2 offset,
                                          bool tells, bool rises, unsigned falloff) {
    if (!tells) return side;
    const double here = length(offset);
    const dvec2 direction = here > 0.0 ? offset / here : offset;
    const double weight = gloam_falloff_at(falloff, gloam_sweep_distance(side.before, here));
    if (rises && direction.x > side.horizon && weight > 0.0) {
        const double behind = gloam_sweep_behind(direction, slice);
        side.occluded += weight * (behind - side.behind);
        side.behind = behind;
        side.horizon = direction.x;
    }
    side.before = min(here, 1.0);
    return side;
}

inline double gloam_sweep_share(double width, double rise, double thickness) {
    return rise < thickness * width ? 1.0 : thickness * width / rise;
}

inline GloamSweepSide gloam_sweep_end(GloamSweepSide side, dvec2 at, double thickness) {
    const double fall = side.last.x - at.x;
    if (side.rise <= 0.0 || fall <= 0.8 * side.rise) return side;
    const double end = (at.y + side.last.y) / 2.0;
    side.occluded += side.feature * gloam_sweep_share(max(end - side.start, 0.0), side.rise, thickness);
    side.feature = side.rise = 0.0;
    return side;
}

inline GloamSweepSide gloam_sweep_tap(GloamSweepSide side, const GloamSlice& slice, dvec2 offset, bool tells,
                                      bool rises, unsigned falloff, double thickness) {
    if (!tells) return side;
    const dvec2 at{offset.x, abs(offset.y)};
    side = gloam_sweep_end(side, at, thickness);
    GloamSweepSide alone = side;
    alone.occluded = 0.0;
    alone = gloam_sweep_uncover(alone, slice, offset, tells, rises, falloff);
    if (alone.horizon > side.horizon && side.rise <= 0.0) {
        alone.rise = max(at.x - side.last.x, 1e-4);
        alone.start = (at.y + side.last.y) / 2.0;
    }
    alone.feature += alone.occluded;
    alone.occluded = side.occluded;
    alone.last = at;
    return alone;
}

// Clearance x s - y, in radii, of what a tap at the share s sees: x = c a, y = c b + 2e-4 with
// c = (1 - B / D) / (1 + R / D ((1 - a^2)^(1/2) + b)). a is the part of the direction in the slice, b what
// half a pixel is beside it, D the distance of the point, B the radius of the ball.
inline dvec2 gloam_slice_clearance(const GloamSlice& slice, dvec3 position, dvec2 direction, dvec2 end,
                                   dvec2 pixels, double radius, double ball) {
    if (!gloam_inside_unit(end) || !(ball >= 0.0 && ball <= 1.0)) return dvec2(0.0);
    const double tangent = sqrt(max(pow(slice.weight, -2) - 1.0, 0.0));  // of the normal's angle to the slice
    const double b = 0.52 * length(1.0 / pixels) * (1.0 + tangent);
    const double ratio = radius / length(position);
    const double a = abs(dot(direction, dvec2(slice.tangent)));
    const bool known =
        ratio <= 0.5 && ratio >= 1.0 / 128.0 && pow(slice.weight, 2) >= 0.1F && b <= 0.9 && a <= 1.001;
    if (!known) return dvec2(0.0);
    const double nearer = (1.0 - ball * ratio) / (1.0 + ratio * (sqrt(max(1.0 - a * a, 0.0)) + b));
    return {nearer * a, nearer * b + 2e-4};
}

// The first tap i with ((i + jitter) / steps)^2 x - y at or beyond the ball, and all that follow, see nothing
// in it.
inline unsigned gloam_slice_taps(dvec2 clearance, double ball, double jitter, unsigned steps) {
    if (ball <= 0.0) return 0U;
    if (!(ball < 1.0 && clearance.x > 0.0)) return steps;
    unsigned taps = 0;
    while (taps < steps && pow((taps + jitter) / steps, 2) * clearance.x - clearance.y < ball) ++taps;
    return taps;
}

}  // namespace gloam::reference
