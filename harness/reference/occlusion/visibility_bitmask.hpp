// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/bit_count.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_bitmask_back(vec3<T> offset, GloamSlice<T> slice, T thickness) {
    const vec3<T> behind = offset - slice.view * thickness;
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    const bool thick = thickness > T(0) && dot(direction, direction) > T(0.5) && gloam_is_finite3(behind);
    return gloam_slice_direction(thick ? behind : offset, slice);
}

template <class T>
T gloam_slice_fraction_angle(vec2<T> direction, GloamSlice<T> slice) {
    const T angle = gloam_atan2(direction.y, direction.x);
    return gloam_unit_interval((angle - slice.angle) * T(0.3183098862) + T(0.5));
}

template <class T>
T gloam_slice_fraction_cosine(vec2<T> direction, GloamSlice<T> slice) {
    const bool negative = direction.y < T(0);
    const vec2<T> normal = negative ? vec2<T>(slice.normal.x, -slice.normal.y) : slice.normal;
    const vec2<T> horizon(direction.x, abs(direction.y));
    const T elevation =
        T(1.570796327) + (negative ? T(-slice.angle) : slice.angle) - gloam_atan2(horizon.y, horizon.x);
    const T part = gloam_gtao_arc(elevation, horizon, normal) / gloam_slice_whole(slice);
    return gloam_unit_interval(negative ? part : T(1) - part);
}

template <class T>
T gloam_slice_fraction_uniform(vec2<T> direction, GloamSlice<T> slice) {
    const bool negative = direction.y < T(0);
    const T part = gloam_gtao_arc_uniform(direction.x, negative ? T(-slice.normal.y) : slice.normal.y);
    return gloam_unit_interval(negative ? part : T(1) - part);
}

template <class T = double>
unsigned gloam_bit_range(unsigned first, unsigned last) {
    const unsigned below_last = last >= 32U ? 0xFFFFFFFFU : (1U << last) - 1U;
    const unsigned below_first = first >= 32U ? 0xFFFFFFFFU : (1U << first) - 1U;
    return below_last & ~below_first;
}

template <class T>
unsigned gloam_bitmask_sectors(vec2<T> fractions) {
    const T lower = ceil(T(32) * gloam_unit_interval(fractions.x) - T(0.5));
    const T upper = ceil(T(32) * gloam_unit_interval(fractions.y) - T(0.5));
    return gloam_bit_range(static_cast<unsigned>(to_int(max(lower, T(0)))),
                           static_cast<unsigned>(to_int(max(upper, T(0)))));
}

template <class T>
unsigned gloam_bitmask_sectors_outward(vec2<T> fractions) {
    const T lower = gloam_unit_interval(fractions.x);
    const T width = gloam_unit_interval(fractions.y) - lower;
    const auto first = static_cast<unsigned>(to_int(floor(T(32) * lower)));
    if (!(width > T(0))) return 0U;
    return gloam_bit_range(first, min(first + static_cast<unsigned>(to_int(ceil(T(32) * width))), 32U));
}

template <class T = double>
T gloam_bitmask_occlusion(unsigned sectors) {
    return T(gloam_bit_count(sectors)) * T(0.03125);
}

}  // namespace gloam::reference
