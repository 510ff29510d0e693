// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/failure.hpp"
#include "module/compile.hpp"

namespace gloam::module {

// Steps that a module takes after the front end, each written as a text of words:
//
//   spirv-opt --ccp --cfg-cleanup     passes of the SPIRV-Tools that gloam is linked with
//   PROGRAM ARGUMENT...               a program that reads the module {in}, or the kernel's GLSL {glsl}, and
//                                     writes the module {out}: /opt/bin/spirv-opt -O {in} -o {out}
//
// A step must keep the meaning of its module: what it gives is judged by the module before it.

// What stands between the steps of a sequence, and between a variant and its steps.
inline constexpr std::string_view step_separator = " | ";

// What a step reads.
struct StepInput {
    const Spirv& module;
    std::function<std::string()> glsl;  // the text that the module was made from, without includes
};

// A step that fails, or gives a module that is not valid: a fault of the step. One line.
class StepError : public base::Failure {
    using base::Failure::Failure;
};

// A step that cannot be taken: its program or file is not here. It says nothing of the module.
class StepUnavailable : public StepError {
  public:
    explicit StepUnavailable(const std::string& message) : StepError(message, base::Reason::unsupported) {}
};

// The steps left a module as it was, so that nothing can have gone wrong.
class Unchanged : public base::Failure {
  public:
    Unchanged() : Failure("the steps leave its module as it is", base::Reason::unchanged) {}
};

// Takes a step. A program has 60 s and 4 GiB. Throws StepError.
[[nodiscard]] Spirv taken(const std::string& step, const StepInput& input);

// All steps, one after the other: the module after the last. Throws StepError; Unchanged.
[[nodiscard]] Spirv all_taken(const std::vector<std::string>& steps, const StepInput& input);

// The passes of a step, which can be left out. At least one stays in.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& step);
[[nodiscard]] std::string with_parts(const std::string& step, const std::vector<std::string>& parts);

// The steps that a user's text stands for. With {each} in it, as in "spirv-opt {each}", one for each pass of
// the program spirv-opt that is installed and that gloam's SPIRV-Tools know. Throws std::invalid_argument for
// a text that is no step.
[[nodiscard]] std::vector<std::string> steps_from(const std::string& text);

}  // namespace gloam::module
