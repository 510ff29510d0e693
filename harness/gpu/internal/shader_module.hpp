// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// Drivers can crash on words that are not a module, so it throws std::invalid_argument unless these at least
// begin like one.
[[nodiscard]] vk::raii::ShaderModule make_module(const Context& context,
                                                 std::span<const std::uint32_t> spirv);

// Throws std::invalid_argument unless the size is a multiple of 4 within the device's limit.
void check_push_constant_size(const Context& context, std::uint32_t bytes);

}  // namespace gloam::gpu
