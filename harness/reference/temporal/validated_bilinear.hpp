// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec4 gloam_bilinear_weights(dvec2 fraction) {
    const dvec2 f(gloam_unit_interval(fraction.x), gloam_unit_interval(fraction.y));
    const dvec2 g = 1.0 - f;
    return dvec4(g.x * g.y, f.x * g.y, g.x * f.y, f.x * f.y);
}

inline dvec4 gloam_validated_weights(dvec4 bilinear, glm::bvec4 valid) {
    dvec4 w(0.0, 0.0, 0.0, 0.0);
    for (int i = 0; i < 4; ++i) {
        if (valid[i]) w[i] = gloam_unit_interval(bilinear[i]);
    }
    const double sum = (w.x + w.y) + (w.z + w.w);
    if (!(sum >= float_min)) return dvec4(0.0);
    return min(w / sum, dvec4(1.0, 1.0, 1.0, 1.0));
}

}  // namespace gloam::reference
