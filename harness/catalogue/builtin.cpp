// SPDX-License-Identifier: MIT
#include "reference/builtin.hpp"
#include "catalogue/builtin_parts.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/rooms.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

using One = float(float);
using Two = float(float, float);
using Three = float(float, float, float);
constexpr const char* exact = "correct result";
constexpr const char* rounded = "correctly rounded";
constexpr const char* arithmetic = "arithmetic.glsl";
constexpr const char* comparison = "comparison.glsl";

Values normal_floats() {
    return either(uniform(-4, 4), signed_log_uniform(1e-37, 1e38)).and_near({1.0, -1.0, 0.5, 16777216.0});
}

void append_rounding(Entries& entries) {
    const auto add = [&](const char* name, const char* expression, const char* rule, auto reference) {
        append_builtin<One>(
            entries, arithmetic, name, expression, rule, reference,
            {either(wide_floats(), signed_log_uniform(0.1, 1e8))
                 .and_near({0.5, 1.5, 2.5, -0.5, -1.5, 8388607.5, 8388608.0, 65504.0, 65520.0})});
    };
    add("negate", "-x", exact, &reference::builtin_negate);
    add("abs", "abs(x)", exact, &reference::builtin_abs);
    add("sign", "sign(x)", exact, &reference::builtin_sign);
    add("floor", "floor(x)", rounded, &reference::builtin_floor);
    add("ceil", "ceil(x)", rounded, &reference::builtin_ceil);
    add("fract", "fract(x)", rounded, &reference::builtin_fract);
    add("trunc", "trunc(x)", rounded, &reference::builtin_trunc);
    add("round", "round(x)", "correctly rounded, a half either way", &reference::builtin_round);
    add("round_even", "roundEven(x)", rounded, &reference::builtin_round_even);
    add("quantize", "unpackHalf2x16(packHalf2x16(vec2(x, 0))).x", "correctly rounded to float16",
        &reference::builtin_quantize);
}

void append_operators(Entries& entries) {
    const auto add = [&](const char* name, const char* expression, const char* rule, auto reference) {
        append_builtin<Two>(entries, arithmetic, name, expression, rule, reference,
                            Domain{wide_floats(), wide_floats()}.tied(0, 1).tied(0, 1, -1.0));
    };
    add("min", "min(x, y)", exact, &reference::builtin_min);
    add("max", "max(x, y)", exact, &reference::builtin_max);
    add("add", "x + y", rounded, &reference::builtin_add);
    add("subtract", "x - y", rounded, &reference::builtin_subtract);
    add("multiply", "x * y", rounded, &reference::builtin_multiply);
    add("divide", "x / y", "2.5 ulp for abs(y) in [2^-126, 2^126]", &reference::builtin_divide);
    add("mod", "mod(x, y)", "inherited from x - y floor(x / y)", &reference::builtin_mod);
}

// Without NaN, because the functions of GLSL.std.450 may assume that there is none.
void append_step(Entries& entries) {
    const Values number =
        either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_near({1.0, -1.0, 0x1p-126});
    append_builtin<Two>(entries, arithmetic, "step", "step(x, y)", rounded, &reference::builtin_step,
                        Domain{number, number}.tied(0, 1));
}

void append_ternary(Entries& entries) {
    const auto add = [&](const char* name, const char* expression, const char* rule, auto reference,
                         Domain domain) {
        append_builtin<Three>(entries, arithmetic, name, expression, rule, reference, std::move(domain));
    };
    const Values any = wide_floats();
    const Values part = either(uniform(-0.5, 1.5), any);
    add("clamp", "clamp(x, low, high)", exact, &reference::builtin_clamp,
        Domain{any, any, any}.tied(2, 1).tied(0, 2));
    add("fma", "fma(a, b, c)", "inherited from a multiply, then an add", &reference::builtin_fma,
        {any, any, any});
    add("mix", "mix(x, y, a)", "inherited from x (1 - a) + y a", &reference::builtin_mix, {any, any, part});
    add("smoothstep", "smoothstep(e0, e1, x)", "inherited from t t (3 - 2 t)", &reference::builtin_smoothstep,
        {part, part, part});
}

void append_parts(Entries& entries) {
    append_builtin<float(float, Out<float>)>(entries, arithmetic, "modf", "modf(x, whole)", rounded,
                                             &reference::builtin_modf,
                                             {either(normal_floats(), signed_log_uniform(0.1, 1e8))});
    append_builtin<float(float, Out<int>)>(entries, arithmetic, "frexp", "frexp(x, exponent)", exact,
                                           &reference::builtin_frexp, {normal_floats()});
    append_builtin<float(float, int)>(entries, arithmetic, "ldexp", "ldexp(x, exponent)", rounded,
                                      &reference::builtin_ldexp,
                                      {normal_floats(), either(integers(-10, 10), integers(-126, 127))});
}

}  // namespace

Values wide_floats() {
    return either(uniform(-2, 2), either(signed_log_uniform(1e-6, 1e6), any_float()))
        .and_near({0.5, 1.0, -1.0, 2.0, 0x1p-126, 0x1p126})
        .and_special();
}

void append_builtin_arithmetic(Entries& entries) {
    append_rounding(entries);
    append_operators(entries);
    append_step(entries);
    append_ternary(entries);
    append_parts(entries);
}

void append_builtin_comparisons(Entries& entries) {
    append_builtin<float(int)>(entries, comparison, "float_of_int", "float(i)", rounded,
                               &reference::builtin_float_of_int,
                               {either(integers(-2147483648L, 2147483647L), log_integers(2147483647))});
    append_builtin<float(unsigned)>(entries, comparison, "float_of_uint", "float(i)", rounded,
                                    &reference::builtin_float_of_uint,
                                    {either(integers(0, 4294967295L), log_integers(4294967295L))});
    append_builtin<int(float)>(
        entries, comparison, "int_of_float", "int(x)", "towards zero", &reference::builtin_int_of_float,
        {either(uniform(-9, 9), signed_log_uniform(0.1, 2e9)).and_near({1.0, -1.0, 16777216.0})});
    append_builtin<unsigned(float)>(
        entries, comparison, "uint_of_float", "uint(x)", "towards zero", &reference::builtin_uint_of_float,
        {either(uniform(0, 9), log_uniform(0.1, 2e9)).and_near({1.0, 16777216.0})});
    append_builtin<bool(float)>(entries, comparison, "isnan", "isnan(x)", exact, &reference::builtin_isnan,
                                {wide_floats()});
    append_builtin<bool(float)>(entries, comparison, "isinf", "isinf(x)", exact, &reference::builtin_isinf,
                                {wide_floats()});
    const auto compare = [&](const char* name, const char* expression, auto reference) {
        append_builtin<bool(float, float)>(entries, comparison, name, expression, exact, reference,
                                           Domain{wide_floats(), wide_floats()}.tied(0, 1));
    };
    compare("less", "x < y", &reference::builtin_less);
    compare("less_or_equal", "x <= y", &reference::builtin_less_or_equal);
    compare("equal", "x == y", &reference::builtin_equal);
    compare("not_equal", "x != y", &reference::builtin_not_equal);
}

void append_builtins(Entries& entries) {
    append_builtin_arithmetic(entries);
    append_builtin_comparisons(entries);
    append_builtin_elementary(entries);
    append_builtin_vectors(entries);
    append_probes(entries);
}

}  // namespace gloam::catalogue
