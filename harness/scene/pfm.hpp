// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "gpu/image.hpp"

namespace gloam::scene {

// A float image, rows from the top, `channels` floats for each pixel.
struct FloatImage {
    gpu::Extent extent;
    int channels = 1;
    std::vector<float> texels;
};

// Reads a portable float map (Pf or PF, either byte order). Throws std::runtime_error with the file's name if
// it is missing, not a PFM, truncated, or longer than its header says.
[[nodiscard]] FloatImage read_pfm(const std::filesystem::path& file);

}  // namespace gloam::scene
