// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string_view>

namespace gloam::report::internal {

// Throws std::runtime_error: "cannot write PATH: REASON", the reason of that error number.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, int error);

// Makes or replaces a file with these bytes. Returns 0, or the error number of what went wrong; the file may
// then hold a part of them. A full disk may show as late as in close().
[[nodiscard]] int write_all(const std::filesystem::path& path, std::string_view bytes);

// The name under which the bytes of `path` lie until they are complete: its neighbour PATH.part.
[[nodiscard]] std::filesystem::path part_of(const std::filesystem::path& path);

}  // namespace gloam::report::internal
