// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

#include "gpu/image.hpp"

namespace gloam::scene {

// Light from far away: radiance over directions of the world. Columns are longitudes, -z in the middle
// and +x to the right of it, rows polar angles from +y down; rows from the top.
struct Environment {
    gpu::Extent extent;
    std::vector<glm::vec3> radiance;  // any unit, >= 0, finite
};

// The same from everywhere.
[[nodiscard]] Environment constant_environment(const glm::vec3& radiance);

// A clear sky: blue at the zenith, white at the horizon, dim and brown below it.
[[nodiscard]] Environment sky_environment();

// An equirectangular image, .exr or .pfm, three channels. What is negative or not finite counts as 0. Throws
// std::runtime_error that names the file: missing, malformed, another kind.
[[nodiscard]] Environment read_environment(const std::filesystem::path& file);

}  // namespace gloam::scene
