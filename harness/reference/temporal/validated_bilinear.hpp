// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec4 gloam_bilinear_weights(dvec2 fraction) {
    const double x = gloam_unit_interval(fraction.x);
    const double y = gloam_unit_interval(fraction.y);
    return {(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y};
}

inline dvec4 gloam_validated_weights(dvec4 bilinear, glm::bvec4 valid) {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += bilinear[i] = valid[i] ? gloam_unit_interval(bilinear[i]) : 0.0;
    return sum >= float_min ? bilinear / sum : dvec4(0.0);
}

}  // namespace gloam::reference
