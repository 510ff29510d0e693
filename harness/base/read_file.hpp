// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace gloam::base {

constexpr std::size_t largest_text = std::size_t{64} << 20;  // bytes

// The content of a file. Throws std::runtime_error with its name and the reason: it cannot be read, is a
// folder, or has more than `largest` bytes (for example an endless device).
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t largest = largest_text);

}  // namespace gloam::base
