// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_lifted_cosine(dvec3 offset, dvec3 normal, dvec3 view) {
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    const double above = dot(direction, normal);
    const dvec3 lifted = above < 0.0 ? dvec3(direction - normal * above) : direction;
    const double squared = dot(lifted, lifted);
    if (!(squared > 1e-10)) return 0.0;
    const double cosine = dot(view, lifted) / sqrt(squared);
    return abs(cosine) <= 1.0 ? cosine : (cosine > 1.0 ? 1.0 : (cosine < -1.0 ? -1.0 : 0.0));
}

inline bool gloam_sample_near(dvec3 offset, double range) {
    return offset.z <= range;
}

inline dvec3 gloam_angle_pair(dvec3 first, dvec3 second, dvec3 normal, dvec3 view, double range) {
    const bool a = gloam_sample_near(first, range);
    const bool b = gloam_sample_near(second, range);
    if (a && b)
        return dvec3(gloam_lifted_cosine(first, normal, view), gloam_lifted_cosine(second, normal, view),
                     1.0);
    if (!a && !b) return dvec3(0.0);
    const double valid = gloam_lifted_cosine(a ? first : second, normal, view);
    const double mirrored =
        gloam_unit_interval(-dot(view, gloam_safe_normalize(a ? first : second, dvec3(0.0))));
    return a ? dvec3(valid, mirrored, 0.5) : dvec3(mirrored, valid, 0.5);
}

inline dvec2 gloam_angle_add(dvec2 accumulated, double weight, double angles) {
    const double occluded = 1.0 - angles * 0.3183098862;
    if (!(weight > 0.0 && weight <= float_max && abs(occluded) <= float_max)) return accumulated;
    return accumulated + dvec2(occluded, 1.0) * weight;
}

inline double gloam_angle_occlusion(dvec2 accumulated) {
    if (!(accumulated.x > 0.0 && accumulated.y >= 1e-4 && accumulated.y <= 0x1p126)) return 0.0;
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, 1.0) : 1.0;
}

inline double gloam_contribution_unreal(dvec3 offset, dvec3 normal, double scale) {
    const double squared = dot(offset, offset);
    const double above = dot(offset, normal);
    if (!(above > 0.0 && scale > 0.0 && squared >= float_min && squared <= 0x1p126)) return 0.0;
    return gloam_unit_interval(scale * (above / squared));
}

inline double gloam_unreal_side(double occlusion) {
    const double open = 1.0 - gloam_unit_interval(occlusion);
    return open * open;
}

inline double gloam_unreal_visibility(double ao, double power, double intensity) {
    const double visibility = 1.0 - (1.0 - gloam_remap(ao, 0.0, 1.0, power)) * intensity;
    return visibility < 1.0 ? (visibility > 0.0 ? visibility : 0.0) : 1.0;
}

}  // namespace gloam::reference
