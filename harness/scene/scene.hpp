// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// What is rendered: triangles, a camera that shows them well, and the radius within which occluders count.
struct Scene {
    std::string name;
    Mesh mesh;
    Camera camera;
    double ao_radius = 0.5;  // world units
};

struct SceneInfo {
    std::string name;
    std::string description;
};

// The built-in scenes: "columns" (a deep column hall), "corner" (a floor and two walls: occlusion known in
// closed form).
[[nodiscard]] std::vector<SceneInfo> built_in_scenes();

// A built-in scene by name. Throws std::invalid_argument that lists the names.
[[nodiscard]] Scene make_scene(std::string_view name);

// A mesh scaled to a largest side of 1 and stood on a ground plane (y up), with a camera that sees all of it.
// Throws std::invalid_argument for a mesh without extent.
[[nodiscard]] Scene mesh_on_ground(Mesh mesh, std::string name);

}  // namespace gloam::scene
