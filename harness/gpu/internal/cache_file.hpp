// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace gloam::gpu {

// A blob on disk behind a header with its length and checksum.

// The content; empty when the file is missing, unreadable, cut short, longer than it says, or changed in any
// bit.
[[nodiscard]] std::vector<std::byte> read_cache_file(const std::filesystem::path& file);

// Replaces the file, whole or not at all, making its folder where needed. False when that failed; nothing is
// left behind then.
bool write_cache_file(const std::filesystem::path& file, std::span<const std::byte> content);

}  // namespace gloam::gpu
