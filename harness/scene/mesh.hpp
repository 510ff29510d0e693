// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace gloam::scene {

// The colour of a mesh without colours: a light grey.
constexpr glm::vec3 default_color(0.7F);

// Triangles in world units: three indices each, one normal (unit length) for each position.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> colors{};  // diffuse albedo of each triangle, linear, [0, 1]; empty: default_color

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

// The smallest axis-aligned box that contains all positions.
struct Bounds {
    glm::dvec3 low{0};
    glm::dvec3 high{0};
};

// The bounds of a mesh. Throws std::invalid_argument for a mesh without positions.
[[nodiscard]] Bounds bounds_of(const Mesh& mesh);

// The mesh with one colour.
[[nodiscard]] Mesh colored(Mesh mesh, const glm::vec3& color);

// Appends the triangles of `other`, with their colours.
void append(Mesh& mesh, const Mesh& other);

// The mesh scaled about the origin, then moved.
[[nodiscard]] Mesh placed(Mesh mesh, double scale, const glm::dvec3& translation);

// If faces meet at a larger angle than this, in degrees, there is an edge between them; otherwise the surface
// is smooth.
inline constexpr float crease_degrees = 45.0F;

// Reads any file format that assimp supports; all meshes of the file become one. A mesh without normals gets
// those of its faces, averaged where the angle between faces is at most crease_degrees. Lines and points are
// ignored. Throws std::runtime_error with the file's name if it is unreadable or has no triangle, if a vertex
// is NaN or infinite, or if a face is invalid. A face is invalid without corners, with too many corners, or
// with vertices that do not exist.
// Only for trusted files: a malformed file can still crash assimp, or make it run for a long time. For other
// files see mesh_reader.hpp.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file);

}  // namespace gloam::scene
