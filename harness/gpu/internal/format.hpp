// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "gpu/image.hpp"
#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// Properties of a Format for Vulkan and for copies.
struct FormatTraits {
    const char* name;
    vk::Format format;
    int channels;
    std::size_t texel_bytes;
    vk::ImageAspectFlagBits aspect;
    vk::ImageUsageFlags usage;  // besides copies
};

[[nodiscard]] const FormatTraits& traits(Format format);

}  // namespace gloam::gpu
