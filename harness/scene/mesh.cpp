// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"

#include <stdexcept>

namespace gloam::scene {

Bounds bounds_of(const Mesh& mesh) {
    if (mesh.positions.empty()) throw std::invalid_argument("a mesh without positions has no bounds");
    Bounds bounds{mesh.positions.front(), mesh.positions.front()};
    for (const glm::vec3& position : mesh.positions) {
        bounds.low = glm::min(bounds.low, glm::dvec3(position));
        bounds.high = glm::max(bounds.high, glm::dvec3(position));
    }
    return bounds;
}

Mesh colored(Mesh mesh, const glm::vec3& color) {
    mesh.colors.assign(mesh.triangle_count(), color);
    return mesh;
}

void append(Mesh& mesh, const Mesh& other) {
    if (!mesh.colors.empty() || !other.colors.empty()) {
        mesh.colors.resize(mesh.triangle_count(), default_color);
        mesh.colors.insert(mesh.colors.end(), other.colors.begin(), other.colors.end());
        mesh.colors.resize(mesh.triangle_count() + other.triangle_count(), default_color);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.indices.reserve(mesh.indices.size() + other.indices.size());
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

Mesh placed(Mesh mesh, double scale, const glm::dvec3& translation) {
    for (glm::vec3& position : mesh.positions) position = glm::dvec3(position) * scale + translation;
    return mesh;
}

}  // namespace gloam::scene
