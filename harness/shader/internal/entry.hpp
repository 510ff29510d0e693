// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "shader/internal/hash.hpp"

namespace gloam::shader::internal {

// A payload on disk with a header that validates it: magic, format, key, length and checksum.

// The payload of the file; nullopt if the file is not a valid entry with this key.
[[nodiscard]] std::optional<std::string> read_entry(const std::filesystem::path& file, const Hash& key);

// Writes the file completely or not at all, by renaming a temporary file. A failure only loses the entry.
void write_entry(const std::filesystem::path& file, const Hash& key, std::string_view payload);

}  // namespace gloam::shader::internal
