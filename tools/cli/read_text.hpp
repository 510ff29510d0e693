// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace gloam::cli {

// All of a file, of at most base::largest_text bytes. Throws std::runtime_error that names it and says why it
// cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

}  // namespace gloam::cli
