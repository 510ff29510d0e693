// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "scene/camera.hpp"

namespace gloam::scene {

// How an engine stores depth and normals.
struct Encoding {
    bool depth_buffer =
        false;                // depth-buffer values in [0, 1] of the frame's projection; otherwise eye-linear
    bool world = false;       // normals in world space; otherwise in view space
    bool octahedral = false;  // normals as two octahedral coordinates; otherwise three components
    bool unorm = false;       // of normals, 0 to 1 stands for -1 to 1; otherwise numbers as they are

    friend auto operator<=>(const Encoding&, const Encoding&) = default;
};

// depth: "linear" or "buffer". normals: "view" or "world", and "octahedral" and "unorm" behind a '-':
// "world-octahedral-unorm". Throws std::invalid_argument for another name.
[[nodiscard]] Encoding encoding_named(const std::string& depth, const std::string& normals);

// Eye-linear depth of a stored value, as passes/engine_inputs.glsl has it, in double; background +infinity.
[[nodiscard]] float linear_depth(float stored, const Encoding& encoding, const CameraFrame& camera);

// View-space unit normal of a stored texel; 0 without a direction.
[[nodiscard]] glm::vec3 view_normal(const glm::vec3& stored, const Encoding& encoding,
                                    const CameraFrame& camera);

// What an engine stores of an eye-linear depth, and of a view-space unit normal; not rounded to fewer bits.
[[nodiscard]] double stored_depth(double depth, const Encoding& encoding, const CameraFrame& camera);
[[nodiscard]] glm::dvec3 stored_normal(const glm::dvec3& normal, const Encoding& encoding,
                                       const CameraFrame& camera);

}  // namespace gloam::scene
