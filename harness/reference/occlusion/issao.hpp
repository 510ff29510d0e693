// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_issao_attenuation(double hit_distance, double phi, double mu) {
    const double d = abs(hit_distance);
    if (!(d > 0.0 && phi > 0.0 && mu >= float_min && max(mu, d) <= 0x1p126)) return 0.0;
    const double q = phi * d / pow(max(mu, d), 2);
    return is_finite(q) ? q : 0.0;
}

inline double gloam_contribution_issao_basic(dvec3 offset, dvec3 normal, double radius) {
    return gloam_length(offset) < radius ? gloam_sample_cosine(offset, normal) : 0.0;
}

inline double gloam_contribution_issao_attenuated(dvec3 offset, dvec3 normal, double radius, double phi,
                                                  double mu) {
    if (!(gloam_length(offset) < radius)) return 0.0;
    return gloam_issao_attenuation(gloam_length(offset), phi, mu) * gloam_sample_cosine(offset, normal);
}

inline double gloam_contribution_issao(dvec3 offset, dvec3 normal, double radius, double phi, double bias,
                                       double sigma) {
    const double divisor = dot(offset, offset) + sigma;
    const bool near = length(offset) < radius && sigma >= 0.0 && divisor >= float_min && divisor <= 0x1p126;
    const double above = dot(offset, normal) - bias;
    if (!(near && phi > 0.0 && above > 0.0)) return 0.0;
    const double contribution = phi * above / divisor;
    return is_finite(contribution) ? contribution : 0.0;
}

inline double gloam_issao_occlusion(dvec2 accumulated, double lambda) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0 && lambda > 0.0)) return 0.0;
    return gloam_unit_interval(lambda / accumulated.y * accumulated.x);
}

}  // namespace gloam::reference
