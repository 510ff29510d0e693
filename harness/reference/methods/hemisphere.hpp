// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/point_gather.hpp"
#include "reference/occlusion/ritschel.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
struct GloamHemisphere {
    T range;
};

template <class T>
struct HemisphereMethod {
    vec3<T> point(unsigned index, T angle) const {
        return gloam_rotate_hemisphere(gloam_hemisphere_cosine(gloam_halton_3d<T>(index)), angle);
    }
    T occlusion(T depth, T buffer_depth, GloamKernel<T> kernel, GloamMethod<T> method) const {
        const T blocked = gloam_sample_blocked(depth, buffer_depth, kernel.bias, method.range);
        return gloam_contribution_cosine_directions(blocked, T(1));
    }
};

}  // namespace gloam::reference
