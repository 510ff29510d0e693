// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

template <class T>
T builtin_exp(T x) {
    return exp(x);
}
template <class T>
T builtin_exp2(T x) {
    return exp2(x);
}
template <class T>
T builtin_log(T x) {
    return log(x);
}
template <class T>
T builtin_log2(T x) {
    return log2(x);
}
template <class T>
T builtin_inversesqrt(T x) {
    return inversesqrt(x);
}
template <class T>
T builtin_sqrt(T x) {
    return sqrt(x);
}
template <class T>
T builtin_radians(T x) {
    return radians(x);
}
template <class T>
T builtin_degrees(T x) {
    return degrees(x);
}
template <class T>
T builtin_sin(T x) {
    return sin(x);
}
template <class T>
T builtin_cos(T x) {
    return cos(x);
}
template <class T>
T builtin_tan(T x) {
    return tan(x);
}
template <class T>
T builtin_asin(T x) {
    return asin(x);
}
template <class T>
T builtin_acos(T x) {
    return acos(x);
}
template <class T>
T builtin_atan(T x) {
    return atan(x);
}
template <class T>
T builtin_sinh(T x) {
    return sinh(x);
}
template <class T>
T builtin_cosh(T x) {
    return cosh(x);
}
template <class T>
T builtin_tanh(T x) {
    return tanh(x);
}
template <class T>
T builtin_pow(T x, T y) {
    return pow(x, y);
}
template <class T>
T builtin_atan2(T y, T x) {
    return atan(y, x);
}

}  // namespace gloam::reference
