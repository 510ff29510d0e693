// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline dvec2 gloam_disc_share(double area, double distance_to) {
    if (!(area >= float_min * float_min && distance_to >= 0.0)) return {0.0, 1.0};
    if (std::isinf(area)) return std::isinf(distance_to) ? dvec2(0.5) : dvec2(1.0, 0.0);
    const double larger = area / (area + pi * pow(distance_to, 2));
    return {larger, 1.0 - larger};
}

inline double gloam_contribution_disc_proxy(dvec3 offset, dvec3 normal, dvec3 emitter_normal, double area,
                                            double weight) {
    const double open = gloam_disc_share(area, gloam_length(offset)).y;  // 1 / (1 + A / (pi D^2))
    return gloam_unit_interval(weight) * (1.0 - sqrt(open)) * gloam_sample_cosine(-offset, emitter_normal) *
           min(4.0 * gloam_sample_cosine(offset, normal), 1.0);
}

inline double gloam_contribution_disc_proxy_cosine(dvec3 offset, dvec3 normal, dvec3 emitter_normal,
                                                   double area, double weight) {
    return gloam_unit_interval(weight) * gloam_disc_share(area, gloam_length(offset)).x *
           gloam_sample_cosine(-offset, emitter_normal) * gloam_sample_cosine(offset, normal);
}

}  // namespace gloam::reference
