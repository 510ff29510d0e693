// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
T gloam_gaussian_scale(T sigma) {
    if (!(abs(sigma) >= T(0))) return infinity<T>();
    return sigma <= T(0x1p100) ? T(0.8493218002880191) / max(sigma, float_min<T>()) : T(0);
}

template <class T>
T gloam_gaussian_scaled(T squared_distance, T scale) {
    const T x = squared_distance * scale * scale;
    const T weight = min(exp2(-max(x, T(0))), T(1));
    return x <= T(99.5) ? weight : T(0);
}

template <class T>
T gloam_gaussian(T squared_distance, T sigma) {
    return gloam_gaussian_scaled(squared_distance, gloam_gaussian_scale(sigma));
}

template <class T>
T gloam_filter_sigma(T depth, T tan_half_fovy, T height, T sigma_pixels) {
    const bool known = tan_half_fovy > T(0) && height >= float_min<T>() && sigma_pixels > T(0);
    if (gloam_is_background(depth) || !known) return T(0);
    const T sigma = T(2) * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= float_max<T>() ? sigma : (sigma > T(0) ? float_max<T>() : T(0));
}

}  // namespace gloam::reference
