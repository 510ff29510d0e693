// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "gpu/device.hpp"

namespace gloam::gpu {

// The one line that every caller without a usable driver reads.
inline constexpr const char* no_device_message =
    "no Vulkan device found: install a Vulkan driver, for example mesa-vulkan-drivers";

// The position in `devices` that a DeviceOptions::device text means. Throws std::runtime_error when there is
// no device, or none that matches (the line lists those there are).
[[nodiscard]] std::size_t select_device(std::span<const DeviceInfo> devices, std::string_view selector);

}  // namespace gloam::gpu
