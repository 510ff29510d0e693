// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gloam::scene {

Bounds bounds_of(const Mesh& mesh) {
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
    for (const std::uint32_t index : other.indices) mesh.indices.push_back(first + index);
}

Mesh placed(Mesh mesh, const glm::dmat3& rotation, const glm::dvec3& translation, double scale) {
    for (glm::vec3& p : mesh.positions) p = rotation * glm::dvec3(p) * scale + translation;
    for (glm::vec3& n : mesh.normals) n = rotation * glm::dvec3(n);
    return mesh;
}

Mesh inside_out(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (glm::vec3& normal : mesh.normals) normal = -normal;
    return mesh;
}

Mesh make_grid(int columns, int rows, const std::function<Vertex(int, int)>& at) {
    Mesh mesh;
    for (int y = 0; y <= rows; ++y) {
        for (int x = 0; x <= columns; ++x) {
            const Vertex vertex = at(x, y);
            mesh.positions.emplace_back(vertex.position);
            mesh.normals.emplace_back(vertex.normal);
        }
    }
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(rows); ++y) {
        for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(columns); ++x) {
            const std::uint32_t corner = y * stride + x;
            mesh.indices.insert(mesh.indices.end(), {corner, corner + 1, corner + stride + 1, corner,
                                                     corner + stride + 1, corner + stride});
        }
    }
    return mesh;
}

Mesh make_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double cell) {
    const glm::dvec3 area = glm::cross(u, v);
    const int columns = std::max(1, static_cast<int>(std::ceil(glm::length(u) / cell)));
    const int rows = std::max(1, static_cast<int>(std::ceil(glm::length(v) / cell)));
    return make_grid(columns, rows, [&](int x, int y) -> Vertex {
        return {corner + u * (static_cast<double>(x) / columns) + v * (static_cast<double>(y) / rows),
                glm::normalize(area)};
    });
}

Mesh make_box(const glm::dvec3& low, const glm::dvec3& high, double cell) {
    const glm::dvec3 x{high.x - low.x, 0, 0};
    const glm::dvec3 y{0, high.y - low.y, 0};
    const glm::dvec3 z{0, 0, high.z - low.z};
    Mesh box = make_parallelogram(low, y, x, cell);
    append(box, make_parallelogram(low, z, y, cell));
    append(box, make_parallelogram(low, x, z, cell));
    append(box, make_parallelogram(high, -x, -y, cell));
    append(box, make_parallelogram(high, -y, -z, cell));
    append(box, make_parallelogram(high, -z, -x, cell));
    return box;
}

Mesh make_cylinder(const glm::dvec3& base_center, double radius, double height, int segments) {
    return make_grid(segments, 1, [&](int x, int y) -> Vertex {
        const double angle = 2.0 * std::numbers::pi * x / segments;
        const glm::dvec3 out{std::sin(angle), 0.0, std::cos(angle)};
        return {base_center + radius * out + glm::dvec3(0.0, y * height, 0.0), out};
    });
}

Mesh make_sphere(const glm::dvec3& center, double radius, int rings) {
    return make_grid(2 * rings, rings, [&](int x, int y) -> Vertex {
        const double around = 2.0 * std::numbers::pi * x / (2 * rings);
        const double polar = std::numbers::pi * y / rings;
        const glm::dvec3 out{std::sin(around) * std::sin(polar), -std::cos(polar),
                             std::cos(around) * std::sin(polar)};
        return {center + radius * out, out};
    });
}

namespace {

// A disc around the axis, as a fan of triangles.
Mesh make_end(const glm::dvec3& center, const glm::dvec3& axis, const glm::dvec3& across, double radius,
              int segments) {
    const glm::dvec3 other = glm::cross(axis, across);
    Mesh mesh;
    mesh.positions.emplace_back(center);
    for (int i = 0; i < segments; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / segments;
        mesh.positions.emplace_back(center + radius * (std::cos(angle) * across + std::sin(angle) * other));
        const auto next = static_cast<std::uint32_t>(1 + (i + 1) % segments);
        mesh.indices.insert(mesh.indices.end(), {0, static_cast<std::uint32_t>(1 + i), next});
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(axis));
    return mesh;
}

}  // namespace

Mesh make_rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments) {
    const glm::dvec3 axis = glm::normalize(to - from);
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(axis, helper));
    Mesh rod = placed(make_cylinder({0, 0, 0}, radius, glm::distance(from, to), segments),
                      glm::dmat3(across, axis, glm::cross(across, axis)), from);
    append(rod, make_end(from, -axis, across, radius, segments));
    append(rod, make_end(to, axis, across, radius, segments));
    return rod;
}

}  // namespace gloam::scene
