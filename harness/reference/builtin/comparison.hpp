// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

template <class T>
T builtin_float_of_int(int i) {
    return T(i);
}
template <class T>
T builtin_float_of_uint(unsigned i) {
    return T(i);
}
template <class T>
int builtin_int_of_float(T x) {
    return to_int(x);
}
template <class T>
unsigned builtin_uint_of_float(T x) {
    return static_cast<unsigned>(to_int(x));
}
template <class T>
bool builtin_isnan(T x) {
    return is_nan(x);
}
template <class T>
bool builtin_isinf(T x) {
    return is_infinite(x);
}
template <class T>
bool builtin_less(T x, T y) {
    return x < y;
}
template <class T>
bool builtin_less_or_equal(T x, T y) {
    return x <= y;
}
template <class T>
bool builtin_equal(T x, T y) {
    return x == y;
}
template <class T>
bool builtin_not_equal(T x, T y) {
    return x != y;
}

}  // namespace gloam::reference
