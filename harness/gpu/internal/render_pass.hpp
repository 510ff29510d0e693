// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gpu/image.hpp"
#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// One subpass: colour attachments in order, then depth. All are cleared first and end in
// VK_IMAGE_LAYOUT_GENERAL.
[[nodiscard]] vk::raii::RenderPass make_render_pass(const Context& context,
                                                    std::span<const Format> color_formats);

}  // namespace gloam::gpu
