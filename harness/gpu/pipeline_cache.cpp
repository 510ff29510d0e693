// SPDX-License-Identifier: MIT
#include "gpu/internal/pipeline_cache.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>
#include <system_error>

#include "gpu/internal/fnv.hpp"

namespace gloam::gpu {
namespace {

std::vector<std::byte> load(const std::filesystem::path& file,
                            const vk::PhysicalDeviceProperties& properties) {
    if (file.empty()) return {};
    auto blob = read_cache_file(file);
    const DriverKey driver{properties.vendorID, properties.deviceID, properties.pipelineCacheUUID};
    if (!is_pipeline_cache_of(blob, driver)) blob.clear();
    return blob;
}

std::filesystem::path file_in(const std::filesystem::path& directory, const std::string& identity) {
    return directory.empty() ? std::filesystem::path{} : directory / ("pipelines-" + identity + ".bin");
}

// SwiftShader returns the data that it was given behind one more header, so its file would grow with every
// use.
bool is_news(std::span<const std::byte> data, std::span<const std::byte> loaded) {
    if (std::ranges::equal(data, loaded)) return false;
    const bool one_header_more =
        !loaded.empty() && data.size() == loaded.size() + sizeof(VkPipelineCacheHeaderVersionOne);
    return !(one_header_more && std::ranges::equal(data.last(loaded.size()), loaded));
}

}  // namespace

PipelineCache::PipelineCache(const vk::raii::Device& device, const vk::PhysicalDeviceProperties& properties,
                             const std::filesystem::path& directory, const std::string& identity)
    : file_(file_in(directory, identity)),
      loaded_(load(file_, properties)),
      cache_(device,
             vk::PipelineCacheCreateInfo{.initialDataSize = loaded_.size(), .pInitialData = loaded_.data()}) {
}

void PipelineCache::save() const noexcept {
    if (file_.empty()) return;
    try {
        const auto data = cache_.getData();
        const auto bytes = std::as_bytes(std::span(data));
        if (is_news(bytes, loaded_)) write_cache_file(file_, bytes);
    } catch (...) {
        // On failure the next process compiles again.
    }
}

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

namespace {

// VkPipelineCacheHeaderVersionOne with an integer in place of its enumeration: reading a damaged enumeration
// would be undefined.
struct BlobHeader {
    std::uint32_t bytes = 0;
    std::uint32_t version = 0;
    std::uint32_t vendor = 0;
    std::uint32_t device = 0;
    std::array<std::uint8_t, 16> uuid{};
};
static_assert(sizeof(BlobHeader) == sizeof(VkPipelineCacheHeaderVersionOne));

}  // namespace

bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver) {
    BlobHeader header;
    if (blob.size() < sizeof header) return false;
    std::memcpy(&header, blob.data(), sizeof header);
    return header.bytes >= sizeof header && header.bytes <= blob.size() &&
           header.version == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendor == driver.vendor &&
           header.device == driver.device && header.uuid == driver.uuid;
}

}  // namespace gloam::gpu
