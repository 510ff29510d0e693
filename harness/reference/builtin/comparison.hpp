// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

inline double builtin_float_of_int(int i) {
    return i;
}
inline double builtin_float_of_uint(unsigned i) {
    return i;
}
inline int builtin_int_of_float(double x) {
    return int(x);
}
inline unsigned builtin_uint_of_float(double x) {
    return unsigned(x);
}
inline bool builtin_isnan(double x) {
    return std::isnan(x);
}
inline bool builtin_isinf(double x) {
    return std::isinf(x);
}
inline bool builtin_less(double x, double y) {
    return x < y;
}
inline bool builtin_less_or_equal(double x, double y) {
    return x <= y;
}
inline bool builtin_equal(double x, double y) {
    return x == y;
}
inline bool builtin_not_equal(double x, double y) {
    return x != y;
}

}  // namespace gloam::reference
