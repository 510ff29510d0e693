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

// A mesh scaled to a height of 1 (where it has next to none, to a longest side of 1) and stood on the ground
// plane y = 0, with a camera that sees all of it in images at least as wide as high. Throws
// std::invalid_argument for a mesh without extent.
[[nodiscard]] Scene mesh_on_ground(Mesh mesh, std::string name);

}  // namespace gloam::scene
