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
};

inline GloamSweepSide gloam_sweep_side(double lowest) {
    return {lowest, 0.0, 0.0, 0.0};
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

inline GloamSweepSide gloam_sweep_tap(GloamSweepSide side, const GloamSlice& slice, dvec2 offset, bool tells,
                                      bool rises, unsigned falloff) {
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

}  // namespace gloam::reference
