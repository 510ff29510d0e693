// SPDX-License-Identifier: MIT
#include "shader/internal/entry.hpp"

#include <bit>
#include <cstring>
#include <fstream>
#include <random>
#include <type_traits>

namespace gloam::shader::internal {
namespace {

struct Header {
    std::array<char, 8> magic{'g', 'l', 'o', 'a', 'm', 'S', 'P', 'V'};
    std::uint64_t format = 1;
    Hash key{};
    std::uint64_t length = 0;
    Hash checksum{};

    friend bool operator==(const Header&, const Header&) = default;
};
static_assert(std::is_trivially_copyable_v<Header> && std::has_unique_object_representations_v<Header>);

Header header_of(const Hash& key, std::string_view payload) {
    Header header;
    header.key = key;
    header.length = payload.size();
    header.checksum = hash_of(payload);
    return header;
}

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
    std::random_device random;
    const Hash tag{(std::uint64_t{random()} << 32) | random(), (std::uint64_t{random()} << 32) | random()};
    std::filesystem::path temporary = file;
    temporary.concat(".").concat(to_hex(tag)).concat(".tmp");
    return temporary;
}

bool write_file(const std::filesystem::path& file, const Header& header, std::string_view payload) {
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    const auto bytes = std::bit_cast<std::array<char, sizeof(Header)>>(header);
    stream.write(bytes.data(), bytes.size());
    stream.write(payload.data(), static_cast<std::streamsize>(payload.size()));
    stream.close();
    return stream.good();
}

}  // namespace

std::optional<std::string> read_entry(const std::filesystem::path& file, const Hash& key) {
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

void write_entry(const std::filesystem::path& file, const Hash& key, std::string_view payload) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    const std::filesystem::path temporary = temporary_beside(file);
    bool written = write_file(temporary, header_of(key, payload), payload);
    if (written) {
        std::filesystem::rename(temporary, file, error);
        // An empty folder of this name is removed; a folder with content is not.
        if (error && std::filesystem::is_directory(file, error) && std::filesystem::remove(file, error))
            std::filesystem::rename(temporary, file, error);
        written = !error;
    }
    if (!written) std::filesystem::remove(temporary, error);
}

}  // namespace gloam::shader::internal
