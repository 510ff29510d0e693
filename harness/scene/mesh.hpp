// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <vector>

namespace gloam::scene {

// Triangles in world units: three indices each, one normal (unit length) for each position.
struct Mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

// Reads any file that assimp reads, all its meshes in one, with smooth normals where it has none. Throws
// std::runtime_error that names the file: unreadable, without a triangle, or with a vertex that is NaN or infinite.
[[nodiscard]] Mesh load_mesh(const std::filesystem::path& file);

}  // namespace gloam::scene
