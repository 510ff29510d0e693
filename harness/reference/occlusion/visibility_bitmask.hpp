// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/slice.hpp"
#include "reference/numeric/bit_count.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

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

}  // namespace gloam::reference
