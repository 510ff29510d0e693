// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check/lab.hpp"
#include "check/own_function.hpp"
#include "check/question.hpp"
#include "cli/check/task.hpp"

// The check of a user's shader file: no reference, no C++.
namespace gloam::cli {

// Whether a word of the command line is a shader file, not an equation.
[[nodiscard]] bool is_shader_file(const std::string& word);

struct OwnFile {
    std::string version;  // of its #version line; empty: there is none
    check::OwnFunctions functions;
};

// The functions of a file (`includes`: its further include roots) with these names (see
// check::own_functions()); without names all. Throws std::invalid_argument for a function that the file does
// not define, an invalid range, or a range without a parameter of its name; std::runtime_error for a missing
// file; shader::CompileError for what the preprocessor rejects.
[[nodiscard]] OwnFile own_file(const std::string& file, const std::vector<std::string>& names,
                               const std::vector<std::string>& ranges,
                               const std::vector<std::string>& includes);

// What `gloam check FILE [FUNCTION...]` checks.
struct OwnSelection {
    std::vector<std::string> names;
    // For people, a line each: a function that was left out; a #version that is not the one that is compiled.
    std::vector<std::string> notes;
    bool complete = true;  // no function was left out that was named or that does not compile
};

// `words`: the file, then the names of functions. Throws like own_file(), and std::runtime_error if nothing
// can be checked; then it has printed the notes, if there are several.
[[nodiscard]] OwnSelection own_selection(const std::vector<std::string>& words,
                                         const std::vector<std::string>& ranges,
                                         const std::vector<std::string>& includes);

// The question of a task about a function of its file.
[[nodiscard]] check::Question own_question(const check::Lab& lab, const CheckTask& task);

}  // namespace gloam::cli
