// SPDX-License-Identifier: MIT
// GLSL's own operators and functions (glsl/builtin), judged by Vulkan's precision rules alone.
#include "reference/builtin.hpp"
#include "catalogue/inputs.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

void by_rules(Entries& entries, const std::string& id, auto reference, Domain domain) {
    add(entries, id, reference, {.domain = std::move(domain), .only_rules = true});
}
void builtin(Entries& entries, const std::string& name, auto reference, Domain domain) {
    by_rules(entries, "BUILTIN-" + name, reference, std::move(domain));
}

// Floats of every kind: ordinary ones, any bit pattern, special values, and turning points of functions.
Values wide_floats() {
    return either(uniform(-2, 2), either(signed_log_uniform(1e-6, 1e6), any_float()))
        .and_near({0.5, 1.0, -1.0, 2.0, 0x1p-126, 0x1p126})
        .and_special();
}
Values normal_floats() {
    return either(uniform(-4, 4), signed_log_uniform(1e-37, 1e38)).and_near({1.0, -1.0, 0.5, 16777216.0});
}

void append_rounding(Entries& entries) {
    const Domain number{either(wide_floats(), signed_log_uniform(0.1, 1e8))
                            .and_near({0.5, 1.5, 2.5, -0.5, -1.5, 8388607.5, 8388608.0, 65504.0, 65520.0})};
    builtin(entries, "negate", &reference::builtin_negate, number);
    builtin(entries, "abs", &reference::builtin_abs, number);
    builtin(entries, "sign", &reference::builtin_sign, number);
    builtin(entries, "floor", &reference::builtin_floor, number);
    builtin(entries, "ceil", &reference::builtin_ceil, number);
    builtin(entries, "fract", &reference::builtin_fract, number);
    builtin(entries, "trunc", &reference::builtin_trunc, number);
    builtin(entries, "round", &reference::builtin_round, number);
    builtin(entries, "round_even", &reference::builtin_round_even, number);
    builtin(entries, "quantize", &reference::builtin_quantize, number);
}

void append_operators(Entries& entries) {
    const Domain two = Domain{wide_floats(), wide_floats()}.tied(0, 1).tied(0, 1, -1.0);
    builtin(entries, "min", &reference::builtin_min, two);
    builtin(entries, "max", &reference::builtin_max, two);
    builtin(entries, "add", &reference::builtin_add, two);
    builtin(entries, "subtract", &reference::builtin_subtract, two);
    builtin(entries, "multiply", &reference::builtin_multiply, two);
    builtin(entries, "divide", &reference::builtin_divide, two);
    builtin(entries, "mod", &reference::builtin_mod, two);
    // Without NaN, because the functions of GLSL.std.450 may assume that there is none.
    const Values number =
        either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_near({1.0, -1.0, 0x1p-126});
    builtin(entries, "step", &reference::builtin_step, Domain{number, number}.tied(0, 1));
}

void append_ternary(Entries& entries) {
    const Values any = wide_floats();
    const Values part = either(uniform(-0.5, 1.5), any);
    builtin(entries, "clamp", &reference::builtin_clamp, Domain{any, any, any}.tied(2, 1).tied(0, 2));
    builtin(entries, "fma", &reference::builtin_fma, {any, any, any});
    builtin(entries, "mix", &reference::builtin_mix, {any, any, part});
    builtin(entries, "smoothstep", &reference::builtin_smoothstep, {part, part, part});
}

void append_parts(Entries& entries) {
    builtin(entries, "modf", &reference::builtin_modf,
            {either(normal_floats(), signed_log_uniform(0.1, 1e8))});
    builtin(entries, "frexp", &reference::builtin_frexp, {normal_floats()});
    builtin(entries, "ldexp", &reference::builtin_ldexp,
            {normal_floats(), either(integers(-10, 10), integers(-126, 127))});
}

void append_conversions(Entries& entries) {
    builtin(entries, "float_of_int", &reference::builtin_float_of_int,
            {either(integers(-2147483648L, 2147483647L), log_integers(2147483647))});
    builtin(entries, "float_of_uint", &reference::builtin_float_of_uint,
            {either(integers(0, 4294967295L), log_integers(4294967295L))});
    builtin(entries, "int_of_float", &reference::builtin_int_of_float,
            {either(uniform(-9, 9), signed_log_uniform(0.1, 2e9)).and_near({1.0, -1.0, 16777216.0})});
    builtin(entries, "uint_of_float", &reference::builtin_uint_of_float,
            {either(uniform(0, 9), log_uniform(0.1, 2e9)).and_near({1.0, 16777216.0})});
}

void append_comparisons(Entries& entries) {
    builtin(entries, "isnan", &reference::builtin_isnan, {wide_floats()});
    builtin(entries, "isinf", &reference::builtin_isinf, {wide_floats()});
    const Domain two = Domain{wide_floats(), wide_floats()}.tied(0, 1);
    builtin(entries, "less", &reference::builtin_less, two);
    builtin(entries, "less_or_equal", &reference::builtin_less_or_equal, two);
    builtin(entries, "equal", &reference::builtin_equal, two);
    builtin(entries, "not_equal", &reference::builtin_not_equal, two);
}

void append_exponentials(Entries& entries) {
    const auto of = [](const Values& values) { return Domain{either(values, wide_floats())}; };
    const Values positive = either(uniform(0, 4), log_uniform(1e-37, 1e38));
    builtin(entries, "exp", &reference::builtin_exp, of(uniform(-90, 90)));
    builtin(entries, "exp2", &reference::builtin_exp2, of(uniform(-130, 130)));
    builtin(entries, "log", &reference::builtin_log, of(positive));
    builtin(entries, "log2", &reference::builtin_log2, of(positive));
    builtin(entries, "inversesqrt", &reference::builtin_inversesqrt, of(positive));
    builtin(entries, "sqrt", &reference::builtin_sqrt, of(positive));
    builtin(entries, "pow", &reference::builtin_pow,
            {either(positive, wide_floats()), either(uniform(-16, 16), wide_floats())});
}

