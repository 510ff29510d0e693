// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/pair_gather.hpp"
#include "reference/occlusion/volumetric.hpp"

namespace gloam::reference {

template <class T>
struct VolumetricMethod {
    vec2<T> occlusion(GloamPair<T> pair, GloamKernel<T> kernel, GloamMethod<T> /*method*/) const {
        const T half_height = gloam_chord_half_height(pair.point, kernel.radius);
        const T first = gloam_line_ratio(pair.heights.x, half_height);
        const T second = gloam_line_ratio(pair.heights.y, half_height);
        const vec2<T> solid = gloam_line_pair(vec2<T>(first, second), T(0.35F), T(1));
        return half_height * vec2<T>(solid.x + solid.y, T(2));
    }
};

}  // namespace gloam::reference
