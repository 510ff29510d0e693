// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/length_ratio.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
T gloam_asin_half(T x) {
    if constexpr (exact_number<T>) return asin(x);
    const T z = x * x;
    return x + (x * z) * (T(0.166667521) +
                          z * (T(0.0749529749) +
                               z * (T(0.0454703756) + z * (T(0.0241795145) + z * T(0.0421663076)))));
}

template <class T>
T gloam_unit_magnitude(T x) {
    const T magnitude = abs(x);
    return magnitude <= T(1) ? magnitude : (magnitude > T(1) ? T(1) : T(0));
}

template <class T>
T gloam_small_arc(T m) {
    return gloam_asin_half(m > T(0.5) ? gloam_sqrt(T(0.5) * (T(1) - m)) : m);
}

template <class T>
T gloam_acos(T x) {
    const T m = gloam_unit_magnitude(x);
    if constexpr (exact_number<T>) return acos(x < T(0) ? -m : m);
    const T arc = gloam_small_arc(m);
    if (m > T(0.5)) return x < T(0) ? T(3.141592654) - T(2) * arc : T(2) * arc;
    return T(1.570796327) - (x < T(0) ? -arc : arc);
}

template <class T>
T gloam_asin(T x) {
    const T m = gloam_unit_magnitude(x);
    if constexpr (exact_number<T>) return asin(x < T(0) ? -m : m);
    const T arc = gloam_small_arc(m);
    const T angle = m > T(0.5) ? T(1.570796327) - T(2) * arc : arc;
    return x < T(0) ? -angle : angle;
}

namespace detail {

// atan(r) for r in [0, 1].
template <class T>
T unit_arc_tangent(T r) {
    if constexpr (exact_number<T>) return atan(r);
    const T z = r * r;
    const T tail = T(-0.0755221471) + z * (T(0.0432118662) + z * (T(-0.0163679309) + z * T(0.00292069302)));
    return r + (r * z) * (T(-0.333331525) +
                          z * (T(0.199937731) + z * (T(-0.142110556) + z * (T(0.106660046) + z * tail))));
}

}  // namespace detail

template <class T>
T gloam_atan2(T y, T x) {
    const T across = abs(x);
    const T up = abs(y);
    const bool steep = up > across;
    const T larger = steep ? up : across;
    const T smaller = steep ? across : up;
    if (!(larger >= float_min<T>() && smaller >= T(0))) return T(0);
    T angle = detail::unit_arc_tangent(gloam_length_ratio(smaller, larger));
    const T half = exact_number<T> ? pi<T>() / T(2) : T(1.570796327);
    const T whole = exact_number<T> ? pi<T>() : T(3.141592654);
    if (steep) {
        angle = x < T(0) ? half + angle : half - angle;
    } else if (x < T(0)) {
        angle = whole - angle;
    }
    return y < T(0) ? -angle : angle;
}

template <class T>
T gloam_atan(T x) {
    return gloam_atan2(x, T(1));
}

}  // namespace gloam::reference
