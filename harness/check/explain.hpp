// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "check/kernel_code.hpp"
#include "check/scalars.hpp"
#include "numeric/bounds.hpp"
#include "shader/compile.hpp"

namespace gloam::check {

// One operation of a shader on one input, as the interpreter did it on every number type at once.
struct ExplainedStep {
    std::string file;
    unsigned line = 0;  // of the source
    std::string function;
    std::string operation;      // "OpFAdd"
    std::size_t component = 0;  // of a vector
    float value = 0.0F;         // rounded correctly at every operation
    double exact = 0.0;         // in double
    numeric::Bounds permitted;  // by Vulkan's rules, on this path
    double error = 0.0;         // value - exact
    double local = 0.0;         // the part of it that this operation adds by rounding
    double ulps = 0.0;          // error in units in the last place of the exact result

    // The part that came in with the operands.
    [[nodiscard]] double inherited() const { return error - local; }
};

// What a shader function does with one input, operation by operation.
struct Explanation {
    std::vector<ExplainedStep> steps;  // those that give floats, in the order of the run
    // The step after which the error, in ULP, has grown most against all before it; steps.size() where there
    // is none.
    std::size_t worst = 0;
};

// Runs a function on one input (the words of its in and inout parameters in order) along the path that
// float32 takes. Throws std::invalid_argument for another number of words, or an image that is missing;
// shader::CompileError; interpreter::Error.
[[nodiscard]] Explanation explain(const shader::CompileOptions& options, const KernelSource& source,
                                  std::span<const Word> input, const ImageSet& images = {});

// The same of a function of a file. Throws std::invalid_argument for one that is not there or reads images.
[[nodiscard]] Explanation explain(const shader::CompileOptions& options, const std::string& file,
                                  const std::string& function, std::span<const Word> input);

// A line for each step, titles above, and where the error grows most below. Of more than `most` steps those
// are shown at which the error rises most above all before, then the last.
[[nodiscard]] std::string to_text(const Explanation& explanation, std::size_t most);

// The scalars that such a function takes, in order. Throws as explain().
[[nodiscard]] std::vector<shader::Scalar> inputs_of(const shader::CompileOptions& options,
                                                    const std::string& file, const std::string& function);

}  // namespace gloam::check
