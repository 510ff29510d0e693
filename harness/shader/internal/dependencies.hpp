// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace gloam::shader::internal {

/// Adds the absolute path of a file that was read to the list that the environment variable
/// GLOAM_DEPENDENCIES_OUTPUT names, one path a line, unless it stands there already. Does nothing where the
/// variable is not set or the list cannot be written: a list of dependencies must not stop a compilation.
void note_dependency(const std::filesystem::path& file);

}  // namespace gloam::shader::internal
