// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "gpu/image.hpp"

namespace gloam::cli {

// "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

}  // namespace gloam::cli
