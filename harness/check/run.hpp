// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "check/answer.hpp"
#include "check/lab.hpp"
#include "check/question.hpp"

namespace gloam::check {

struct RunOptions {
    std::size_t inputs = 65'536;
    std::uint64_t seed = 1;
    bool coverage = false;  // also measure what the inputs reach
};

// The criterion for results in a variant: in strict and relaxed variants the rules alone, in all others the
// documented budget and the rules. A question with only_rules or without a reference is never judged by a
// budget.
[[nodiscard]] Verdict verdict_of(const shader::Variant& variant, const Question& question);

// Compiles the function, evaluates the inputs and judges every output. Throws like Lab::kernel and
// KernelCore::run.
[[nodiscard]] Answer run(const Lab& lab, const Question& question, const RunOptions& options = {});

// Checks a function against a reference in one call.
template <class Function, class Callable>
[[nodiscard]] Answer compare(const Lab& lab, const std::string& file, const std::string& function,
                             Callable reference, const Domain& domain, const Budget& budget = {},
                             const RunOptions& options = {}) {
    return run(lab,
               Question{.file = file,
                        .function = function,
                        .signature = SignatureOf<Function>::describe(),
                        .domain = domain,
                        .reference = make_reference<Function>(std::move(reference)),
                        .budget = budget},
               options);
}

// Checks whether Vulkan's precision rules permit the results of a function for the module that the driver was
// given. It needs neither a reference nor a tolerance.
template <class Function>
[[nodiscard]] Answer check_rules(const Lab& lab, const std::string& file, const std::string& function,
                                 const Domain& domain, const RunOptions& options = {}) {
    return run(lab,
               Question{.file = file,
                        .function = function,
                        .signature = SignatureOf<Function>::describe(),
                        .domain = domain},
               options);
}

}  // namespace gloam::check
