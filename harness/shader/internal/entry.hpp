// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace gloam::shader::internal {

// A 128-bit XXH3 hash.
using Hash = std::array<std::uint64_t, 2>;

// The hashed data: fields with their lengths, so that adjacent fields cannot be confused.
class Fingerprint {
  public:
    void add(std::string_view field);
    void add(std::uint64_t field);
    [[nodiscard]] Hash hash() const;

  private:
    std::string bytes_;
};

[[nodiscard]] Hash hash_of(std::string_view bytes);
// 32 hexadecimal digits.
[[nodiscard]] std::string to_hex(const Hash& hash);

// A payload on disk with a header that validates it: magic, format, key, length and checksum.

// The payload of the file; nullopt if the file is not a valid entry with this key.
[[nodiscard]] std::optional<std::string> read_entry(const std::filesystem::path& file, const Hash& key);

// Writes the file completely or not at all, by renaming a temporary file. A failure only loses the entry.
void write_entry(const std::filesystem::path& file, const Hash& key, std::string_view payload);

}  // namespace gloam::shader::internal
