// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/slice.hpp"

namespace gloam::reference {

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
