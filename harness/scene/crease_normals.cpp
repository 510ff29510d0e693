// SPDX-License-Identifier: MIT
#include "scene/crease_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gloam::scene {
namespace {

using Key = std::array<float, 6>;  // a vertex: position, normal

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0F && std::isfinite(length) ? v / length : glm::vec3(0);
}

// The unit normal of each triangle, 0 for a triangle without area.
std::vector<glm::vec3> face_normals(const Mesh& mesh) {
    std::vector<glm::vec3> normals;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::vec3 origin = mesh.positions[mesh.indices[i]];
        normals.push_back(unit_or_zero(glm::cross(mesh.positions[mesh.indices[i + 1]] - origin,
                                                  mesh.positions[mesh.indices[i + 2]] - origin)));
    }
    return normals;
}

// The angle of a triangle at a corner (an index of mesh.indices), in radians.
float angle_at(const Mesh& mesh, std::size_t corner) {
    const std::size_t first = corner - corner % 3;
    const auto position = [&](std::size_t k) {
        return mesh.positions[mesh.indices[first + (corner + k) % 3]];
    };
    const glm::vec3 a = unit_or_zero(position(1) - position(0));
    const glm::vec3 b = unit_or_zero(position(2) - position(0));
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The corners at each position, over all vertices there.
std::map<std::array<float, 3>, std::vector<std::size_t>> corners_by_position(const Mesh& mesh) {
    std::map<std::array<float, 3>, std::vector<std::size_t>> corners;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const glm::vec3& p = mesh.positions[mesh.indices[i]];
        corners[{p.x, p.y, p.z}].push_back(i);
    }
    return corners;
}

}  // namespace

Mesh with_crease_normals(const Mesh& mesh, float degrees) {
    const std::vector<glm::vec3> normals = face_normals(mesh);
    const auto corners = corners_by_position(mesh);
    const float least_cosine = std::cos(glm::radians(degrees));
    Mesh result;
    std::map<Key, std::uint32_t> vertices;
    for (std::size_t i = 0; i < normals.size() * 3; ++i) {
        const glm::vec3& p = mesh.positions[mesh.indices[i]];
        glm::vec3 sum(0);
        for (const std::size_t corner : corners.at({p.x, p.y, p.z})) {
            const glm::vec3& normal = normals[corner / 3];
            if (glm::dot(normals[i / 3], normal) >= least_cosine) sum += angle_at(mesh, corner) * normal;
        }
        const glm::vec3 n = unit_or_zero(sum);
        const auto next = static_cast<std::uint32_t>(result.positions.size());
        const auto [vertex, added] = vertices.try_emplace({p.x, p.y, p.z, n.x, n.y, n.z}, next);
        if (added) {
            result.positions.push_back(p);
            result.normals.push_back(n);
        }
        result.indices.push_back(vertex->second);
    }
    return result;
}

}  // namespace gloam::scene
