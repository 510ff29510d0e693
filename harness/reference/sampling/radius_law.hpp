// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_radius_linear(T zeta) {
    return gloam_unit_interval(zeta);
}

template <class T>
T gloam_radius_quadratic(T zeta) {
    return gloam_sqrt(gloam_unit_interval(zeta));
}

template <class T>
T gloam_radius_cubic(T zeta) {
    const T x = gloam_unit_interval(zeta);
    if (x < float_min<T>()) return T(0);
    if constexpr (exact_number<T>) return cbrt(x);
    const T root = exp2(log2(x) * T(0.333333333));
    return root - (root - x / (root * root)) * T(0.333333333);
}

}  // namespace gloam::reference
