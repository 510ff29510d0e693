// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

namespace gloam::reference {

inline double builtin_exp(double x) {
    return exp(x);
}
inline double builtin_exp2(double x) {
    return exp2(x);
}
inline double builtin_log(double x) {
    return log(x);
}
inline double builtin_log2(double x) {
    return log2(x);
}
inline double builtin_inversesqrt(double x) {
    return 1.0 / sqrt(x);
}
inline double builtin_sqrt(double x) {
    return sqrt(x);
}
inline double builtin_radians(double x) {
    return glm::radians(x);
}
inline double builtin_degrees(double x) {
    return glm::degrees(x);
}
inline double builtin_sin(double x) {
    return sin(x);
}
inline double builtin_cos(double x) {
    return cos(x);
}
inline double builtin_tan(double x) {
    return tan(x);
}
inline double builtin_asin(double x) {
    return asin(x);
}
inline double builtin_acos(double x) {
    return acos(x);
}
inline double builtin_atan(double x) {
    return atan(x);
}
inline double builtin_sinh(double x) {
    return std::sinh(x);
}
inline double builtin_cosh(double x) {
    return std::cosh(x);
}
inline double builtin_tanh(double x) {
    return std::tanh(x);
}
inline double builtin_pow(double x, double y) {
    return pow(x, y);
}
inline double builtin_atan2(double y, double x) {
    return std::atan2(y, x);
}

}  // namespace gloam::reference
