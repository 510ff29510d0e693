// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/acos_approximation.hpp"
#include "reference/sampling/unit_interval.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

// The cosine to the view vector of a direction, which is moved along the normal into the tangent plane from
// below it.
inline double gloam_lifted_cosine(dvec3 offset, dvec3 normal, dvec3 view) {
    dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    if (dot(direction, normal) < 0.0) direction -= dot(direction, normal) * normal;
    const double left = length(direction);
    return left > 1e-5 ? gloam_clamp_cosine(dot(view, direction) / left) : 0.0;
}

inline bool gloam_sample_near(dvec3 offset, double range) {
    return offset.z <= range;
}

// An invalid sample has the direction opposite to its partner's.
inline dvec3 gloam_angle_pair(dvec3 first, dvec3 second, dvec3 normal, dvec3 view, double range) {
    const bool a = gloam_sample_near(first, range);
    const bool b = gloam_sample_near(second, range);
    if (!a && !b) return dvec3(0.0);
    const auto mirrored = [&](dvec3 partner) {
        return gloam_unit_interval(dot(view, gloam_safe_normalize(-partner, dvec3(0.0))));
    };
    return {a ? gloam_lifted_cosine(first, normal, view) : mirrored(second),
            b ? gloam_lifted_cosine(second, normal, view) : mirrored(first), a && b ? 1.0 : 0.5};
}

inline dvec2 gloam_angle_add(dvec2 accumulated, double weight, double angles) {
    if (!(weight > 0.0 && is_finite(weight) && is_finite(angles))) return accumulated;
    return accumulated + weight * dvec2(1.0 - angles / pi, 1.0);
}

inline double gloam_angle_occlusion(dvec2 accumulated) {
    if (!(accumulated.x > 0.0 && accumulated.y >= 1e-4 && accumulated.y <= 0x1p126)) return 0.0;
    return min(accumulated.x / accumulated.y, 1.0);
}

inline double gloam_contribution_unreal(dvec3 offset, dvec3 normal, double scale) {
    const double squared = dot(offset, offset);
    if (!(scale > 0.0 && squared >= float_min && squared <= 0x1p126)) return 0.0;
    return gloam_unit_interval(scale * dot(offset, normal) / squared);
}

inline double gloam_unreal_side(double occlusion) {
    return pow(1.0 - gloam_unit_interval(occlusion), 2);
}

inline double gloam_unreal_visibility(double ao, double power, double intensity) {
    const double visibility = 1.0 - (1.0 - gloam_remap(ao, 0.0, 1.0, power)) * intensity;
    return std::isnan(visibility) ? 1.0 : gloam_unit_interval(visibility);
}

}  // namespace gloam::reference
