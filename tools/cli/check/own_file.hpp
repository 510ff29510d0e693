// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "check/lab.hpp"
#include "check/question.hpp"
#include "cli/check/task.hpp"

// The check of somebody's shader file: no reference, no C++.
namespace gloam::cli {

// Whether a word of the command line means a shader file, not an equation.
[[nodiscard]] bool is_shader_file(const std::string& word);

// The functions of these names that a file defines, or all that a check can draw inputs for when there are
// none. Throws std::invalid_argument for a function that the file does not define, or a range that is none or
// that no parameter has; std::runtime_error for a file that is not there; shader::CompileError.
[[nodiscard]] std::vector<std::string> own_functions(const std::string& file,
                                                     const std::vector<std::string>& names,
                                                     const std::vector<std::string>& ranges);

// What a task asks of a function of its file.
[[nodiscard]] check::Question own_question(const check::Lab& lab, const CheckTask& task);

}  // namespace gloam::cli
