// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/falloff_choice.hpp"
#include "reference/occlusion/gtao.hpp"

namespace gloam::reference {

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

}  // namespace gloam::reference
