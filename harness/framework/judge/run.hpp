// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "judge/answer.hpp"
#include "judge/question.hpp"
#include "subject/kernel_code.hpp"
#include "subject/lab.hpp"

namespace gloam::judge {

// How the outputs of a run are judged, besides the question.
struct JudgeOptions {
    // Judge the results for zero, infinity and NaN beside values of usual size against the reference, in
    // each criterion. Set it to false if the reference documents none (a built-in function of GLSL), and for
    // other arithmetic than float32. Without a reference they are not judged.
    bool edges = true;
    // Whether the device preserves NaN, infinity and signed zero. If not, inputs that contain one, and those
    // whose reference is NaN or infinite, are only recorded.
    bool nan = true;
    // With Criterion::rules the budget and the codomain are measured, but do not fail.
    Criterion criterion = Criterion::budget;
    // The modules that produced the outputs. Whatever the criterion, an output that the rules do not permit
    // for these modules fails. Without modules the rules are not asked; where the criterion needs them,
    // inputs are only recorded then.
    subject::KernelModules modules;
};

// An answer to a question, without any inputs.
[[nodiscard]] Answer empty_answer(const Question& question, Criterion criterion);

// Judges every output of a run. Throws interpreter::Error for a module that the interpreter cannot run.
// `outputs`: count x output words, in the order of the inputs.
// `fractions`: if not empty, it receives each input's fraction of what the criterion allows, 0 if the input
// is only recorded.
[[nodiscard]] Answer judge(const Question& question, const JudgeOptions& options,
                           const subject::Domain::Inputs& inputs, std::span<const Word> outputs,
                           const subject::ImageSet& images = {}, const std::string& scenario = {},
                           std::span<double> fractions = {});

struct RunOptions {
    std::size_t inputs = 65'536;  // fewer are run if those and their outputs have more than 2^26 words
    std::uint64_t seed = 1;
};

// Compiles the function, evaluates the inputs and judges every output. Throws like Lab::kernel and
// KernelCore::run; interpreter::Error (race, divergent_barrier) for invocations that disturb each other, with
// the lines of the source.
[[nodiscard]] Answer run(const subject::Lab& lab, const Question& question, const RunOptions& options = {});

}  // namespace gloam::judge
