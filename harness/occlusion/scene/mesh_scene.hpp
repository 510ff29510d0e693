// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/mesh.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// Reads any file format that assimp supports; all meshes of the file become one. A mesh without normals gets
// those of its faces, averaged where the angle between faces is at most 45 degrees. Lines and points are
// ignored. Throws std::runtime_error with the file's name if it is unreadable or has no triangle, if a vertex
// is NaN or infinite, or if a face is invalid. A face is invalid without corners, with too many corners, or
// with vertices that do not exist. A malformed file can still crash assimp, or make it run for a long time:
// it runs in another process (base::run_apart), whose memory and time are limited by the size of the file.
[[nodiscard]] Mesh read_mesh(const std::filesystem::path& file);

// Placement and view of a mesh. Positions are in the units of its file; the middle of its base is the origin,
// up is +y, and the front faces +z.
struct MeshView {
    glm::dvec3 up{0, 1, 0};               // up direction of the file: one of its axes or their opposites
    bool ground = true;                   // a plane under the mesh
    double azimuth_deg = 20.0;            // of the eye around the mesh, from the front towards +x
    double elevation_deg = 22.0;          // of the eye above the horizon, -89 to 89
    std::optional<glm::dvec3> eye{};      // instead of azimuth and elevation
    std::optional<glm::dvec3> look_at{};  // default: the middle of the mesh
    double aspect = 1.0;                  // of the image, width over height, > 0
    double fovy_deg = 40.0;               // vertical angle of the view, 1 to 170
};

// "x", "y", "z", "-x", "-y" or "-z" as a direction; nullopt for other text.
[[nodiscard]] std::optional<glm::dvec3> axis_named(std::string_view name);

// A mesh with extent, turned so that `up` becomes +y and moved so that the middle of its base is the origin.
// With `height`, scaled to it; a flat mesh has nearly no height, and its longest side becomes `height`.
[[nodiscard]] Mesh standing(Mesh mesh, const glm::dvec3& up, std::optional<double> height = {});

// A scene of a mesh, standing on the plane y = 0 in the units of its file; the occlusion's radius is a fifth
// of the mesh's height (of its longest side if it is flat). Without `eye`, the camera is as near as possible
// so that the whole mesh is visible with a margin. Throws std::invalid_argument for a mesh without extent, an
// elevation or an angle of view out of range, and an eye at the point it looks at.
[[nodiscard]] Scene mesh_scene(Mesh mesh, std::string name, const MeshView& view = {});

}  // namespace gloam::scene
