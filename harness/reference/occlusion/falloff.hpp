// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {
namespace detail {

// A falloff of x = d / R < 1; nothing is left from R on, and an infinite R has x = 0.
template <class T, class Falloff>
T falloff_within(T hit_distance, T radius, Falloff falloff) {
    const T d = abs(hit_distance);
    if (!(d < radius) || radius < float_min<T>()) return T(0);
    if (radius > float_max<T>()) return falloff(T(0));
    return falloff(d / radius);
}

}  // namespace detail

template <class T>
T gloam_falloff_step(T hit_distance, T radius) {
    if (abs(hit_distance) <= radius) return T(1);
    return T(0);
}

template <class T>
T gloam_falloff_linear(T hit_distance, T radius) {
    return detail::falloff_within(hit_distance, radius, [](T x) { return T(1) - x; });
}

template <class T>
T gloam_falloff_quadratic(T hit_distance, T radius) {
    return detail::falloff_within(hit_distance, radius, [](T x) { return T(1) - x * x; });
}

template <class T>
T gloam_falloff_cubic(T hit_distance, T radius) {
    return detail::falloff_within(hit_distance, radius, [](T x) { return T(1) - x * x * x; });
}

template <class T>
T gloam_falloff_sao(T hit_distance, T radius) {
    return detail::falloff_within(hit_distance, radius, [](T x) {
        const T y = T(1) - x * x;
        return y * y * y;
    });
}

template <class T>
T gloam_falloff_exponential(T hit_distance, T radius) {
    const T d = abs(hit_distance);
    if (!(d <= float_max<T>()) || !(radius >= float_min<T>())) return T(0);
    if (radius > float_max<T>()) return T(1);
    const T weight = exp(-d / radius);
    if (weight < T(1) / T(255)) return T(0);
    return weight;
}

template <class T>
T gloam_falloff_alchemy(T hit_distance, T u) {
    const T d = abs(hit_distance);
    if (!(d <= float_max<T>()) || !(u >= float_min<T>() && u <= float_max<T>())) return T(0);
    const T larger = max(u, d);
    return u / larger * (d / larger);
}

template <class T>
T gloam_falloff_one(T hit_distance) {
    if (abs(hit_distance) >= T(0)) return T(1);
    return T(0);
}

template <class T>
T gloam_visibility_filion(T delta, T radius) {
    if (!(delta >= float_min<T>()) || !(radius >= float_min<T>())) return T(1);
    if (delta <= radius) return T(0);
    if (delta > float_max<T>()) return T(1);
    return T(1) - radius / delta;
}

}  // namespace gloam::reference
