// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gloam::gpu {

// What Vulkan puts into the header of a pipeline cache to say which driver can use it.
struct DriverKey {
    std::uint32_t vendor = 0;
    std::uint32_t device = 0;
    std::array<std::uint8_t, 16> uuid{};
};

// Does the blob begin with a whole header (VkPipelineCacheHeaderVersionOne) of this driver?
[[nodiscard]] bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver);

}  // namespace gloam::gpu
