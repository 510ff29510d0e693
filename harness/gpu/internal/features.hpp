// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/device.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// The requested device features besides the core: robustBufferAccess, which every device has, unless the
// options switch it off. With it, a shader under test that reads beyond its buffer cannot crash the process.
[[nodiscard]] inline vk::PhysicalDeviceFeatures features_of(const DeviceOptions& options) {
    return {.robustBufferAccess = options.robust_buffer_access ? VK_TRUE : VK_FALSE};
}

}  // namespace gloam::gpu
