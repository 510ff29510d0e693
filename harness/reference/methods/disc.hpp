// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/fox_compton.hpp"
#include "reference/occlusion/tap_gather.hpp"
#include "reference/sampling/halton_disc.hpp"

namespace gloam::reference {

template <class T>
struct GloamDisc {
    T epsilon;
};

template <class T>
struct DiscMethod {
    vec2<T> tap(unsigned i, vec3<T> /*position*/, GloamKernel<T> kernel) const {
        return gloam_halton_disc(kernel.first + i + 1U, gloam_sincos(kernel.angle));
    }
    T occlusion(vec3<T> offset, vec3<T> normal, T /*depth*/, GloamKernel<T> kernel,
                GloamMethod<T> method) const {
        const vec3<T> zero(T(0), T(0), T(0));
        const bool inside = dot(offset, gloam_safe_normalize(offset, zero)) <= kernel.radius;
        const bool above = dot(offset, normal) > kernel.bias;
        if (!(inside && above)) return T(0);
        return gloam_contribution_fox_compton_scaled(zero, normal, offset, method.epsilon);
    }
};

}  // namespace gloam::reference
