// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "backend/vulkan/resources.hpp"

namespace gloam::cli {

// All of a file, of at most base::largest_text bytes. Throws std::runtime_error that names it and says why it
// cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path& file);

// The value of --size: "640x360". Throws std::invalid_argument that names --size.
[[nodiscard]] gpu::Extent parse_size(const std::string& text);

// The value of --size for images that are judged: each side 16 to 4096 pixels, so that a kernel, a window and
// a pixel's neighbours fit.
[[nodiscard]] gpu::Extent judged_size(const std::string& text);

}  // namespace gloam::cli
