// SPDX-License-Identifier: MIT
// GLSL's own operators and functions (glsl/builtin), judged by Vulkan's precision rules alone.
#include <functional>

#include "catalogue/inputs.hpp"
#include "reference/builtin.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;
using reference::dmat3, reference::dvec3;

void by_rules(Entries& entries, const std::string& id, auto reference, const Domain& domain) {
    add(entries, id, reference, domain).only_rules = true;
}
void builtin(Entries& entries, const std::string& name, auto reference, const Domain& domain) {
    by_rules(entries, "BUILTIN-" + name, reference, domain);
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

// Functions of one number.
using Functions = std::initializer_list<std::pair<const char*, double (*)(double)>>;
void builtins(Entries& entries, const Functions& functions, const Domain& domain) {
    for (const auto& [name, reference] : functions) builtin(entries, name, reference, domain);
}

void append_rounding(Entries& entries) {
    const Domain number{either(wide_floats(), signed_log_uniform(0.1, 1e8))
                            .and_near({0.5, 1.5, 2.5, -0.5, -1.5, 8388607.5, 8388608.0, 65504.0, 65520.0})};
    builtins(entries,
             {{"negate", [](double x) { return -x; }},
              {"abs", std::abs},
              {"sign", [](double x) { return glm::sign(x); }},
              {"floor", std::floor},
              {"ceil", std::ceil},
              {"fract", reference::fract},
              {"trunc", std::trunc},
              {"round", std::round},
              {"round_even", reference::round_even},
              {"quantize", reference::quantize_to_half}},
             number);
}

void append_operators(Entries& entries) {
    const Domain two = Domain{wide_floats(), wide_floats()}.tied(0, 1).tied(0, 1, -1.0);
    builtin(entries, "min", [](double x, double y) { return glm::min(x, y); }, two);
    builtin(entries, "max", [](double x, double y) { return glm::max(x, y); }, two);
    builtin(entries, "add", std::plus<double>(), two);
    builtin(entries, "subtract", std::minus<double>(), two);
    builtin(entries, "multiply", std::multiplies<double>(), two);
    builtin(entries, "divide", std::divides<double>(), two);
    builtin(entries, "mod", [](double x, double y) { return glm::mod(x, y); }, two);
    // Without NaN, because the functions of GLSL.std.450 may assume that there is none.
    const Values number =
        either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_near({1.0, -1.0, 0x1p-126});
    const auto step = [](double edge, double x) { return glm::step(edge, x); };
    builtin(entries, "step", step, Domain{number, number}.tied(0, 1));
    const Values any = wide_floats();
    const Values part = either(uniform(-0.5, 1.5), any);
    const auto clamp = [](double x, double low, double high) { return glm::clamp(x, low, high); };
    builtin(entries, "clamp", clamp, Domain{any, any, any}.tied(2, 1).tied(0, 2));
    builtin(entries, "fma", [](double a, double b, double c) { return std::fma(a, b, c); }, {any, any, any});
    builtin(entries, "mix", [](double x, double y, double a) { return glm::mix(x, y, a); }, {any, any, part});
    const auto smoothstep = [](double a, double b, double x) { return glm::smoothstep(a, b, x); };
    builtin(entries, "smoothstep", smoothstep, {part, part, part});
}

void append_parts(Entries& entries) {
    const auto modf = [](double x, double& whole) {
        whole = std::trunc(x);
        return x - whole;
    };
    builtin(entries, "modf", modf, {either(normal_floats(), signed_log_uniform(0.1, 1e8))});
    const auto frexp = [](double x, int& exponent) { return std::frexp(x, &exponent); };
    builtin(entries, "frexp", frexp, {normal_floats()});
    builtin(entries, "ldexp", [](double x, int exponent) { return std::ldexp(x, exponent); },
            {normal_floats(), either(integers(-10, 10), integers(-126, 127))});
    builtin(entries, "float_of_int", [](int i) { return static_cast<double>(i); },
            {either(integers(-2147483648L, 2147483647L), log_integers(2147483647))});
    builtin(entries, "float_of_uint", [](unsigned i) { return static_cast<double>(i); },
            {either(integers(0, 4294967295L), log_integers(4294967295L))});
    builtin(entries, "int_of_float", [](double x) { return static_cast<int>(x); },
            {either(uniform(-9, 9), signed_log_uniform(0.1, 2e9)).and_near({1.0, -1.0, 16777216.0})});
    builtin(entries, "uint_of_float", [](double x) { return static_cast<unsigned>(x); },
            {either(uniform(0, 9), log_uniform(0.1, 2e9)).and_near({1.0, 16777216.0})});
    builtin(entries, "isnan", [](double x) { return std::isnan(x); }, {wide_floats()});
    builtin(entries, "isinf", [](double x) { return std::isinf(x); }, {wide_floats()});
    const Domain two = Domain{wide_floats(), wide_floats()}.tied(0, 1);
    builtin(entries, "less", std::less<double>(), two);
    builtin(entries, "less_or_equal", std::less_equal<double>(), two);
    builtin(entries, "equal", std::equal_to<double>(), two);
    builtin(entries, "not_equal", std::not_equal_to<double>(), two);
}

void append_exponentials(Entries& entries) {
    const auto of = [](const Values& values) { return Domain{either(values, wide_floats())}; };
    const Values positive = either(uniform(0, 4), log_uniform(1e-37, 1e38));
    builtins(entries, {{"exp", std::exp}}, of(uniform(-90, 90)));
    builtins(entries, {{"exp2", std::exp2}}, of(uniform(-130, 130)));
    const auto inverse_root = [](double x) { return 1.0 / std::sqrt(x); };
    builtins(entries,
             {{"log", std::log}, {"log2", std::log2}, {"inversesqrt", inverse_root}, {"sqrt", std::sqrt}},
             of(positive));
    builtin(entries, "pow", [](double x, double y) { return std::pow(x, y); },
            {either(positive, wide_floats()), either(uniform(-16, 16), wide_floats())});
    const auto near_pi = [](const Values& values) {
        return Domain{either(values, wide_floats()).and_near({3.14159265, -3.14159265, 1.57079633})};
    };
    const Domain angle = near_pi(uniform(-3.1415927, 3.1415927));
    builtins(entries, {{"radians", glm::radians<double>}}, near_pi(uniform(-720, 720)));
    builtins(entries,
             {{"degrees", glm::degrees<double>}, {"sin", std::sin}, {"cos", std::cos}, {"tan", std::tan}},
             angle);
    builtins(entries, {{"asin", std::asin}, {"acos", std::acos}, {"atan", std::atan}},
             near_pi(uniform(-1, 1)));
    builtins(entries, {{"sinh", std::sinh}, {"cosh", std::cosh}, {"tanh", std::tanh}},
             near_pi(uniform(-9, 9)));
    builtin(
        entries, "atan2", [](double y, double x) { return std::atan2(y, x); },
        Domain{wide_floats(), wide_floats()}.tied(0, 1));
}

Values vectors() {
    return either(vector(3, uniform(-2, 2)), vector(3, signed_log_uniform(1e-12, 1e12))).and_special();
}
template <class Matrix>
Values matrices() {
    return made_by<Matrix>([](numeric::Random& random) {
        Matrix m(1.0F);
        for (glm::length_t column = 0; column < Matrix::length(); ++column)
            for (glm::length_t row = 0; row < Matrix::length(); ++row)
                m[column][row] = static_cast<float>(random.uniform(-2, 2));
        return m;
    });
}

void append_vectors(Entries& entries) {
    const Values v = vectors();
    builtin(entries, "dot", [](dvec3 a, dvec3 b) { return glm::dot(a, b); }, {v, v});
    builtin(entries, "length", [](dvec3 a) { return glm::length(a); }, {v});
    builtin(entries, "distance", [](dvec3 a, dvec3 b) { return glm::distance(a, b); }, {v, v});
    builtin(entries, "normalize", [](dvec3 a) { return glm::normalize(a); }, {v});
    builtin(entries, "cross", [](dvec3 a, dvec3 b) { return glm::cross(a, b); }, {v, v});
    builtin(entries, "reflect", [](dvec3 in, dvec3 normal) { return glm::reflect(in, normal); }, {v, v});
    const auto refract = [](dvec3 in, dvec3 normal, double eta) { return glm::refract(in, normal, eta); };
    builtin(entries, "refract", refract, {unit_vector(3), unit_vector(3), uniform(0.5, 2)});
    const auto faceforward = [](dvec3 normal, dvec3 in, dvec3 side) {
        return glm::dot(side, in) < 0.0 ? normal : -normal;
    };
    builtin(entries, "faceforward", faceforward, {v, v, v});
    const Values m = matrices<glm::mat3>();
    builtin(entries, "matrix_vector", [](dmat3 a, dvec3 b) { return a * b; }, {m, vectors()});
    builtin(entries, "vector_matrix", [](dvec3 a, dmat3 b) { return a * b; }, {vectors(), m});
    builtin(entries, "matrix_matrix", [](dmat3 a, dmat3 b) { return a * b; }, {m, m});
    builtin(entries, "matrix4_vector", [](glm::dmat4 a, glm::dvec4 b) { return a * b; },
            {matrices<glm::mat4>(), vector(4, uniform(-2, 2))});
    const auto outer_product = [](dvec3 a, dvec3 b) { return glm::outerProduct(a, b); };
    builtin(entries, "outer_product", outer_product, {vectors(), vectors()});
    builtin(entries, "determinant", [](dmat3 a) { return glm::determinant(a); }, {m});
    builtin(entries, "inverse", [](dmat3 a) { return glm::inverse(a); }, {m});
}

// (a, b, c): c is set to the rounded product of a and b.
Domain products() {
    const Values factor = uniform(1, 2);
    return Domain{factor, factor, constant(0.0F)}.adjusted([](std::span<Word> words) {
        words[2] = to_word(from_word<float>(words[0]) * from_word<float>(words[1]));
    });
}

}  // namespace

