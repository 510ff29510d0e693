// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/device.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// What is asked of the device beyond the core: robustBufferAccess, which every device has, unless it is
// switched off. A shader under test that reads past its buffer must not take the process with it.
[[nodiscard]] inline vk::PhysicalDeviceFeatures features_of(const DeviceOptions& options) {
    return {.robustBufferAccess = options.robust_buffer_access ? VK_TRUE : VK_FALSE};
}

}  // namespace gloam::gpu
