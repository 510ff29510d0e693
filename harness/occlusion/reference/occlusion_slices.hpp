// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/shading.hpp"

// Horizons, sectors and sweeps of slices.
namespace gloam::reference {

inline double gloam_tangent_slope(dvec3 normal, dvec2 direction) {
    return clamp(-dot(dvec2(normal), direction) / max(normal.z, 1e-6), -1e6, 1e6);
}

inline double gloam_tangent_slope_of_derivatives(dvec2 direction, dvec3 dpdu, dvec3 dpdv) {
    const dvec3 t = direction.x * dpdu + direction.y * dpdv;
    return has_direction(t) ? clamp(t.z / length(dvec2(t)), -1e6, 1e6) : 0.0;
}

inline double gloam_sine_of_tangent(double tangent) {
    return std::isnan(tangent) ? 0.0 : sin(atan(tangent));
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

inline dvec2 gloam_hbao_step(dvec2 march, double rise, double squared, double radius) {
    const double sine = min(rise / sqrt(squared), 1.0);
    if (!(squared <= pow(radius, 2) && sine > march.x)) return march;
    return {sine, march.y + (1.0 - squared / pow(radius, 2)) * (sine - march.x)};
}

inline double gloam_hbao_visibility(double occlusion, double bias, double contrast) {
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    return max(1.0 - contrast * occlusion / (1.0 - sin(bias)), 0.0);
}

inline double gloam_gtao_horizon(double horizon, double lowest, dvec2 offset, double radius) {
    const double r = length(offset);
    return r < radius ? max(horizon, mix(lowest, offset.x / r, 1.0 - r / radius)) : horizon;
}

// The angle of a horizon of that cosine; NaN has seen nothing.
inline double horizon_angle(double cosine) {
    return std::isnan(cosine) ? pi : acos(cosine_in_range(cosine));
}

// (e sin n + cos h cos(h - n)) / 2.
inline double gloam_gtao_arc(double elevation, dvec2 horizon, dvec2 normal) {
    if (!(elevation > 0.0)) return 0.0;
    const double arc = (min(elevation, pi) * normal.y + horizon.x * dot(horizon, normal)) / 2.0;
    return std::isnan(arc) ? 0.0 : clamp(arc, 0.0, pi / 2.0);
}

inline double gloam_gtao_side(double horizon, double angle, dvec2 normal) {
    const double h = horizon_angle(horizon);
    const double c = std::isnan(horizon) ? -1.0 : cosine_in_range(horizon);
    return gloam_gtao_arc(angle + pi / 2.0 - h, {c, sin(h)}, normal);
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
                                          bool contributes, bool rises, unsigned falloff) {
    if (!contributes) return side;
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

inline GloamSweepSide gloam_sweep_tap(GloamSweepSide side, const GloamSlice& slice, dvec2 offset,
                                      bool contributes, bool rises, unsigned falloff, double thickness) {
    if (!contributes) return side;
    const dvec2 at{offset.x, abs(offset.y)};
    side = gloam_sweep_end(side, at, thickness);
    GloamSweepSide alone = side;
    alone.occluded = 0.0;
    alone = gloam_sweep_uncover(alone, slice, offset, contributes, rises, falloff);
    if (alone.horizon > side.horizon && side.rise <= 0.0) {
        alone.rise = max(at.x - side.last.x, 1e-4);
        alone.start = (at.y + side.last.y) / 2.0;
    }
    alone.feature += alone.occluded;
    alone.occluded = side.occluded;
    alone.last = at;
    return alone;
}

struct GloamSweepPair {
    dvec2 behind;
    dvec2 counts;
    dvec2 occluded;
    dvec2 feature;
    dvec2 rise;
    dvec2 start;
    dvec2 nearer;
    double place;
};

inline GloamSweepPair gloam_sweep_pair() {
    return {dvec2(0.0), dvec2(1.0), dvec2(0.0), dvec2(0.0), dvec2(1e-10), dvec2(0.0), dvec2(0.0), 0.0};
}

inline dvec2 gloam_pair_behind(dvec2 cosine, dvec2 sine, dvec2 plane) {
    const auto side = [&](int i) {
        const double e = std::atan2(sine[i], cosine[i]);
        return ((i == 0 ? plane.y : -plane.y) * (e - sin(2.0 * e) / 2.0) + plane.x * pow(sin(e), 2)) / 2.0;
    };
    return {side(0), side(1)};
}

// The same by the fit that the shader has: e - sin e cos e as t^(3/2) (1.56854 + 0.38684 cos e).
inline double fitted_behind(double cosine, double sine, dvec2 plane) {
    return (plane.y * pow(abs(1.0 - cosine), 1.5) * (1.56854 + 0.38684 * cosine) + plane.x * pow(sine, 2)) /
           2.0;
}

inline GloamSweepPair gloam_pair_end(GloamSweepPair pair, dvec2 nearer, double middle, double thickness) {
    for (int i = 0; i < 2; ++i) {
        if (pair.nearer[i] - nearer[i] <= 0.8 * pair.rise[i]) continue;
        pair.occluded[i] +=
            pair.feature[i] * clamp(thickness * (middle - pair.start[i]) / pair.rise[i], 0.0, 1.0);
        pair.feature[i] = 0.0;
        pair.rise[i] = 1e-10;
    }
    return pair;
}

inline GloamSweepPair gloam_pair_tap(const GloamSweepPair& pair, dvec4 taps, dvec2 nearer, double place,
                                     dvec2 plane, double bias, double thickness) {
    const double middle = (place + pair.place) / 2.0;
    GloamSweepPair next = gloam_pair_end(pair, nearer, middle, thickness);
    for (int i = 0; i < 2; ++i) {
        const double here = std::hypot(taps[i], taps[i + 2]);
        const double weight = clamp(pair.counts[i] - here / 2.0, 0.0, 1.0);
        const double found =
            fitted_behind(taps[i] / here, taps[i + 2] / here, {plane.x, i == 0 ? plane.y : -plane.y});
        const double gain = weight > 0.0 && taps[i + 2] > bias ? max(found - pair.behind[i], 0.0) : 0.0;
        if (next.rise[i] < min(gain, 1e-4)) {
            next.rise[i] = max(nearer[i] - pair.nearer[i], 1e-4);
            next.start[i] = middle;
        }
        next.behind[i] += gain;
        next.feature[i] += weight * gain;
        next.counts[i] = max(1.0 - here / 2.0, 0.5);
    }
    next.nearer = nearer;
    next.place = place;
    return next;
}

inline dvec2 gloam_bent_slice(dvec2 occluded, dvec2 plane) {
    const auto elevation = [&](int i) { return std::asin(sqrt(min(2.0 * occluded[i], 1.0))); };
    const dvec2 e(elevation(0), elevation(1));
    const double normal = (pow(sin(e.x), 3) + pow(sin(e.y), 3)) / max(plane.x, 0.001);
    return {pow(cos(e.y), 3) - pow(cos(e.x), 3) + plane.y * normal, normal};
}

}  // namespace gloam::reference
