// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/occlusion.hpp"

// What is made of the occlusion.
namespace gloam::reference {

inline double gloam_remap(double ao, double a, double b, double c) {
    const double base = b * (ao + a);
    if (std::isnan(base) || std::isnan(c)) return 1.0;
    return base > 0.0 ? std::clamp(pow(base, c), 0.0, 1.0) : (c > 0.0 ? 0.0 : 1.0);
}

inline dvec3 gloam_ambient_light(dvec3 incident, double occlusion) {
    return (1.0 - gloam_unit_interval(occlusion)) * incident;
}

inline dvec3 gloam_multi_bounce(double occlusion, dvec3 albedo) {
    const double v = 1.0 - gloam_unit_interval(occlusion);
    for (int i = 0; i < 3; ++i) {
        const double p = gloam_unit_interval(albedo[i]);
        const double fitted =
            (2.0404 * p - 0.3324) * pow(v, 3) + (0.6417 - 4.7951 * p) * pow(v, 2) + (2.7552 * p + 0.6903) * v;
        albedo[i] = std::clamp(fitted, v, 1.0);
    }
    return albedo;
}

inline dvec4 gloam_bent_add(dvec4 bent, dvec3 direction, double visibility) {
    return is_finite(direction) ? bent + gloam_unit_interval(visibility) * dvec4(direction, 1.0) : bent;
}

inline dvec3 gloam_bent_normal(dvec4 bent, dvec3 normal) {
    return bent.w > 0.0 ? gloam_safe_normalize(bent, normal) : normal;
}

inline double gloam_bent_length(dvec4 bent) {
    const bool some = bent.w >= float_min && bent.w <= 0x1p126;
    return some ? min(gloam_length(bent) / bent.w, 1.0) : 1.0;
}

// (1 + cos a) / 2 = L.
inline double gloam_cone_angle(double agreement) {
    return acos(max(0.0, 2.0 * gloam_unit_interval(agreement) - 1.0));
}

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

inline double gloam_depth_darkening(double depth, double blurred_depth, double strength) {
    if (gloam_is_background(depth) || gloam_is_background(blurred_depth) || !(strength > 0.0)) return 0.0;
    return blurred_depth < depth ? max(strength * (blurred_depth - depth), -float_max) : 0.0;
}

}  // namespace gloam::reference
