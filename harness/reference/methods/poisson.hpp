// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/ray_gather.hpp"
#include "reference/sampling/poisson.hpp"
#include "reference/sampling/poisson_disc.hpp"
#include "reference/sampling/radical_inverse.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
struct GloamPoisson {
    T range;
    unsigned steps;
};

template <class T>
struct PoissonMethod {
    GloamRay<T> ray(unsigned index, const mat3<T>& frame, GloamKernel<T> kernel,
                    GloamMethod<T> /*method*/) const {
        const T turn = T(6.283185307F) * gloam_radical_inverse_base2<T>(index / 64U);
        const vec2<T> disc = gloam_rotate_disc(gloam_poisson_disc<T>(index), T(kernel.angle + turn));
        const T jitter = fract(gloam_radical_inverse<T>(index + 1U, 3U) +
                               gloam_unit_interval(T(kernel.angle / T(6.283185307F))));
        return {frame * gloam_hemisphere_lift(disc), jitter, vec2<T>(T(0), T(0))};
    }
    vec2<T> step(GloamRay<T> ray, GloamRayTap<T> tap, vec3<T> /*normal*/, GloamKernel<T> kernel,
                 GloamMethod<T> method) const {
        const T blocked = gloam_sample_blocked(tap.depth, tap.buffer_depth, kernel.bias, method.range);
        return vec2<T>(max(ray.seen.x, blocked), T(0));
    }
    vec2<T> end(GloamRay<T> ray, vec3<T> /*normal*/, GloamMethod<T> /*method*/) const {
        return vec2<T>(ray.seen.x, T(1));
    }
};

}  // namespace gloam::reference
