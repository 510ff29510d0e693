// SPDX-License-Identifier: MIT
#include "backend/vulkan/internal/pipeline_cache.hpp"

#include <algorithm>
#include <cstring>

#include "base/cached_file.hpp"

namespace gloam::gpu {
namespace {

std::string load(const std::filesystem::path& file, const vk::PhysicalDeviceProperties& properties) {
    if (file.empty()) return {};
    const auto blob = base::read_cached(file, {});
    const DriverKey driver{properties.vendorID, properties.deviceID, properties.pipelineCacheUUID};
    return blob && is_pipeline_cache_of(std::as_bytes(std::span(*blob)), driver) ? *blob : std::string();
}

std::filesystem::path file_in(const std::filesystem::path& directory, const std::string& identity) {
    return directory.empty() ? std::filesystem::path{} : directory / ("pipelines-" + identity + ".bin");
}

// SwiftShader returns the data that it was given behind one more header, so its file would grow with every
// use.
bool is_news(std::string_view data, std::string_view loaded) {
    if (data == loaded) return false;
    const bool one_header_more =
        !loaded.empty() && data.size() == loaded.size() + sizeof(VkPipelineCacheHeaderVersionOne);
    return !(one_header_more && data.ends_with(loaded));
}

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
        const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
        if (is_news(bytes, loaded_)) base::write_cached(file_, {}, bytes);
    } catch (...) {
        // On failure the next process compiles again.
    }
}

bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver) {
    BlobHeader header;
    if (blob.size() < sizeof header) return false;
    std::memcpy(&header, blob.data(), sizeof header);
    return header.bytes >= sizeof header && header.bytes <= blob.size() &&
           header.version == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendor == driver.vendor &&
           header.device == driver.device && header.uuid == driver.uuid;
}

}  // namespace gloam::gpu
