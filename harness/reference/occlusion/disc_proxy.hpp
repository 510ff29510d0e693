// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/numeric/length_ratio.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_disc_share(double area, double distance_to) {
    const double radius = gloam_sqrt(area * (1.0 / pi));
    if (!(radius > 0.0 && distance_to >= 0.0)) return dvec2(0.0, 1.0);
    const bool wide = radius > distance_to;
    const double x = gloam_length_ratio(wide ? distance_to : radius, wide ? radius : distance_to);
    const double larger = 1.0 / (1.0 + x * x);
    const double smaller = x * x / (1.0 + x * x);
    return min(wide ? dvec2(larger, smaller) : dvec2(smaller, larger), dvec2(1.0, 1.0));
}

inline double gloam_contribution_disc_proxy(dvec3 offset, dvec3 normal, dvec3 emitter_normal, double area,
                                            double weight) {
    const dvec2 share = gloam_disc_share(area, gloam_length(offset));
    const dvec3 back(-offset.x, -offset.y, -offset.z);
    const double facing =
        gloam_sample_cosine(back, emitter_normal) * min(4.0 * gloam_sample_cosine(offset, normal), 1.0);
    return gloam_unit_interval(weight) * facing * (share.x / (1.0 + gloam_sqrt(share.y)));
}

inline double gloam_contribution_disc_proxy_cosine(dvec3 offset, dvec3 normal, dvec3 emitter_normal,
                                                   double area, double weight) {
    const double share = gloam_disc_share(area, gloam_length(offset)).x;
    const dvec3 back(-offset.x, -offset.y, -offset.z);
    return gloam_unit_interval(weight) * share * gloam_sample_cosine(back, emitter_normal) *
           gloam_sample_cosine(offset, normal);
}

}  // namespace gloam::reference
