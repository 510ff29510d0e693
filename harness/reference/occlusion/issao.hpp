// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_issao_attenuation(double hit_distance, double phi, double mu) {
    const double d = abs(hit_distance);
    const double larger = d > mu ? d : mu;
    if (!(d > 0.0 && phi > 0.0 && mu >= float_min && larger <= 0x1p126)) return 0.0;
    const double weight = phi * (d / larger) / larger;
    return weight <= float_max ? weight : 0.0;
}

inline double gloam_contribution_issao_attenuated(dvec3 offset, dvec3 normal, double radius, double phi,
                                                  double mu) {
    const double reach = dot(offset, gloam_safe_normalize(offset, dvec3(0.0)));
    if (!(reach < radius)) return 0.0;
    return gloam_issao_attenuation(reach, phi, mu) * gloam_sample_cosine(offset, normal);
}

inline double gloam_contribution_issao(dvec3 offset, dvec3 normal, double radius, double phi, double bias,
                                       double sigma) {
    const double squared = dot(offset, offset);
    const double denominator = squared + sigma;
    const double above = dot(offset, normal) - bias;
    if (!(squared < radius * radius && radius > 0.0 && above > 0.0 && sigma >= 0.0)) return 0.0;
    if (!(phi > 0.0 && denominator >= float_min && denominator <= 0x1p126)) return 0.0;
    const double contribution = phi * (above / denominator);
    return contribution <= float_max ? contribution : 0.0;
}

inline double gloam_issao_occlusion(dvec2 accumulated, double lambda) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0 && lambda > 0.0)) return 0.0;
    const double occlusion = lambda * (accumulated.x / accumulated.y);
    return occlusion < 1.0 ? occlusion : (occlusion >= 1.0 ? 1.0 : 0.0);
}

}  // namespace gloam::reference
