// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace gloam::gpu {

// The fields of a pipeline cache's header that identify the driver.
struct DriverKey {
    std::uint32_t vendor = 0;
    std::uint32_t device = 0;
    std::array<std::uint8_t, 16> uuid{};
};

// Whether the blob begins with a complete header (VkPipelineCacheHeaderVersionOne) of this driver.
[[nodiscard]] bool is_pipeline_cache_of(std::span<const std::byte> blob, const DriverKey& driver);

}  // namespace gloam::gpu
