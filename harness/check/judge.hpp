// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "check/answer.hpp"
#include "check/kernel_module.hpp"
#include "check/question.hpp"

namespace gloam::check {

// How the outputs of a run are judged, beside what was asked.
struct JudgeOptions {
    // Whether the results for zero, infinity and NaN beside values of usual size are those of the reference,
    // in every verdict: off for a reference that documents none (a function of GLSL itself), and for other
    // arithmetic than float32. Without a reference nothing is.
    bool edges = true;
    // Whether the device keeps NaN, infinity and signed zero. If not, inputs and references that hold one are
    // only recorded.
    bool nan = true;
    // With Verdict::rules the budget and the codomain are only measured.
    Verdict verdict = Verdict::budget;
    // What gave the outputs. Whatever the verdict, an output that the rules do not permit these modules
    // fails; without modules nothing is asked of the rules.
    KernelModules modules;
};

// An answer without inputs yet.
[[nodiscard]] Answer empty_answer(const Question& question, Verdict verdict);

// Judges every output of a run. Throws std::invalid_argument for Verdict::rules without modules;
// interpreter::Error for a module that the interpreter cannot run.
// `outputs`: count x output words, in the order of the inputs.
// `fractions`, when not empty, takes each input's fraction of what the verdict allows (0 where only
// recorded).
[[nodiscard]] Answer judge(const Question& question, const JudgeOptions& options,
                           const Domain::Inputs& inputs, std::span<const Word> outputs,
                           const ImageSet& images = {}, const std::string& scenario = {},
                           std::span<double> fractions = {});

}  // namespace gloam::check
