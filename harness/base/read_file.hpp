// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace gloam::base {

constexpr std::size_t largest_text = std::size_t{64} << 20;  // bytes

// All of a file. Throws std::runtime_error that names it and says why: it cannot be read, is a folder, or
// holds more than `largest` bytes (a device without end, say).
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t largest = largest_text);

}  // namespace gloam::base
