// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "check/lab.hpp"
#include "check/question.hpp"
#include "cli/check/task.hpp"

// The check of a user's shader file: no reference, no C++.
namespace gloam::cli {

// Whether a word of the command line is a shader file, not an equation.
[[nodiscard]] bool is_shader_file(const std::string& word);

// The functions of a file (`includes`: its further include roots) with these names; without names all for
// which a check can draw inputs. Throws std::invalid_argument for a function that the file does not define,
// an invalid range, or a range without a parameter of its name; std::runtime_error for a missing file;
// shader::CompileError.
[[nodiscard]] std::vector<std::string> own_functions(const std::string& file,
                                                     const std::vector<std::string>& names,
                                                     const std::vector<std::string>& ranges,
                                                     const std::vector<std::string>& includes);

// The question of a task about a function of its file.
[[nodiscard]] check::Question own_question(const check::Lab& lab, const CheckTask& task);

}  // namespace gloam::cli
