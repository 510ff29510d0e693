// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

// What the probes should return; where Vulkan leaves it open, the reference in double says what one would
// wish.
namespace gloam::reference {

inline bool probe_isnan_of_difference(double x) {
    return std::isnan(x - x);
}
inline bool probe_differs_from_itself(double x) {
    return std::isnan(x);
}
inline double probe_contraction(double, double, double) {
    return 0.0;
}
inline double probe_precise_in_struct(double, double, double) {
    return 0.0;
}
inline double probe_fma_rounding(double, double, double) {
    return 0.0;
}
// Bit i: component i has its sign bit set.
inline double probe_normalize_sign(dvec3 v) {
    return std::signbit(v.x) * 1.0 + std::signbit(v.y) * 2.0 + std::signbit(v.z) * 4.0;
}
inline double probe_folded_exp(double half) {
    return exp(0.5) - exp(half);
}
inline double probe_folded_sin(double half) {
    return sin(0.5) - sin(half);
}
inline double probe_pow_of_zeros(double x, double y) {
    return pow(x, y);
}
inline int probe_integer_remainder(int) {
    return 0;
}

}  // namespace gloam::reference
