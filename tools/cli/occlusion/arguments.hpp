// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "backend/vulkan/resources.hpp"

namespace gloam::cli {

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

// The value of --size for images that are judged: each side 16 to 4096 pixels, so that a kernel, a window and
// a pixel's neighbours fit.
[[nodiscard]] gpu::Extent judged_size(const std::string& text);

}  // namespace gloam::cli
