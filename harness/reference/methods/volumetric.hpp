// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/pair_gather.hpp"
#include "reference/occlusion/volumetric.hpp"

namespace gloam::reference {

struct VolumetricMethod {
    dvec2 occlusion(GloamPair pair, GloamKernel kernel, GloamMethod /*method*/) const {
        const double half_height = gloam_chord_half_height(pair.point, kernel.radius);
        const double first = gloam_line_ratio(pair.heights.x, half_height);
        const double second = gloam_line_ratio(pair.heights.y, half_height);
        const dvec2 solid = gloam_line_pair(dvec2(first, second), double(0.35F), 1.0);
        return half_height * dvec2(solid.x + solid.y, 2.0);
    }
};

}  // namespace gloam::reference
