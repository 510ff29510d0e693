// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>

#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// Memory with the first properties in `wishes` for which the device has a suitable type. Throws
// std::runtime_error with the purpose if there is no such type or not enough memory.
[[nodiscard]] vk::raii::DeviceMemory allocate(const Context& context, const vk::MemoryRequirements& needs,
                                              std::initializer_list<vk::MemoryPropertyFlags> wishes,
                                              const std::string& purpose);

}  // namespace gloam::gpu
