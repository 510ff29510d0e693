// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/device.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// The requested device features besides the core: robustBufferAccess, which every device has, unless the
// options switch it off. With it, a shader under test that reads beyond its buffer cannot crash the process.
// And storing to images of r16f and r8, where the device can.
[[nodiscard]] inline vk::PhysicalDeviceFeatures features_of(const DeviceOptions& options,
                                                            const vk::PhysicalDeviceFeatures& offered = {}) {
    return {.robustBufferAccess = options.robust_buffer_access ? VK_TRUE : VK_FALSE,
            .shaderStorageImageExtendedFormats = offered.shaderStorageImageExtendedFormats};
}

}  // namespace gloam::gpu
