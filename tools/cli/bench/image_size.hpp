// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gpu/resources.hpp"

namespace gloam::cli {

// Parses --size: WIDTHxHEIGHT in pixels, each 16 to 4096, so that a kernel, a window and a pixel's neighbours
// fit. Throws std::invalid_argument otherwise.
[[nodiscard]] gpu::Extent image_size(const std::string& text);

}  // namespace gloam::cli
