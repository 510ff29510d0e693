// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "gpu/device.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// The first queue family for both graphics and compute.
[[nodiscard]] std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device);

// The properties of a device. `index`: copied to the result.
[[nodiscard]] DeviceInfo describe(const vk::raii::PhysicalDevice& device, std::size_t index);

}  // namespace gloam::gpu
