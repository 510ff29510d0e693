// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/camera.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// A rigid moving object.
struct MovingObject {
    Mesh mesh;                                       // object space, world units
    std::function<glm::dmat4(int frame)> transform;  // object to world: a rotation and a translation
};

// A scene: static triangles, moving objects, a camera, and the radius of influence. Camera and objects are
// functions of the frame number, from 0.
struct Scene {
    std::string name;
    Mesh mesh;  // world space
    Camera camera;
    double ao_radius = 0.5;                          // world units
    std::vector<MovingObject> objects{};             // rendered after the mesh
    std::function<Camera(int frame)> camera_path{};  // empty: `camera` is static
    std::optional<glm::dvec3> lamp{};  // world position of the light of an interior; empty: the sun
};

// The camera of a frame.
[[nodiscard]] Camera camera_at(const Scene& scene, int frame);

// All triangles in a frame, in that frame's view space: the mesh, then the objects in order. They are
// calculated in double and rounded once, so that they are as exact far from the origin as near it. Throws
// std::invalid_argument for an invalid camera.
[[nodiscard]] Mesh view_space_mesh(const Scene& scene, int frame);

struct ViewInfo {
    std::string name;
    std::string kind;  // "interior", "hall", "foliage", "machine", "terrain", "mesh", "scene" or "motion"
    std::string description;
    // "tuning": constants are fitted on it; "unseen": what is claimed of them is measured on it; "": neither.
    std::string half;
};

// The scenes and views on which settings are fitted and judged. The row of one says to which half it belongs;
// none ever changes its half. Those of kind "scene" are the built-in scenes.
[[nodiscard]] std::vector<ViewInfo> all_views();

// The folder in which Debian's glmark2-data installs its meshes.
[[nodiscard]] std::filesystem::path installed_meshes();

// A scene or view by name, bit-identical every time. meshes: folder of the mesh files that some show. Throws
// std::invalid_argument that lists the names, and std::runtime_error for a mesh that cannot be read.
[[nodiscard]] Scene make_scene(std::string_view name,
                               const std::filesystem::path& meshes = installed_meshes());

}  // namespace gloam::scene
