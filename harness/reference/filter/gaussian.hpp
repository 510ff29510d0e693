// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
T gloam_gaussian(T squared_distance, T sigma) {
    const T d2 = squared_distance > T(0) ? squared_distance : T(0);
    if (!(squared_distance <= float_max<T>()) || !(abs(sigma) >= T(0))) return T(0);
    if (sigma > float_max<T>()) return T(1);
    if (!(sigma >= float_min<T>())) return d2 > T(0) ? T(0) : T(1);
    const T x = T(0.5) * (d2 / sigma) / sigma;
    return x <= T(69) ? min(exp(-x), T(1)) : T(0);
}

template <class T>
T gloam_filter_sigma(T depth, T tan_half_fovy, T height, T sigma_pixels) {
    const bool known = tan_half_fovy > T(0) && height >= float_min<T>() && sigma_pixels > T(0);
    if (gloam_is_background(depth) || !known) return T(0);
    const T sigma = T(2) * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= float_max<T>() ? sigma : (sigma > T(0) ? float_max<T>() : T(0));
}

}  // namespace gloam::reference
