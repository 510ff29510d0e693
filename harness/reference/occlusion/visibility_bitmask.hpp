// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/bit_count.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_bitmask_back(dvec3 offset, GloamSlice slice, double thickness) {
    const dvec3 behind = offset - slice.view * thickness;
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    const bool thick = thickness > 0.0 && dot(direction, direction) > 0.5 && gloam_is_finite3(behind);
    return gloam_slice_direction(thick ? behind : offset, slice);
}

inline double gloam_slice_fraction_angle(dvec2 direction, GloamSlice slice) {
    const double angle = gloam_atan2(direction.y, direction.x);
    return gloam_unit_interval((angle - slice.angle) * 0.3183098862 + 0.5);
}

inline double gloam_slice_fraction_cosine(dvec2 direction, GloamSlice slice) {
    const bool negative = direction.y < 0.0;
    const dvec2 normal = negative ? dvec2(slice.normal.x, -slice.normal.y) : slice.normal;
    const dvec2 horizon(direction.x, abs(direction.y));
    const double elevation =
        1.570796327 + (negative ? -slice.angle : slice.angle) - gloam_atan2(horizon.y, horizon.x);
    const double part = gloam_gtao_arc(elevation, horizon, normal) / gloam_slice_whole(slice);
    return gloam_unit_interval(negative ? part : 1.0 - part);
}

inline double gloam_slice_fraction_uniform(dvec2 direction, GloamSlice slice) {
    const bool negative = direction.y < 0.0;
    const double part = gloam_gtao_arc_uniform(direction.x, negative ? -slice.normal.y : slice.normal.y);
    return gloam_unit_interval(negative ? part : 1.0 - part);
}

inline unsigned gloam_bit_range(unsigned first, unsigned last) {
    const unsigned below_last = last >= 32U ? 0xFFFFFFFFU : (1U << last) - 1U;
    const unsigned below_first = first >= 32U ? 0xFFFFFFFFU : (1U << first) - 1U;
    return below_last & ~below_first;
}

inline unsigned gloam_bitmask_sectors(dvec2 fractions) {
    const double lower = ceil(32.0 * gloam_unit_interval(fractions.x) - 0.5);
    const double upper = ceil(32.0 * gloam_unit_interval(fractions.y) - 0.5);
    return gloam_bit_range(unsigned((max(lower, 0.0))), unsigned((max(upper, 0.0))));
}

inline unsigned gloam_bitmask_sectors_outward(dvec2 fractions) {
    const double lower = gloam_unit_interval(fractions.x);
    const double width = gloam_unit_interval(fractions.y) - lower;
    const auto first = unsigned((floor(32.0 * lower)));
    if (!(width > 0.0)) return 0U;
    return gloam_bit_range(first, min(first + unsigned((ceil(32.0 * width))), 32U));
}

inline double gloam_bitmask_occlusion(unsigned sectors) {
    return double(gloam_bit_count(sectors)) * 0.03125;
}

}  // namespace gloam::reference
