// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

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

// Runs a function of a file on one input (the words of its in and inout parameters in order) along the path
// that float32 takes. Throws std::invalid_argument for a function that is not there, reads images, or takes
// another number of words; shader::CompileError; interpreter::Error.
[[nodiscard]] Explanation explain(const shader::CompileOptions& options, const std::string& file,
                                  const std::string& function, std::span<const Word> input);

// The scalars that such a function takes, in order. Throws as explain().
[[nodiscard]] std::vector<shader::Scalar> inputs_of(const shader::CompileOptions& options,
                                                    const std::string& file, const std::string& function);

}  // namespace gloam::check
