// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/buffer.hpp"
#include "gpu/internal/guarded.hpp"

namespace gloam::gpu {

struct BufferHandles {
    vk::raii::Buffer buffer;
    vk::raii::DeviceMemory memory;
};

struct Buffer::Impl {
    Impl(Context& owner, std::size_t bytes);

    Context& context;
    Guarded<BufferHandles> handles;
    std::span<std::byte> mapped;
};

}  // namespace gloam::gpu
