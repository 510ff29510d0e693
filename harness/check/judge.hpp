// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "check/budget.hpp"
#include "check/census.hpp"
#include "check/domain.hpp"
#include "check/image.hpp"
#include "check/kernel_module.hpp"
#include "check/permitted.hpp"
#include "check/signature.hpp"

namespace gloam::check {

// A reference without its C++ types: input words in, one double for each output word. Where a check has none,
// the module in double takes its place.
using Reference =
    std::function<void(const ImageSet& images, std::span<const Word> inputs, std::vector<double>& outputs)>;

// The values that every output but a truth value must lie in, for every input whatever. NaN is never inside.
struct Codomain {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

// What is asked of an output: that the function's documented budget holds, or that Vulkan's precision rules
// permit it.
enum class Verdict { budget, rules };
[[nodiscard]] constexpr std::string_view name_of(Verdict verdict) {
    return verdict == Verdict::budget ? "budget" : "rules";
}

// The rules by which outputs are judged.
struct Rules {
    Signature signature;
    Reference reference;
    Budget budget;
    Codomain codomain;
    // Inputs for which the budget is promised; empty: all. Elsewhere (overflow in between, say) only the
    // codomain is, and what is documented for zero, infinity and NaN.
    std::function<bool(std::span<const Word>)> promised;
    // Whether the results for zero, infinity and NaN beside values of usual size are those of the reference,
    // in every verdict: off for a reference that documents none (a function of GLSL itself), and for other
    // arithmetic than float32. Without a reference nothing is.
    bool judge_edges = true;
    // Whether the device keeps NaN, infinity and signed zero. If not, inputs and references that hold one are
    // only recorded.
    bool judge_nan = true;
    // With Verdict::rules the budget and the codomain are only measured.
    Verdict verdict = Verdict::budget;
    // What gave the outputs. Whatever the verdict, an output that the rules do not permit these modules
    // fails; without modules nothing is asked of the rules.
    KernelModules modules;
};

// Judges every output of a run. Throws std::invalid_argument for Verdict::rules without modules;
// interpreter::Error for a module that the interpreter cannot run.
// `outputs`: count x output words, in the order of the inputs.
// `fractions`, when not empty, takes each input's fraction of what the verdict allows (0 where only
// recorded).
[[nodiscard]] Census judge(const Rules& rules, const Domain::Inputs& inputs, std::span<const Word> outputs,
                           const ImageSet& images = {}, const std::string& scenario = {},
                           std::span<double> fractions = {});

}  // namespace gloam::check
