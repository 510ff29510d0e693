// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec2 gloam_estimator_add(dvec2 accumulated, double contribution) {
    return is_finite(contribution) ? accumulated + dvec2(contribution, 1.0) : accumulated;
}

inline double gloam_weighted_ratio(dvec2 weighted) {
    if (!(weighted.y >= float_min && weighted.x > 0.0)) return 0.0;
    return weighted.x < weighted.y ? weighted.x / weighted.y : 1.0;
}

inline double gloam_estimator_mean(dvec2 accumulated) {
    return accumulated.y >= 1.0 ? gloam_weighted_ratio(accumulated) : 0.0;
}

inline dvec2 gloam_estimator_of_weighted(dvec2 weighted, unsigned count) {
    return {count * gloam_weighted_ratio(weighted), count};
}

}  // namespace gloam::reference
