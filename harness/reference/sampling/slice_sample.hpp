// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"
#include "reference/sampling/halton.hpp"

namespace gloam::reference {

struct GloamSliceSample {
    dvec2 direction;
    double jitter;
    double share;
};

// Directions over half a turn; the kernel's angle shifts them and the jitter.
inline GloamSliceSample gloam_slice_sample(unsigned index, double turns) {
    const dvec3 point = gloam_halton_3d(index);
    return {on_circle(pi * fract(point.x + turns)), fract(point.y + turns), point.z};
}

}  // namespace gloam::reference
