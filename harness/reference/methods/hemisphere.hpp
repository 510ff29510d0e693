// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/point_gather.hpp"
#include "reference/occlusion/ritschel.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

struct GloamHemisphere {
    double range;
};

struct HemisphereMethod {
    dvec3 point(unsigned index, double angle) const {
        return gloam_rotate_hemisphere(gloam_hemisphere_cosine(gloam_halton_3d(index)), angle);
    }
    double occlusion(double depth, double buffer_depth, GloamKernel kernel, GloamMethod method) const {
        const double blocked = gloam_sample_blocked(depth, buffer_depth, kernel.bias, method.range);
        return gloam_contribution_cosine_directions(blocked, 1.0);
    }
};

}  // namespace gloam::reference
