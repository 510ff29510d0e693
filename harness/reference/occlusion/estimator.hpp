// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline dvec2 gloam_estimator_add(dvec2 accumulated, double contribution) {
    if (!gloam_is_finite(contribution)) return accumulated;
    return accumulated + dvec2(contribution, 1.0);
}

inline double gloam_weighted_ratio(dvec2 weighted) {
    if (!(weighted.y >= float_min && weighted.x > 0.0)) return 0.0;
    return weighted.x < weighted.y ? min(weighted.x / weighted.y, 1.0) : 1.0;
}

inline double gloam_estimator_mean(dvec2 accumulated) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 0.0;
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, 1.0) : 1.0;
}

inline dvec2 gloam_estimator_of_weighted(dvec2 weighted, unsigned count) {
    return double(count) * dvec2(gloam_weighted_ratio(weighted), 1.0);
}

}  // namespace gloam::reference
