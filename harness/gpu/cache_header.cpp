// SPDX-License-Identifier: MIT
#include "gpu/internal/cache_header.hpp"

#include <cstring>

#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {
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
