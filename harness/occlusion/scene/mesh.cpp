// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
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

namespace {

struct Vertex {
    glm::dvec3 position;
    glm::dvec3 normal;
};

// The image of a grid of columns x rows cells. `at`: maps the cell corners (0..columns, 0..rows). Triangles
// wind counter-clockwise seen from the side of d/dx x d/dy.
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

void require(bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(message);
}

double turn(int part, int whole) {
    return 2.0 * std::numbers::pi * part / whole;
}

}  // namespace

Mesh make_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double cell) {
    const glm::dvec3 area = glm::cross(u, v);
    require(glm::length(area) > 0.0, "parallelogram: its edges are parallel");
    require(cell > 0.0, "parallelogram: expected a cell size > 0");
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
    require(radius > 0.0 && height > 0.0 && segments >= 3,
            "cylinder: expected radius and height > 0, segments >= 3");
    return make_grid(segments, 1, [&](int x, int y) -> Vertex {
        const double angle = turn(x, segments);
        const glm::dvec3 out{std::sin(angle), 0.0, std::cos(angle)};
        return {base_center + radius * out + glm::dvec3(0.0, y * height, 0.0), out};
    });
}

Mesh make_sphere(const glm::dvec3& center, double radius, int rings, int segments) {
    require(radius > 0.0 && rings >= 2 && segments >= 3,
            "sphere: expected radius > 0, rings >= 2, segments >= 3");
    return make_grid(segments, rings, [&](int x, int y) -> Vertex {
        const double around = turn(x, segments);
        const double polar = std::numbers::pi * y / rings;
        const glm::dvec3 out{std::sin(around) * std::sin(polar), -std::cos(polar),
                             std::cos(around) * std::sin(polar)};
        return {center + radius * out, out};
    });
}

Mesh make_tube(const std::function<glm::dvec3(double)>& closed_curve, double radius, int along, int around) {
    require(radius > 0.0 && along >= 3 && around >= 3, "tube: expected radius > 0 and segments >= 3");
    return make_grid(around, along, [&](int x, int y) -> Vertex {
        const double t = static_cast<double>(y % along) / along;
        constexpr double step = 1e-4;
        const glm::dvec3 forward = glm::normalize(closed_curve(t + step) - closed_curve(t - step));
        const glm::dvec3 side = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
        const double angle = turn(x % around, around);
        const glm::dvec3 out = std::cos(angle) * side + std::sin(angle) * glm::cross(forward, side);
        return {closed_curve(t) + radius * out, out};
    });
}

Mesh make_strip(const std::vector<glm::dvec3>& left, const std::vector<glm::dvec3>& right) {
    require(left.size() == right.size() && left.size() >= 2, "strip: expected two or more pairs of points");
    const int rows = static_cast<int>(left.size()) - 1;
    return make_grid(1, rows, [&](int x, int y) -> Vertex {
        const auto row = static_cast<std::size_t>(y);
        const std::size_t before = row == 0 ? 0 : row - 1;
        const std::size_t after = std::min(row + 1, left.size() - 1);
        const glm::dvec3 way = left[after] + right[after] - left[before] - right[before];
        // The tip can be a point; then the width of the previous row gives the direction.
        glm::dvec3 across = right[row] - left[row];
        if (!(glm::length(across) > 0.0)) across = right[before] - left[before];
        return {x == 0 ? left[row] : right[row], glm::normalize(glm::cross(across, way))};
    });
}

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
