// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "base/image_files.hpp"

namespace gloam::scene {

// Reads the first part of an OpenEXR file: float, half or integer channels, the whole data window. For one
// channel it takes Y, Z, R, depth, or the only one; for three R G B, or X Y Z. Throws std::runtime_error with
// the file's name and what was expected.
[[nodiscard]] base::FloatImage read_exr(const std::filesystem::path& file, int channels);

}  // namespace gloam::scene
