// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec3 gloam_ssdo_radiance(dvec3 radiance) {
    for (int i = 0; i < 3; ++i) radiance[i] = radiance[i] > 0.0 ? min(radiance[i], 65504.0) : 0.0;
    return radiance;
}

inline dvec3 gloam_ssdo_direct(dvec3 direction, dvec3 normal, dvec3 radiance, double visibility) {
    return 2.0 * gloam_ssdo_radiance(radiance) * gloam_unit_interval(visibility) *
           gloam_sample_cosine(direction, normal);
}

inline dvec3 gloam_ssdo_bounce(dvec3 offset, dvec3 normal, dvec3 sender_normal, dvec3 radiance, double radius,
                               double least_distance, double visibility) {
    const double d = max(gloam_length(offset), least_distance);
    if (!(radius >= float_min && least_distance >= float_min && d <= 0x1p126)) return dvec3(0.0);
    const double cosines = gloam_sample_cosine(-offset, sender_normal) * gloam_sample_cosine(offset, normal);
    return (1.0 - gloam_unit_interval(visibility)) * gloam_ssdo_radiance(radiance) *
           pow(min(radius / d, 1024.0), 2) * cosines;
}

inline dvec3 gloam_ssdo_light(dvec3 sum, double count, dvec3 albedo) {
    if (!(count >= 1.0 && count <= 0x1p24)) return dvec3(0.0);
    for (int i = 0; i < 3; ++i)
        sum[i] = sum[i] >= 0.0 && is_finite(sum[i]) ? gloam_unit_interval(albedo[i]) * sum[i] / count : 0.0;
    return sum;
}

}  // namespace gloam::reference