void append_builtins(Entries& entries) {
    append_rounding(entries);
    append_operators(entries);
    append_parts(entries);
    append_exponentials(entries);
    append_vectors(entries);
    // Defects met in drivers and compilers. Where Vulkan leaves the result open, the reference in double says
    // what one would wish.
    const auto none = [](double, double, double) { return 0.0; };
    by_rules(entries, "PROBE-isnan", [](double x) { return std::isnan(x - x); }, {wide_floats()});
    by_rules(entries, "PROBE-self", [](double x) { return std::isnan(x); }, {wide_floats()});
    for (const char* id : {"PROBE-contraction", "PROBE-precise-struct", "PROBE-fma"})
        by_rules(entries, id, none, products());
    const Domain half{constant(0.5F)};
    by_rules(entries, "PROBE-folded-exp", [](double x) { return std::exp(0.5) - std::exp(x); }, half);
    by_rules(entries, "PROBE-folded-sin", [](double x) { return std::sin(0.5) - std::sin(x); }, half);
    const Values zero = constant(0.0F).and_value(-0.0F);
    by_rules(entries, "PROBE-pow", [](double x, double y) { return std::pow(x, y); }, {zero, zero});
    const auto signs = [](dvec3 v) {  // bit i: component i has its sign bit set
        return std::signbit(v.x) * 1.0 + std::signbit(v.y) * 2.0 + std::signbit(v.z) * 4.0;
    };
    by_rules(entries, "PROBE-normalize-sign", signs,
             {vector(3, uniform(-1, 1).and_value(-0.0F).and_value(0.0F))});
    by_rules(entries, "PROBE-remainder", [](int) { return 0; },
             {either(integers(1, 100), integers(1, 2147483647))});
}

}  // namespace gloam::catalogue