void append_trigonometry(Entries& entries) {
    const auto of = [](const Values& values) {
        return Domain{either(values, wide_floats()).and_near({3.14159265, -3.14159265, 1.57079633})};
    };
    const Domain angle = of(uniform(-3.1415927, 3.1415927));
    const Domain ratio = of(uniform(-1, 1));
    const Domain exponent = of(uniform(-9, 9));
    builtin(entries, "radians", &reference::builtin_radians, of(uniform(-720, 720)));
    builtin(entries, "degrees", &reference::builtin_degrees, angle);
    builtin(entries, "sin", &reference::builtin_sin, angle);
    builtin(entries, "cos", &reference::builtin_cos, angle);
    builtin(entries, "tan", &reference::builtin_tan, angle);
    builtin(entries, "asin", &reference::builtin_asin, ratio);
    builtin(entries, "acos", &reference::builtin_acos, ratio);
    builtin(entries, "atan", &reference::builtin_atan, ratio);
    builtin(entries, "sinh", &reference::builtin_sinh, exponent);
    builtin(entries, "cosh", &reference::builtin_cosh, exponent);
    builtin(entries, "tanh", &reference::builtin_tanh, exponent);
    builtin(entries, "atan2", &reference::builtin_atan2, Domain{wide_floats(), wide_floats()}.tied(0, 1));
}

Values vectors() {
    return either(vector(3, uniform(-2, 2)), vector(3, signed_log_uniform(1e-12, 1e12))).and_special();
}
template <class Matrix>
Values matrices() {
    return made_by<Matrix>([](numeric::Random& random) {
        Matrix m(1.0F);
        for (glm::length_t column = 0; column < Matrix::length(); ++column) {
            for (glm::length_t row = 0; row < Matrix::length(); ++row) {
                m[column][row] = static_cast<float>(random.uniform(-2, 2));
            }
        }
        return m;
    });
}

void append_vectors(Entries& entries) {
    const Values v = vectors();
    builtin(entries, "dot", &reference::builtin_dot, {v, v});
    builtin(entries, "length", &reference::builtin_length, {v});
    builtin(entries, "distance", &reference::builtin_distance, {v, v});
    builtin(entries, "normalize", &reference::builtin_normalize, {v});
    builtin(entries, "cross", &reference::builtin_cross, {v, v});
    builtin(entries, "reflect", &reference::builtin_reflect, {v, v});
    builtin(entries, "refract", &reference::builtin_refract,
            {unit_vector(3), unit_vector(3), uniform(0.5, 2)});
    builtin(entries, "faceforward", &reference::builtin_faceforward, {v, v, v});
}

void append_matrices(Entries& entries) {
    const Values m = matrices<glm::mat3>();
    builtin(entries, "matrix_vector", &reference::builtin_matrix_vector, {m, vectors()});
    builtin(entries, "vector_matrix", &reference::builtin_vector_matrix, {vectors(), m});
    builtin(entries, "matrix_matrix", &reference::builtin_matrix_matrix, {m, m});
    builtin(entries, "matrix4_vector", &reference::builtin_matrix4_vector,
            {matrices<glm::mat4>(), vector(4, uniform(-2, 2))});
    builtin(entries, "outer_product", &reference::builtin_outer_product, {vectors(), vectors()});
    builtin(entries, "determinant", &reference::builtin_determinant, {m});
    builtin(entries, "inverse", &reference::builtin_inverse, {m});
}

// (a, b, c): c is set to the rounded product of a and b.
Domain products() {
    const Values factor = uniform(1, 2);
    return Domain{factor, factor, constant(0.0F)}.adjusted([](std::span<Word> words) {
        words[2] = to_word(from_word<float>(words[0]) * from_word<float>(words[1]));
    });
}

// Defects met in drivers and compilers.
void append_probes(Entries& entries) {
    by_rules(entries, "PROBE-isnan", &reference::probe_isnan_of_difference, {wide_floats()});
    by_rules(entries, "PROBE-self", &reference::probe_differs_from_itself, {wide_floats()});
    by_rules(entries, "PROBE-contraction", &reference::probe_contraction, products());
    by_rules(entries, "PROBE-precise-struct", &reference::probe_precise_in_struct, products());
    by_rules(entries, "PROBE-fma", &reference::probe_fma_rounding, products());
    by_rules(entries, "PROBE-folded-exp", &reference::probe_folded_exp, {constant(0.5F)});
    by_rules(entries, "PROBE-folded-sin", &reference::probe_folded_sin, {constant(0.5F)});
    const Values zero = constant(0.0F).and_value(-0.0F);
    by_rules(entries, "PROBE-pow", &reference::probe_pow_of_zeros, {zero, zero});
    by_rules(entries, "PROBE-normalize-sign", &reference::probe_normalize_sign,
             {vector(3, uniform(-1, 1).and_value(-0.0F).and_value(0.0F))});
    by_rules(entries, "PROBE-remainder", &reference::probe_integer_remainder,
             {either(integers(1, 100), integers(1, 2147483647))});
}

}  // namespace

void append_builtins(Entries& entries) {
    append_rounding(entries);
    append_operators(entries);
    append_ternary(entries);
    append_parts(entries);
    append_conversions(entries);
    append_comparisons(entries);
    append_exponentials(entries);
    append_trigonometry(entries);
    append_vectors(entries);
    append_matrices(entries);
    append_probes(entries);
}

}  // namespace gloam::catalogue
