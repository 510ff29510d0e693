// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "base/image_files.hpp"

namespace gloam::scene {

// Reads the first part of an OpenEXR file: float, half or integer channels, the whole data window. For one
// channel it takes Y, Z, R, depth, or the only one; for three R G B, or X Y Z. Throws std::runtime_error with
// the file's name and what was expected.
[[nodiscard]] base::FloatImage read_exr(const std::filesystem::path& file, int channels);

// Light from infinitely far away: radiance by direction in the world. Columns are longitudes, with -z in the
// middle and +x to the right of it; rows are polar angles from +y downwards, top row first.
struct Environment {
    gpu::Extent extent;
    std::vector<glm::vec3> radiance;  // any unit, >= 0, finite
};

// An environment with the same radiance in all directions.
[[nodiscard]] Environment constant_environment(const glm::vec3& radiance);

// A clear sky: blue at the zenith, white at the horizon, dim and brown below it.
[[nodiscard]] Environment sky_environment();

// Reads an equirectangular image, .exr or .pfm, with three channels. Negative and non-finite values count as
// 0. Throws std::runtime_error with the file's name if it is missing, malformed or of another kind.
[[nodiscard]] Environment read_environment(const std::filesystem::path& file);

}  // namespace gloam::scene
