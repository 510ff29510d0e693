// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

template <class T>
T gloam_issao_attenuation(T hit_distance, T phi, T mu) {
    const T d = abs(hit_distance);
    const T larger = d > mu ? d : mu;
    if (!(d > T(0) && phi > T(0) && mu >= float_min<T>() && larger <= T(0x1p126))) return T(0);
    const T weight = phi * (d / larger) / larger;
    return weight <= float_max<T>() ? weight : T(0);
}

template <class T>
T gloam_contribution_issao_attenuated(vec3<T> offset, vec3<T> normal, T radius, T phi, T mu) {
    const T reach = dot(offset, gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))));
    if (!(reach < radius)) return T(0);
    return gloam_issao_attenuation(reach, phi, mu) * gloam_sample_cosine(offset, normal);
}

template <class T>
T gloam_contribution_issao(vec3<T> offset, vec3<T> normal, T radius, T phi, T bias, T sigma) {
    const T squared = dot(offset, offset);
    const T denominator = squared + sigma;
    const T above = dot(offset, normal) - bias;
    if (!(squared < radius * radius && radius > T(0) && above > T(0) && sigma >= T(0))) return T(0);
    if (!(phi > T(0) && denominator >= float_min<T>() && denominator <= T(0x1p126))) return T(0);
    const T contribution = phi * (above / denominator);
    return contribution <= float_max<T>() ? contribution : T(0);
}

template <class T>
T gloam_issao_occlusion(vec2<T> accumulated, T lambda) {
    if (!(accumulated.y >= T(1) && accumulated.x > T(0) && lambda > T(0))) return T(0);
    const T occlusion = lambda * (accumulated.x / accumulated.y);
    return occlusion < T(1) ? occlusion : (occlusion >= T(1) ? T(1) : T(0));
}

}  // namespace gloam::reference
