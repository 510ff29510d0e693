// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/ray_gather.hpp"
#include "reference/sampling/poisson.hpp"
#include "reference/sampling/poisson_disc.hpp"
#include "reference/sampling/radical_inverse.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

struct GloamPoisson {
    double range;
    unsigned steps;
};

struct PoissonMethod {
    GloamRay ray(unsigned index, const dmat3& frame, GloamKernel kernel, GloamMethod /*method*/) const {
        const double turn = double(6.283185307F) * gloam_radical_inverse_base2(index / 64U);
        const dvec2 disc = gloam_rotate_disc(gloam_poisson_disc(index), double(kernel.angle + turn));
        const double jitter = fract(gloam_radical_inverse(index + 1U, 3U) +
                                    gloam_unit_interval(double(kernel.angle / double(6.283185307F))));
        return {frame * gloam_hemisphere_lift(disc), jitter, dvec2(0.0)};
    }
    dvec2 step(GloamRay ray, GloamRayTap tap, dvec3 /*normal*/, GloamKernel kernel,
               GloamMethod method) const {
        const double blocked = gloam_sample_blocked(tap.depth, tap.buffer_depth, kernel.bias, method.range);
        return dvec2(max(ray.seen.x, blocked), 0.0);
    }
    dvec2 end(GloamRay ray, dvec3 /*normal*/, GloamMethod /*method*/) const { return dvec2(ray.seen.x, 1.0); }
};

}  // namespace gloam::reference
