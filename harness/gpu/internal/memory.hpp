// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// Memory of the first wish in `wishes` that the device has a fitting type for. Throws std::runtime_error when
// there is none or not enough of it; the message says what it was for.
[[nodiscard]] vk::raii::DeviceMemory allocate(const Context& context, const vk::MemoryRequirements& needs,
                                              std::initializer_list<vk::MemoryPropertyFlags> wishes,
                                              const std::string& purpose);

}  // namespace gloam::gpu
