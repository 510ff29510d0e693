// SPDX-License-Identifier: MIT
#include "catalogue/builtin_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/builtin.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

template <class Signature, class Reference>
void append_probe(Entries& entries, const std::string& name, const std::string& function, std::string title,
                  std::string formula, Reference reference, Domain domain) {
    entries.push_back(equation<Signature>({.id = "PROBE-" + name,
                                           .function = "probe_" + function,
                                           .file = "builtin/probe.glsl",
                                           .title = std::move(title),
                                           .formula = std::move(formula),
                                           .source = "defects met in drivers and compilers"},
                                          reference, {.domain = std::move(domain), .only_rules = true}));
}

// (a, b, c): c is set to the rounded product of a and b.
Domain products() {
    const Values factor = uniform(1, 2);
    return Domain{factor, factor, constant(0.0F)}.adjusted([](std::span<Word> words) {
        words[2] = to_word(from_word<float>(words[0]) * from_word<float>(words[1]));
    });
}

void append_nan(Entries& entries) {
    append_probe<bool(float)>(entries, "isnan", "isnan_of_difference", "isnan() of arithmetic",
                              "isnan(x - x)", &reference::probe_isnan_of_difference, {wide_floats()});
    append_probe<bool(float)>(entries, "self", "differs_from_itself", "NaN differs from itself", "x != x",
                              &reference::probe_differs_from_itself, {wide_floats()});
}

void append_contractions(Entries& entries) {
    using Product = float(float, float, float);
    append_probe<Product>(entries, "contraction", "contraction", "contracted expression (recorded)",
                          "a b - c, c = a b rounded; 0 when nothing is contracted",
                          &reference::probe_contraction, products());
    append_probe<Product>(
        entries, "precise-struct", "precise_in_struct", "precise through a function and a struct (recorded)",
        "a b - c, c = a b rounded; 0 when precise holds", &reference::probe_precise_in_struct, products());
    append_probe<Product>(entries, "fma", "fma_rounding", "how often fma() rounds (recorded)",
                          "fma(a, b, -c), c = a b rounded; 0 when it rounds twice",
                          &reference::probe_fma_rounding, products());
}

void append_folding(Entries& entries) {
    const Domain half{constant(0.5F)};
    append_probe<float(float)>(entries, "folded-exp", "folded_exp", "folded constant against run time",
                               "exp(0.5) - exp(x), x = 0.5", &reference::probe_folded_exp, half);
    append_probe<float(float)>(entries, "folded-sin", "folded_sin", "folded constant against run time",
                               "sin(0.5) - sin(x), x = 0.5", &reference::probe_folded_sin, half);
}

}  // namespace

void append_probes(Entries& entries) {
    append_nan(entries);
    append_contractions(entries);
    append_folding(entries);
    const Values zero = constant(0.0F).and_value(-0.0F);
    append_probe<float(float, float)>(entries, "pow", "pow_of_zeros", "power of zeros (recorded)",
                                      "pow(0, 0)", &reference::probe_pow_of_zeros, {zero, zero});
    append_probe<float(glm::vec3)>(entries, "normalize-sign", "normalize_sign",
                                   "normalize() of -0 (recorded)", "sign bits of normalize(v)",
                                   &reference::probe_normalize_sign,
                                   {vector(3, uniform(-1, 1).and_value(-0.0F).and_value(0.0F))});
    append_probe<int(int)>(entries, "remainder", "integer_remainder", "x % x is 0", "x % x, x > 0",
                           &reference::probe_integer_remainder,
                           {either(integers(1, 100), integers(1, 2147483647))});
}

}  // namespace gloam::catalogue
