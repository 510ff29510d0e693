// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/falloff_choice.hpp"
#include "reference/occlusion/gtao.hpp"

namespace gloam::reference {

template <class T>
struct GloamSweepSide {
    T horizon;
    T behind;
    T before;
    T occluded;
};

template <class T>
GloamSweepSide<T> gloam_sweep_side(T lowest) {
    return {lowest, T(0), T(0), T(0)};
}

template <class T>
T gloam_sweep_distance(T before, T here) {
    return (before + here) / T(2);
}

template <class T>
GloamSlice<T> gloam_sweep_slice(GloamSlice<T> slice, T towards) {
    slice.tangent = slice.tangent * towards;
    slice.normal.y = slice.normal.y * towards;
    slice.angle = slice.angle * towards;
    return slice;
}

// By the printed inner integral: I(n + pi / 2) - I(h).
template <class T>
T gloam_sweep_behind(vec2<T> direction, GloamSlice<T> slice) {
    const T h = gloam_atan2(abs(direction.y), direction.x);
    const T end = slice.angle + T(1.5707963267948966);
    const auto inner = [&slice](T a) {
        return T(0.25) * (cos(slice.angle) - cos(T(2) * a - slice.angle) + T(2) * a * sin(slice.angle));
    };
    return inner(end) - inner(h);
}

template <class T>
GloamSweepSide<T> gloam_sweep_tap(GloamSweepSide<T> side, GloamSlice<T> slice, vec2<T> offset, bool tells,
                                  bool rises, unsigned falloff) {
    if (!tells) return side;
    const T here = sqrt(dot(offset, offset));
    const vec2<T> direction = here > T(0) ? offset * (T(1) / here) : offset;
    const T weight = gloam_falloff_at(falloff, gloam_sweep_distance(side.before, here));
    if (rises && direction.x > side.horizon && weight > T(0)) {
        const T behind = gloam_sweep_behind(direction, slice);
        side.occluded = side.occluded + weight * (behind - side.behind);
        side.behind = behind;
        side.horizon = direction.x;
    }
    side.before = min(here, T(1));
    return side;
}

}  // namespace gloam::reference
