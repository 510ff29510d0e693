// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"
#include "reference/sampling/halton.hpp"

namespace gloam::reference {

template <class T>
struct GloamSliceSample {
    vec2<T> direction;
    T jitter;
    T share;
};

template <class T>
T gloam_kernel_turns(T angle) {
    return abs(angle) <= T(65536) ? angle / T(6.283185307F) : T(0);
}

template <class T>
GloamSliceSample<T> gloam_slice_sample(unsigned index, T turns) {
    const vec3<T> point = gloam_halton_3d<T>(index);
    return {gloam_circle_point(T(T(0.5) * fract(point.x + turns))), fract(point.y + turns), point.z};
}

}  // namespace gloam::reference
