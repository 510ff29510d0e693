// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gpu/image.hpp"
#include "scene/camera.hpp"

namespace gloam::scene {

// What an engine hands to an ambient-occlusion effect: one frame, rows from the top, width * height elements
// in each image that is there.
struct GBuffer {
    gpu::Extent extent;
    std::vector<float> depth;  // eye-linear, world units; background +infinity
    std::vector<glm::vec3>
        normal;  // view space, unit, facing the viewer; background 0. Empty: from the depth
    std::vector<glm::vec3> motion;  // dx, dy in pixels (y down), valid. Empty: from the cameras alone
    CameraFrame camera;
    std::optional<double> ao_radius;  // world units
};

}  // namespace gloam::scene
