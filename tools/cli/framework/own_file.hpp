// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "cli/commands.hpp"
#include "judge/question.hpp"
#include "subject/lab.hpp"
#include "subject/own_function.hpp"

// A user's shader file, for the commands that take one.
namespace gloam::cli {

// What the command line says of it.
struct OwnFileOptions {
    std::vector<std::string> ranges;    // of its functions' parameters: "x=0:1"
    std::vector<std::string> includes;  // further include roots
    std::vector<std::string> defines;   // macros that hold before it begins
};

// Whether a name ends like that of a shader file: .glsl, .frag, .FRAG, .fs ...
[[nodiscard]] bool has_shader_ending(const std::string& word);
// Whether a word of the command line is a file, not an equation: by any ending, or as a file's name.
[[nodiscard]] bool is_shader_file(const std::string& word);

// A file and functions, of words that name these, or equations of one file instead. Throws
// std::invalid_argument for other words.
[[nodiscard]] std::pair<std::string, std::vector<std::string>> file_and_functions(
    const std::vector<std::string>& words, EquationsNamed* equations);

// The ranges that --range names. Throws std::invalid_argument for an invalid one.
[[nodiscard]] subject::Ranges ranges_from(const std::vector<std::string>& texts);

// A user's file with the include roots that the command line adds, read once for all labs, and its functions
// with these names (subject::own_functions()); without names all.
struct FileFunctions {
    std::shared_ptr<const subject::OwnFile> file;
    subject::OwnFunctions functions;

    // What is left out of the file of this name, a line each.
    [[nodiscard]] std::vector<std::string> notes(const std::string& name) const;
    // Whether no function is left out that does not compile, or that was named.
    [[nodiscard]] bool is_complete(bool named) const;
};

// Throws std::runtime_error for a missing file; source::CompileError for what the preprocessor rejects;
// std::invalid_argument for a function that it does not define, and for a range that no parameter has.
[[nodiscard]] FileFunctions functions_of(const std::filesystem::path& file,
                                         const std::vector<std::string>& names,
                                         const OwnFileOptions& options);

// A lab for the functions of a file.
[[nodiscard]] subject::Lab lab_of(std::shared_ptr<const subject::OwnFile> file,
                                  const std::string& device = std::string(subject::interpreter_name));

// "FILE: nothing was DONE: ...": why nothing is left of a file of which these functions were left out.
[[nodiscard]] std::runtime_error nothing_was(const char* done, const std::string& file,
                                             const std::vector<subject::Skipped>& left_out);

}  // namespace gloam::cli
