// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {
namespace detail {

// A power of two that keeps differences of lengths of that size normal, and quotients where division is
// accurate.
template <class T>
T divisible_scale(T size) {
    if (size > T(1.8446744e19)) return T(5.421010862427522e-20);
    return size < T(5.421010862427522e-20) ? T(1.8446744073709552e19) : T(1);
}

}  // namespace detail

template <class T>
T gloam_falloff_step(T hit_distance, T radius) {
    return abs(hit_distance) <= radius ? T(1) : T(0);
}

template <class T>
T gloam_falloff_linear(T hit_distance, T radius) {
    const T d = abs(hit_distance);
    if (!(d < radius && radius >= float_min<T>())) return T(0);
    if (!(radius <= float_max<T>())) return T(1);
    const T scale = detail::divisible_scale(radius);
    const T r = radius * scale;
    return min((r - d * scale) / r, T(1));
}

template <class T>
T gloam_falloff_quadratic(T hit_distance, T radius) {
    const T a = gloam_falloff_linear(hit_distance, radius);
    return min(a * (T(2) - a), T(1));
}

template <class T>
T gloam_falloff_cubic(T hit_distance, T radius) {
    const T a = gloam_falloff_linear(hit_distance, radius);
    return min(a * (T(3) - a * (T(3) - a)), T(1));
}

template <class T>
T gloam_falloff_sao(T hit_distance, T radius) {
    const T b = gloam_falloff_quadratic(hit_distance, radius);
    return b * b * b;
}

template <class T>
T gloam_falloff_exponential(T hit_distance, T radius) {
    const T d = abs(hit_distance);
    if (!(d <= float_max<T>() && radius >= float_min<T>())) return T(0);
    if (!(radius <= float_max<T>())) return T(1);
    const T scale = detail::divisible_scale(radius);
    const T r = radius * scale;
    const T scaled = d * scale;
    return scaled <= T(5.541263545) * r ? min(exp(-(scaled / r)), T(1)) : T(0);
}

template <class T>
T gloam_falloff_alchemy(T hit_distance, T u) {
    const T d = abs(hit_distance);
    if (!(d <= float_max<T>() && u >= float_min<T>() && u <= float_max<T>())) return T(0);
    const bool nearer = d < u;
    const T smaller = nearer ? d : u;
    const T larger = nearer ? u : d;
    const T scale = detail::divisible_scale(larger);
    return min(smaller * scale / (larger * scale), T(1));
}

template <class T>
T gloam_falloff_one(T hit_distance) {
    return abs(hit_distance) >= T(0) ? T(1) : T(0);
}

template <class T>
T gloam_visibility_filion(T delta, T radius) {
    if (!(delta >= float_min<T>() && radius >= float_min<T>())) return T(1);
    return gloam_falloff_linear(radius, delta);
}

}  // namespace gloam::reference
