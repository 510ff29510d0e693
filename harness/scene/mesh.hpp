// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace gloam::scene {

// What has no colour of its own: a light grey.
constexpr glm::vec3 default_color(0.7F);

// Triangles in world units: three indices each, one normal (unit length) for each position.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec3> colors{};  // diffuse albedo of each triangle, linear, [0, 1]; empty: default_color

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

// Smallest box along the axes that holds all positions.
struct Bounds {
    glm::dvec3 low{0};
    glm::dvec3 high{0};
};

// Throws std::invalid_argument for a mesh without positions.
[[nodiscard]] Bounds bounds_of(const Mesh& mesh);

// The mesh in one colour.
[[nodiscard]] Mesh colored(Mesh mesh, const glm::vec3& color);

// Adds the triangles of `other`, with their colours.
void append(Mesh& mesh, const Mesh& other);

// The mesh scaled about the origin, then moved.
[[nodiscard]] Mesh placed(Mesh mesh, double scale, const glm::dvec3& translation);

// Faces that meet at a larger angle than this, in degrees, have an edge between them, not a smooth surface.
inline constexpr float crease_degrees = 45.0F;

// Reads any file that assimp reads, all its meshes in one. A mesh without normals gets those of its faces,
// averaged where the angle between faces is at most crease_degrees. Lines and points are left out. Throws
// std::runtime_error that names the file: unreadable, without a triangle, with a vertex that is NaN or
// infinite, or a face without corners, with too many, or of vertices that are not there. For files that one
// trusts: a malformed one can still crash assimp, or keep it busy. Others: mesh_reader.hpp.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file);

}  // namespace gloam::scene
