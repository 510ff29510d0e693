// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
T gloam_gaussian(T squared_distance, T sigma) {
    const bool known = sigma >= T(0) || sigma < T(0);
    if (!(squared_distance <= float_max<T>()) || !known) return T(0);
    T d2 = T(0);
    if (squared_distance > T(0)) d2 = squared_distance;
    if (sigma > float_max<T>()) return T(1);
    if (sigma < float_min<T>()) return d2 > T(0) ? T(0) : T(1);
    const T exponent = d2 / (T(2) * sigma * sigma);
    if (exponent > T(69)) return T(0);
    return exp(-exponent);
}

template <class T>
T gloam_filter_sigma(T depth, T tan_half_fovy, T height, T sigma_pixels) {
    if (gloam_is_background(depth) || !(tan_half_fovy > T(0))) return T(0);
    if (!(height >= float_min<T>()) || !(sigma_pixels > T(0))) return T(0);
    const T pixel = T(2) * depth * tan_half_fovy / height;
    const T sigma = pixel * sigma_pixels;
    if (sigma > float_max<T>()) return float_max<T>();
    return sigma > T(0) ? sigma : T(0);
}

}  // namespace gloam::reference
