// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "module/compile.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"
#include "subject/interpreted_kernel.hpp"
#include "subject/kernel_code.hpp"
#include "subject/lab.hpp"

namespace gloam::judge {

// One operation of a shader on one input, as the interpreter executed it on every number type at once.
struct ExplainedStep {
    std::string file;
    unsigned line = 0;  // in the source file
    std::string function;
    std::string operation;                     // "OpFAdd"
    std::size_t component = 0;                 // of a vector, from 0; of a matrix, column by column
    double value = 0.0;                        // correctly rounded at every operation
    double exact = 0.0;                        // in double
    numeric::Bounds permitted{};               // by Vulkan's rules, on this path
    std::vector<numeric::Bounds> others = {};  // permitted as well, apart from these bounds
    double error = 0.0;                        // value - exact
    double local = 0.0;                        // the part of the error that this operation adds by rounding
    double ulps = 0.0;                         // error in units in the last place of the exact result
    // Of an integer or a bool the bits are the value, and it has no error.
    enum class Kind { number, integer, truth } kind = Kind::number;
    std::string undefined{};  // why every value is permitted; empty: the operation has a result

    [[nodiscard]] bool is_number() const { return kind == Kind::number; }
    // The part of the error that came with the operands.
    [[nodiscard]] double inherited() const { return error - local; }
};

// The operations of a shader function on one input.
struct Explanation {
    std::vector<ExplainedStep> steps;  // in the order of execution
    // The step at which the error, in ULP, grows by the largest factor above those of all steps before it;
    // steps.size() if it nowhere does.
    std::size_t worst = 0;
    // Its outputs, as steps without a place; empty for a kernel whose function is not known.
    std::vector<ExplainedStep> result;
    std::vector<module::Scalar> scalars;  // of the result
};

// Runs a function on one input (the words of its in and inout parameters in order) along the path that
// float32 takes. Throws std::invalid_argument for another number of words, or an image that is missing;
// source::CompileError; interpreter::Error.
[[nodiscard]] Explanation explain(const module::CompileOptions& options, const subject::KernelSource& source,
                                  std::span<const subject::Word> input, const subject::ImageSet& images = {});

// A kernel with the lines of its source, for explain() and coverage, with a lab's options and cache, as the
// front end makes it: an optimizer removes some branches and copies others. No driver is given it.
[[nodiscard]] subject::KernelModule lined_module(const subject::Lab& lab,
                                                 const subject::KernelSource& source);

// The same for a kernel that is ready. Throws interpreter::Error.
[[nodiscard]] Explanation explain(subject::InterpretedKernel<interpreter::Explained>& kernel,
                                  std::span<const subject::Word> input,
                                  numeric::Paths::Gaps gaps = numeric::Paths::Gaps::open);

// What Vulkan's precision rules say of its operations, a line for each kind: "OpFDiv: 2.5 ULP where ...".
[[nodiscard]] std::vector<std::string> rules_of(const Explanation& explanation);

// A line for each clause of these that is younger than a driver's version of Vulkan, "1.3.0".
[[nodiscard]] std::string younger_rules(const Explanation& explanation, const std::string& api_version);

// A table: titles, then a line for each step, and the result. The line with the largest rise of the error is
// marked. If there are more than `most` steps, the table has those at which the error rises most; among equal
// rises the later steps.
inline constexpr std::size_t most_lines = 16;
[[nodiscard]] std::string to_text(const Explanation& explanation, std::size_t most = most_lines);
std::ostream& operator<<(std::ostream& stream, const Explanation& explanation);

}  // namespace gloam::judge
