// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace gloam::shader::internal {

// Appends the absolute path of a read file to the list in the file that the environment variable
// GLOAM_DEPENDENCIES_OUTPUT names, one path a line, unless it is listed already. Does nothing if the variable
// is not set or the list cannot be written: a list of dependencies must not stop a compilation.
void note_dependency(const std::filesystem::path& file);

}  // namespace gloam::shader::internal
