// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace gloam::shader::internal {

// Appends the absolute path of a read file to the list in the file that the environment variable
// GLOAM_DEPENDENCIES_OUTPUT names, one path a line, unless it is listed already. Does nothing if the variable
// is not set or the list cannot be written: a list of dependencies must not stop a compilation.
void note_dependency(const std::filesystem::path& file);

// The value of that variable, empty if it is not set, and its counterpart for another process: a compiler
// process serves several tests of a suite, each with its own list.
[[nodiscard]] std::string dependency_list();
void use_dependency_list(const std::string& list);

}  // namespace gloam::shader::internal
