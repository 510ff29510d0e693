// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scene/mesh.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// How a mesh is stood and looked at. Positions are in mesh heights: the mesh is 1 high, the middle of its
// foot is the origin, up is +y, the front looks along +z.
struct MeshView {
    glm::dvec3 up{0, 1, 0};           // of the file: one of its axes or their opposites
    bool ground = true;               // a plane under the mesh
    double azimuth_deg = 20.0;        // of the eye around the mesh, from the front towards +x
    double elevation_deg = 22.0;      // of the eye above the horizon, -89 to 89
    int turntable = 0;                // frames of one full turn around the mesh; 0: the camera stands still
    std::optional<glm::dvec3> eye{};  // instead of azimuth and elevation
    std::optional<glm::dvec3> look_at{};  // default: the middle of the mesh
    double aspect = 1.0;                  // of the image, width over height
};

// "x", "y", "z", "-x", "-y" or "-z" as a direction; nullopt for another text.
[[nodiscard]] std::optional<glm::dvec3> axis_named(std::string_view name);

// A mesh scaled to a height of 1 (where it has next to none, to a longest side of 1) and stood on the plane
// y = 0. Without an eye of its own the camera is as near as it can be to show all of the mesh with a margin,
// from every side of a turntable. Throws std::invalid_argument for a mesh without extent, an elevation or a
// number of frames out of range, an aspect that is not > 0, and an eye that is where it looks.
[[nodiscard]] Scene mesh_scene(Mesh mesh, std::string name, const MeshView& view = {});

}  // namespace gloam::scene
