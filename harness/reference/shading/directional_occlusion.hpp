// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec3 gloam_ssdo_radiance(dvec3 radiance) {
    for (int i = 0; i < 3; ++i) radiance[i] = radiance[i] > 0.0 ? min(radiance[i], 65504.0) : 0.0;
    return radiance;
}

inline dvec3 gloam_ssdo_direct(dvec3 direction, dvec3 normal, dvec3 radiance, double visibility) {
    return 2.0 * gloam_unit_interval(visibility) * gloam_sample_cosine(direction, normal) *
           gloam_ssdo_radiance(radiance);
}

inline dvec3 gloam_ssdo_bounce(dvec3 offset, dvec3 normal, dvec3 sender_normal, dvec3 radiance, double radius,
                               double least_distance, double visibility) {
    const double reach = max(gloam_length(offset), least_distance);
    const bool sized = radius >= float_min && least_distance >= float_min && reach <= 0x1p126;
    if (!sized) return dvec3(0.0);
    const double ratio = min(radius / reach, 1024.0);
    const double cosines = gloam_sample_cosine(offset, normal) *
                           gloam_sample_cosine(dvec3(-offset.x, -offset.y, -offset.z), sender_normal);
    return (1.0 - gloam_unit_interval(visibility)) * cosines * (ratio * ratio) *
           gloam_ssdo_radiance(radiance);
}

inline dvec3 gloam_ssdo_light(dvec3 sum, double count, dvec3 albedo) {
    if (!(count >= 1.0 && count <= 16777216.0)) return dvec3(0.0);
    for (int i = 0; i < 3; ++i)
        sum[i] = sum[i] >= 0.0 && sum[i] <= float_max ? sum[i] * gloam_unit_interval(albedo[i]) : 0.0;
    return sum / count;
}

}  // namespace gloam::reference
