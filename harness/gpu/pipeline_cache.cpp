// SPDX-License-Identifier: MIT
#include "gpu/internal/pipeline_cache.hpp"

#include <algorithm>
#include <cstring>
#include <span>

#include "gpu/internal/cache_file.hpp"

namespace gloam::gpu {
namespace {

// Does the blob's own header (VkPipelineCacheHeaderVersionOne) name this device and driver?
bool fits(std::span<const std::byte> blob, const vk::PhysicalDeviceProperties& properties) {
    VkPipelineCacheHeaderVersionOne header{};
    if (blob.size() < sizeof header) return false;
    std::memcpy(&header, blob.data(), sizeof header);
    return header.headerSize >= sizeof header && header.headerSize <= blob.size() &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
           header.vendorID == properties.vendorID && header.deviceID == properties.deviceID &&
           std::ranges::equal(header.pipelineCacheUUID, properties.pipelineCacheUUID);
}

std::vector<std::byte> load(const std::filesystem::path& file,
                            const vk::PhysicalDeviceProperties& properties) {
    if (file.empty()) return {};
    auto blob = read_cache_file(file);
    if (!fits(blob, properties)) blob.clear();
    return blob;
}

std::filesystem::path file_in(const std::filesystem::path& directory, const std::string& identity) {
    return directory.empty() ? std::filesystem::path{} : directory / ("pipelines-" + identity + ".bin");
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
        if (!std::ranges::equal(bytes, loaded_)) write_cache_file(file_, bytes);
    } catch (...) {
        // The next process compiles again.
    }
}

}  // namespace gloam::gpu
