// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "scene/pfm.hpp"

namespace gloam::scene {

// Reads the first part of an OpenEXR file, float, half or integer channels, all of its data window. One
// channel wanted: Y, Z, R, depth, or the only one there is; three: R G B, or X Y Z. Throws std::runtime_error
// that names the file and what was expected.
[[nodiscard]] FloatImage read_exr(const std::filesystem::path& file, int channels);

}  // namespace gloam::scene
