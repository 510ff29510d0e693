// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// A mesh that moves as one piece.
struct MovingObject {
    Mesh mesh;                                       // object space, world units
    std::function<glm::dmat4(int frame)> transform;  // object to world: a rotation and a translation
};

// What is rendered: triangles that stand still, objects that move, a camera that shows them well, and the
// radius within which occluders count. Camera and objects are functions of the frame's number, 0 and up.
struct Scene {
    std::string name;
    Mesh mesh;  // world space
    Camera camera;
    double ao_radius = 0.5;                          // world units
    std::vector<MovingObject> objects{};             // drawn after the mesh
    std::function<Camera(int frame)> camera_path{};  // empty: `camera` stands still
    std::optional<glm::dvec3> lamp{};  // world position of the light of an interior; empty: the sun
};

// The camera of a frame.
[[nodiscard]] Camera camera_at(const Scene& scene, int frame);

// Everything as it stands in a frame, in that frame's view space: calculated in double and rounded once, so
// that it is as exact far from the origin as near it. First the mesh, then the objects in their order.
// Throws std::invalid_argument for a bad camera.
[[nodiscard]] Mesh view_space_mesh(const Scene& scene, int frame);

// Throws std::invalid_argument that names the scene: no triangles, indices that do not fit the vertices,
// vertices that are not finite, an object without a transform.
void validate(const Scene& scene);

struct SceneInfo {
    std::string name;
    std::string description;
};

// The built-in scenes: code, the same to the bit every time.
[[nodiscard]] std::vector<SceneInfo> built_in_scenes();

// A built-in scene by name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Scene make_scene(std::string_view name);

}  // namespace gloam::scene
