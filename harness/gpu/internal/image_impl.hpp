// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/image.hpp"
#include "gpu/internal/format.hpp"
#include "gpu/internal/guarded.hpp"

namespace gloam::gpu {

struct ImageHandles {
    vk::raii::Image image;
    vk::raii::DeviceMemory memory;
    vk::raii::ImageView view;
};

// The image is in VK_IMAGE_LAYOUT_GENERAL whenever no render pass uses it.
struct Image::Impl {
    Impl(Context& owner, Extent size, Format kind);

    Context& context;
    Extent extent;
    Format format;
    Guarded<ImageHandles> handles;
};

}  // namespace gloam::gpu
