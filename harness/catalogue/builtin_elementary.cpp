// SPDX-License-Identifier: MIT
#include "catalogue/builtin_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/builtin.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* elementary = "elementary.glsl";

void append_exponentials(Entries& entries) {
    const auto add = [&](const char* name, const char* expression, const char* rule, auto reference,
                         const Values& values) {
        append_builtin<float(float)>(entries, elementary, name, expression, rule, reference,
                                     {either(values, wide_floats())});
    };
    const Values positive = either(uniform(0, 4), log_uniform(1e-37, 1e38));
    add("exp", "exp(x)", "3 + 2 abs(x) ulp", &reference::builtin_exp, uniform(-90, 90));
    add("exp2", "exp2(x)", "3 + 2 abs(x) ulp", &reference::builtin_exp2, uniform(-130, 130));
    add("log", "log(x)", "3 ulp outside [0.5, 2], 2^-21 inside", &reference::builtin_log, positive);
    add("log2", "log2(x)", "3 ulp outside [0.5, 2], 2^-21 inside", &reference::builtin_log2, positive);
    add("inversesqrt", "inversesqrt(x)", "2 ulp", &reference::builtin_inversesqrt, positive);
    add("sqrt", "sqrt(x)", "inherited from 1 / inversesqrt(x)", &reference::builtin_sqrt, positive);
    append_builtin<float(float, float)>(
        entries, elementary, "pow", "pow(x, y)", "inherited from exp2(y log2(x))", &reference::builtin_pow,
        {either(positive, wide_floats()), either(uniform(-16, 16), wide_floats())});
}

void append_trigonometry(Entries& entries) {
    const auto add = [&](const char* name, const char* expression, const char* rule, auto reference,
                         const Values& values) {
        append_builtin<float(float)>(
            entries, elementary, name, expression, rule, reference,
            {either(values, wide_floats()).and_near({3.14159265, -3.14159265, 1.57079633})});
    };
    const Values angle = uniform(-3.1415927, 3.1415927);
    const Values ratio = uniform(-1, 1);
    add("radians", "radians(x)", "x times the rounded constant", &reference::builtin_radians,
        uniform(-720, 720));
    add("degrees", "degrees(x)", "x times the rounded constant", &reference::builtin_degrees, angle);
    add("sin", "sin(x)", "2^-11 absolute in [-pi, pi], nothing outside", &reference::builtin_sin, angle);
    add("cos", "cos(x)", "2^-11 absolute in [-pi, pi], nothing outside", &reference::builtin_cos, angle);
    add("tan", "tan(x)", "inherited from sin(x) / cos(x)", &reference::builtin_tan, angle);
    add("asin", "asin(x)", "inherited from atan(x, sqrt(1 - x x))", &reference::builtin_asin, ratio);
    add("acos", "acos(x)", "inherited from atan(sqrt(1 - x x), x)", &reference::builtin_acos, ratio);
    add("atan", "atan(x)", "4096 ulp", &reference::builtin_atan, ratio);
    add("sinh", "sinh(x)", "inherited from (exp(x) - exp(-x)) / 2", &reference::builtin_sinh, uniform(-9, 9));
    add("cosh", "cosh(x)", "inherited from (exp(x) + exp(-x)) / 2", &reference::builtin_cosh, uniform(-9, 9));
    add("tanh", "tanh(x)", "inherited from sinh(x) / cosh(x)", &reference::builtin_tanh, uniform(-9, 9));
    append_builtin<float(float, float)>(entries, elementary, "atan2", "atan(y, x)", "4096 ulp",
                                        &reference::builtin_atan2,
                                        Domain{wide_floats(), wide_floats()}.tied(0, 1));
}

}  // namespace

void append_builtin_elementary(Entries& entries) {
    append_exponentials(entries);
    append_trigonometry(entries);
}

}  // namespace gloam::catalogue
