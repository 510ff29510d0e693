// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::base {

// A 128-bit XXH3 hash, for keys and checksums of cached files. It does not resist an attacker.
using Hash = std::array<std::uint64_t, 2>;

[[nodiscard]] Hash hash_of(std::string_view bytes);
// 32 hexadecimal digits.
[[nodiscard]] std::string to_hex(const Hash& hash);

// The hashed data: fields with their lengths, so that adjacent fields cannot be confused.
class Fingerprint {
  public:
    void add(std::string_view field);
    void add(std::uint64_t field);
    void add(double field) { add(std::bit_cast<std::uint64_t>(field)); }

    // The bytes of all values. T has no padding.
    template <class T>
    void add_all(const std::vector<T>& values) {
        add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)));
    }

    [[nodiscard]] Hash hash() const { return hash_of(bytes_); }

  private:
    std::string bytes_;
};

// The payload that write_cached() stored with this key. nullopt if the file is missing, unreadable, of
// another key or length than it states, or changed in any bit.
[[nodiscard]] std::optional<std::string> read_cached(const std::filesystem::path& file, const Hash& key);

// Stores a payload with a header that validates it: magic, format, key, length and checksum. Replaces the
// file completely or not at all, and creates its folder if needed. Returns false on failure and then leaves
// nothing behind.
bool write_cached(const std::filesystem::path& file, const Hash& key, std::string_view payload);

}  // namespace gloam::base
