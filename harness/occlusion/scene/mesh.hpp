// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
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

// The bounds of a mesh, which has a position at least.
[[nodiscard]] Bounds bounds_of(const Mesh& mesh);

// The mesh with one colour.
[[nodiscard]] Mesh colored(Mesh mesh, const glm::vec3& color);

// Appends the triangles of `other`, with their colours.
void append(Mesh& mesh, const Mesh& other);

// The mesh rotated and scaled about the origin, then moved.
[[nodiscard]] Mesh placed(Mesh mesh, const glm::dmat3& rotation, const glm::dvec3& translation,
                          double scale = 1.0);

// The mesh seen from inside: triangles and normals reversed.
[[nodiscard]] Mesh inside_out(Mesh mesh);

// A parallelogram from `corner` along `u` and `v`, cut into cells of at most `cell` world units a side (large
// triangles cost depth precision). Its normal is u x v.
[[nodiscard]] Mesh make_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                                      double cell);

// An axis-aligned box, its faces divided into cells, normals outwards.
[[nodiscard]] Mesh make_box(const glm::dvec3& low, const glm::dvec3& high, double cell);

// The side of an upright cylinder (along y) without its ends, smooth normals outwards. segments: around, at
// least 3.
[[nodiscard]] Mesh make_cylinder(const glm::dvec3& base_center, double radius, double height, int segments);

// A sphere with smooth normals outwards. rings: of latitude, at least 2; twice as many segments are around.
[[nodiscard]] Mesh make_sphere(const glm::dvec3& center, double radius, int rings);

// A straight rod between two different points, with smooth sides and flat ends.
[[nodiscard]] Mesh make_rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments);

// The image of a grid of columns x rows cells, from the vertices at its (columns + 1) x (rows + 1) corners.
// Triangles wind counter-clockwise seen from the side of d/dx x d/dy.
struct Vertex {
    glm::dvec3 position;
    glm::dvec3 normal;
};
[[nodiscard]] Mesh make_grid(int columns, int rows, const std::function<Vertex(int column, int row)>& at);

// Object to world: a rotation by an angle in radians around an axis through the object's origin, then a
// translation.
[[nodiscard]] inline glm::dmat4 rigid_motion(const glm::dvec3& position, double angle = 0.0,
                                             const glm::dvec3& axis = {0, 1, 0}) {
    return glm::rotate(glm::translate(glm::dmat4(1.0), position), angle, axis);
}

}  // namespace gloam::scene
