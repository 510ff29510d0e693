// SPDX-License-Identifier: MIT
#include "gpu/internal/cache_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <random>
#include <system_error>

#include "gpu/internal/fnv.hpp"

namespace gloam::gpu {
namespace {

struct Header {
    std::array<char, 8> magic{'g', 'l', 'o', 'a', 'm', 'p', 'c', '1'};
    std::uint64_t bytes = 0;
    std::uint64_t checksum = 0;
    friend bool operator==(const Header&, const Header&) = default;
};
static_assert(sizeof(Header) == 24);

Header header_of(std::span<const std::byte> content) {
    return {.bytes = content.size(), .checksum = fnv1a(content)};
}

bool write_whole(const std::filesystem::path& file, std::span<const std::byte> content) {
    const auto header = header_of(content);
    std::ofstream out(file, std::ios::binary | std::ios::trunc);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
    out.close();
    return !out.fail();
}

// Two processes that write simultaneously must not use the same temporary file.
std::filesystem::path temporary_beside(const std::filesystem::path& file) {
    std::random_device random;
    auto temporary = file;
    temporary += fmt::format(".{:08x}{:08x}.tmp", random(), random());
    return temporary;
}

}  // namespace

std::vector<std::byte> read_cache_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto size = std::filesystem::file_size(file, error);
    if (error || size < sizeof(Header)) return {};
    std::ifstream in(file, std::ios::binary);
    Header header;
    in.read(reinterpret_cast<char*>(&header), sizeof header);
    if (!in || header.bytes != size - sizeof header) return {};
    std::vector<std::byte> content(static_cast<std::size_t>(header.bytes));
    in.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(content.size()));
    if (!in || header != header_of(content)) return {};
    return content;
}

bool write_cache_file(const std::filesystem::path& file, std::span<const std::byte> content) {
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    const auto temporary = temporary_beside(file);
    if (write_whole(temporary, content)) {
        std::filesystem::rename(temporary, file, error);
        if (!error) return true;
    }
    std::filesystem::remove(temporary, error);
    return false;
}

}  // namespace gloam::gpu
