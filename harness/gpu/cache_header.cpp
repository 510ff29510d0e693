// SPDX-License-Identifier: MIT
#include "gpu/internal/cache_header.hpp"

#include <algorithm>
#include <cstring>

#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver) {
    VkPipelineCacheHeaderVersionOne header{};
    if (blob.size() < sizeof header) return false;
    std::memcpy(&header, blob.data(), sizeof header);
    return header.headerSize >= sizeof header && header.headerSize <= blob.size() &&
           header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE && header.vendorID == driver.vendor &&
           header.deviceID == driver.device && std::ranges::equal(header.pipelineCacheUUID, driver.uuid);
}

}  // namespace gloam::gpu
