// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "gpu/device.hpp"

namespace gloam::gpu {

// The message if there is no usable driver, in one line.
inline constexpr const char* no_device_message =
    "no Vulkan device found: install a Vulkan driver, for example mesa-vulkan-drivers";

// The index in `devices` of the device that DeviceOptions::device selects. Throws std::runtime_error if there
// is no device, or if none matches (the message lists the existing ones).
[[nodiscard]] std::size_t select_device(std::span<const DeviceInfo> devices, std::string_view selector);

}  // namespace gloam::gpu
