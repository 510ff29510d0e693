// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace gloam::gpu {

// A file with a header that contains its length and checksum.

// The content; empty if the file is missing, unreadable, of another length than it states, or changed in any
// bit.
[[nodiscard]] std::vector<std::byte> read_cache_file(const std::filesystem::path& file);

// Replaces the file completely or not at all; creates its folder if needed. Returns false on failure and then
// leaves nothing behind.
bool write_cache_file(const std::filesystem::path& file, std::span<const std::byte> content);

}  // namespace gloam::gpu
