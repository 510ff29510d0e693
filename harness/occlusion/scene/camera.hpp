// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace gloam::scene {

enum class Projection { perspective, orthographic };

// A camera by position and direction. View space is right-handed and looks down -z.
struct Camera {
    glm::dvec3 eye{0, 0, 0};
    glm::dvec3 target{0, 0, -1};
    glm::dvec3 up{0, 1, 0};
    Projection projection = Projection::perspective;
    double fovy_rad = 0.9;     // perspective: full vertical angle
    double view_height = 2.0;  // orthographic: world units from bottom to top
    double near = 0.1;         // world units, > 0
    double far = 100.0;        // world units, > near; +infinity allowed for perspective
    bool reversed_z = false;   // the near plane at depth-buffer value 1
};

// The matrices of one frame (GLM: column-major), single precision as a shader has them.
struct CameraFrame {
    glm::mat4 view{1};                       // world to view
    glm::mat4 proj_vk{1};                    // view to clip: y down, z in [0, 1]
    std::optional<glm::mat4> previous_view;  // world to view of the frame before
    // View space of this frame to that of the previous one. It is calculated in double where the cameras are
    // known, because the product of the two matrices above loses the difference far from the origin.
    std::optional<glm::mat4> previous_from_current;

    // Elements [0][0] and [1][1] of proj_vk; the shaders call them p00_p11.
    [[nodiscard]] glm::vec2 p00_p11() const { return {proj_vk[0][0], proj_vk[1][1]}; }
    [[nodiscard]] bool orthographic() const { return proj_vk[2][3] == 0.0F; }
};

// The matrices for an image with this ratio of width to height, calculated in double. Throws
// std::invalid_argument for a camera without a direction, a field of view outside (0, pi), or planes that do
// not satisfy 0 < near < far.
[[nodiscard]] CameraFrame make_frame(const Camera& camera, double aspect);

// The same, and the view matrix of the previous frame's camera.
[[nodiscard]] CameraFrame make_frame(const Camera& camera, double aspect, const Camera& previous);

// World to view, the rotation only: view position = rotation * (world position - eye). Throws
// std::invalid_argument for a camera without a direction.
[[nodiscard]] glm::dmat3 view_rotation(const Camera& camera);

// The same projection for OpenGL (clip y up, z in [-1, 1]), and back.
[[nodiscard]] glm::dmat4 gl_from_vk(const glm::dmat4& proj_vk);
[[nodiscard]] glm::dmat4 vk_from_gl(const glm::dmat4& proj_gl);

// Depths of the two ends of a projection's depth range, nearer end first; +infinity for an infinite far
// plane.
struct Planes {
    double near = 0.0;
    double far = 0.0;
    bool reversed_z = false;
};
[[nodiscard]] Planes planes_of(const glm::mat4& proj_vk);

// How an engine stores depth and normals.
struct Encoding {
    // Depth-buffer values in [0, 1] of the frame's projection; otherwise eye-linear.
    bool depth_buffer = false;
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

// A stored view-space normal with its z turned: of the same view in a left-handed view space, or back.
[[nodiscard]] glm::vec3 other_handed(glm::vec3 stored, const Encoding& encoding);

// What an engine stores of an eye-linear depth, and of a view-space unit normal; not rounded to fewer bits.
[[nodiscard]] double stored_depth(double depth, const Encoding& encoding, const CameraFrame& camera);
[[nodiscard]] glm::dvec3 stored_normal(const glm::dvec3& normal, const Encoding& encoding,
                                       const CameraFrame& camera);

}  // namespace gloam::scene
