// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "shader/internal/hash.hpp"

namespace gloam::shader::internal {

// A payload on disk behind a header that proves it: magic, format, key, length and checksum.

// The payload of the file, or nothing when the file is not exactly an entry of this key.
[[nodiscard]] std::optional<std::string> read_entry(const std::filesystem::path& file, const Hash& key);

// Writes the file whole or not at all, by renaming a temporary one over it. Failure costs only the entry.
void write_entry(const std::filesystem::path& file, const Hash& key, std::string_view payload);

}  // namespace gloam::shader::internal
