// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "gpu/image.hpp"
#include "scene/camera.hpp"
#include "scene/encoding.hpp"

namespace gloam::scene {

// Depth layers besides the first one.
constexpr int most_further_layers = 3;

// Depth and normals as an engine stores them.
struct StoredInputs {
    Encoding encoding;
    std::vector<float> depth;
    std::vector<glm::vec3> normal;  // empty if the engine has none
};

// The input of an ambient-occlusion effect from an engine: one frame, rows from the top. Each image has width
// * height elements, or is empty.
struct GBuffer {
    gpu::Extent extent;
    std::vector<float> depth;  // eye-linear, world units; background +infinity
    std::vector<glm::vec3>
        normal;  // view space, unit, facing the viewer; background 0. Empty: from the depth
    std::vector<glm::vec3> motion;      // dx, dy in pixels (y down), valid. Empty: from the cameras alone
    std::vector<float> previous_depth;  // with motion: eye-linear depth of the surface point in the camera of
                                        // the frame before. Empty: from the cameras
    // Surfaces behind depth, nearest first, at most most_further_layers of them: eye-linear depth, negative
    // for a surface seen from behind, which ends the solid in front of it. Not finite: no further surface.
    std::vector<std::vector<float>> layers;
    std::vector<glm::vec3> color;  // diffuse albedo, linear, [0, 1]. Empty: white
    CameraFrame camera;
    std::optional<double> ao_radius;  // world units
    gpu::Extent border;  // guard band around the frame, pixels on each side, part of extent (guard_band.hpp)

    // Depth and normals again, as the engine stores them: the effect converts these on the device.
    std::optional<StoredInputs> stored;

    // Only from rasterize(), on request; previous_position also from link().
    std::vector<glm::vec3> previous_position;  // where the surface point was, in the view space of the frame
                                               // before; background 0
    std::vector<std::uint32_t> object;         // 0: static, k: the k-th moving object; background 0
    std::vector<std::uint32_t> triangle;       // counted over all meshes; background 2^32 - 1
};

}  // namespace gloam::scene
