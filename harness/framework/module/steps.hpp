// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"

namespace gloam::shader {

// Steps that a module takes after the front end, each written as a text of words:
//
//   spirv-opt --ccp --cfg-cleanup     passes of the SPIRV-Tools that gloam is linked with
//   metamorphic 17                    the changes of seed 17 (metamorphic.hpp)
//   metamorphic 17 only 3 5           of these, the changes 3 and 5
//   PROGRAM ARGUMENT...               a program that reads the module {in}, or the kernel's GLSL {glsl}, and
//                                     writes the module {out}: /opt/bin/spirv-opt -O {in} -o {out}
//
// A step that compiles must keep the meaning of its module: what it gives is judged by the module before it.
// A metamorphic step makes another shader to compile: what it gives is judged by itself.

// What stands between the steps of a sequence, and between a variant and its steps.
inline constexpr std::string_view step_separator = " | ";

// What a step reads.
struct StepInput {
    const Spirv& module;
    std::function<std::string()> glsl;  // the text that the module was made from, without includes
};

// A step that fails, or gives a module that is not valid: a fault of the step. One line.
class StepError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A step that cannot be taken: its program or file is not here. It says nothing of the module.
class StepUnavailable : public StepError {
    using StepError::StepError;
};

// The steps left a module as it was, so that nothing can have gone wrong.
class Unchanged : public std::runtime_error {
  public:
    Unchanged() : std::runtime_error("the steps leave its module as it is") {}
};

// Takes a step. A program has 60 s and 4 GiB. Throws StepError.
[[nodiscard]] Spirv taken(const std::string& step, const StepInput& input);

// All steps, one after the other: the module after the last, and the one before the first that compiles.
// Throws StepError; Unchanged.
struct Stepped {
    Spirv before;
    Spirv after;
};
[[nodiscard]] Stepped all_taken(const std::vector<std::string>& steps, const StepInput& input);

[[nodiscard]] bool is_metamorphic(const std::string& step);

// The parts of a step that can be left out: passes, changes. At least one stays in.
[[nodiscard]] std::vector<std::string> parts_of(const std::string& step);
[[nodiscard]] std::string with_parts(const std::string& step, const std::vector<std::string>& parts);

// The steps that a user's text stands for. With {each} in it, as in "spirv-opt {each}", one for each pass of
// the program spirv-opt that is installed and that gloam's SPIRV-Tools know; "metamorphic" alone is one for
// each of `seeds` seeds from `first` on. Throws std::invalid_argument for a text that is no step.
[[nodiscard]] std::vector<std::string> steps_from(const std::string& text, std::uint64_t first,
                                                  std::size_t seeds);

}  // namespace gloam::shader
