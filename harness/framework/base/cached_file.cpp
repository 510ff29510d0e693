// SPDX-License-Identifier: MIT
#include "base/cached_file.hpp"

#define XXH_INLINE_ALL
#include <fmt/format.h>
#include <xxhash.h>

#include <fstream>
#include <stdexcept>
#include <system_error>
#include <type_traits>

#include "base/files.hpp"

namespace gloam::base {
namespace {

struct Header {
    std::array<char, 8> magic{'g', 'l', 'o', 'a', 'm', 'k', 'e', 'y'};
    std::uint64_t format = 1;
    Hash key{};
    std::uint64_t length = 0;
    Hash checksum{};

    friend bool operator==(const Header&, const Header&) = default;
};
static_assert(std::is_trivially_copyable_v<Header> && std::has_unique_object_representations_v<Header>);

Header header_of(const Hash& key, std::string_view payload) {
    return {.key = key, .length = payload.size(), .checksum = hash_of(payload)};
}

}  // namespace

Hash hash_of(std::string_view bytes) {
    const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
    return {hash.high64, hash.low64};
}

std::string to_hex(const Hash& hash) {
    return fmt::format("{:016x}{:016x}", hash[0], hash[1]);
}

void Fingerprint::add(std::string_view field) {
    add(static_cast<std::uint64_t>(field.size()));
    bytes_ += field;
}

void Fingerprint::add(std::uint64_t field) {
    for (int shift = 0; shift < 64; shift += 8) bytes_ += static_cast<char>((field >> shift) & 0xffu);
}

std::optional<std::string> read_cached(const std::filesystem::path& file, const Hash& key) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size < sizeof(Header)) return std::nullopt;

    std::ifstream stream(file, std::ios::binary);
    std::array<char, sizeof(Header)> bytes{};
    if (!stream.read(bytes.data(), bytes.size())) return std::nullopt;
    const auto header = std::bit_cast<Header>(bytes);
    // Tested before the payload is read, because a foreign file may have any size.
    if (header.magic != Header{}.magic || header.length != size - sizeof(Header)) return std::nullopt;

    std::string payload(header.length, '\0');
    if (!stream.read(payload.data(), static_cast<std::streamsize>(payload.size()))) return std::nullopt;
    if (header != header_of(key, payload)) return std::nullopt;
    return payload;
}

bool write_cached(const std::filesystem::path& file, const Hash& key, std::string_view payload) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    // An empty folder of this name is removed; a folder with content is not.
    if (std::filesystem::is_directory(file, error)) std::filesystem::remove(file, error);
    const auto header = std::bit_cast<std::array<char, sizeof(Header)>>(header_of(key, payload));
    try {
        write_file(file, std::string(header.data(), header.size()).append(payload));
    } catch (const std::runtime_error&) {
        return false;
    }
    return true;
}

}  // namespace gloam::base
