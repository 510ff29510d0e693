// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/fox_compton.hpp"
#include "reference/occlusion/tap_gather.hpp"
#include "reference/sampling/halton_disc.hpp"

namespace gloam::reference {

struct GloamDisc {
    double epsilon;
};

struct DiscMethod {
    dvec2 tap(unsigned i, dvec3 /*position*/, GloamKernel kernel) const {
        return gloam_halton_disc(kernel.first + i + 1U, gloam_sincos(kernel.angle));
    }
    double occlusion(dvec3 offset, dvec3 normal, double /*depth*/, GloamKernel kernel,
                     GloamMethod method) const {
        const dvec3 zero(0.0);
        const bool inside = dot(offset, gloam_safe_normalize(offset, zero)) <= kernel.radius;
        const bool above = dot(offset, normal) > kernel.bias;
        if (!(inside && above)) return 0.0;
        return gloam_contribution_fox_compton_scaled(zero, normal, offset, method.epsilon);
    }
};

}  // namespace gloam::reference
