// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

// What the probes should return; where Vulkan leaves it open, the reference in double says what one would
// wish.
namespace gloam::reference {

template <class T>
bool probe_isnan_of_difference(T x) {
    return is_nan(T(x - x));
}
template <class T>
bool probe_differs_from_itself(T x) {
    return is_nan(x);
}
template <class T>
T probe_contraction(T, T, T) {
    return unspecified(T(0));
}
template <class T>
T probe_precise_in_struct(T, T, T) {
    return unspecified(T(0));
}
template <class T>
T probe_fma_rounding(T, T, T) {
    return unspecified(T(0));
}
// Bit i: component i has its sign bit set.
template <class T>
T probe_normalize_sign([[maybe_unused]] vec3<T> v) {
    T bits = T(0);
    if constexpr (builtin_number<T>) {
        for (int i = 0; i < 3; ++i) bits = bits + T(std::signbit(v[i]) ? 1 << i : 0);
    }
    return unspecified(bits);
}
template <class T>
T probe_folded_exp(T half) {
    return exp(T(0.5)) - exp(half);
}
template <class T>
T probe_folded_sin(T half) {
    return sin(T(0.5)) - sin(half);
}
template <class T>
T probe_pow_of_zeros(T x, T y) {
    return pow(x, y);
}
template <class T>
int probe_integer_remainder(int) {
    return 0;
}

}  // namespace gloam::reference
