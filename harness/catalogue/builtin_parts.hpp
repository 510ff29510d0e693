// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "catalogue/entry.hpp"

// GLSL's own operators and functions (glsl/builtin), judged by Vulkan's precision rules alone.
namespace gloam::catalogue {

void append_builtin_arithmetic(Entries& entries);
void append_builtin_comparisons(Entries& entries);
void append_builtin_elementary(Entries& entries);
void append_builtin_vectors(Entries& entries);
void append_probes(Entries& entries);

// Floats of every kind: ordinary ones, any bit pattern, special values, and turning points of functions.
[[nodiscard]] check::Values wide_floats();

// One GLSL expression and the rule by which it is judged. `name`: of the function without its prefix.
template <class Signature, class Reference>
void append_builtin(Entries& entries, const std::string& file, const std::string& name,
                    std::string expression, std::string rule, Reference reference, check::Domain domain) {
    entries.push_back(
        equation<Signature>({.id = "BUILTIN-" + name,
                             .function = "builtin_" + name,
                             .file = "builtin/" + file,
                             .title = "as Vulkan promises: " + std::move(rule),
                             .formula = std::move(expression),
                             .source = "Vulkan, Precision and Operation of SPIR-V Instructions"},
                            reference, {.domain = std::move(domain), .only_rules = true}));
}

}  // namespace gloam::catalogue
