// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/pack/effect.hpp"

namespace gloam::cli {

// The format's name in Vulkan's headers.
[[nodiscard]] std::string vulkan_format(gpu::Format format);
[[nodiscard]] std::string vulkan_descriptor(shader::BindingType type);

// "engine", "kept", "once", "frame".
[[nodiscard]] std::string to_string(effect::PlannedImage::Origin origin);

// The uses of an image, from the bindings of the passes: VK_IMAGE_USAGE_STORAGE_BIT and others.
[[nodiscard]] std::vector<std::string> vulkan_usage(const PackedEffect& effect,
                                                    const effect::PlannedImage& image);

}  // namespace gloam::cli
