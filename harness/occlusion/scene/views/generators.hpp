// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/mesh.hpp"
#include "scene/scene.hpp"

// What the views and built-in scenes show, made by code: bit-identical for the same row of the table of views
// (view_table.cpp), whose members are in metres. What is made here has no name, radius and camera yet.
namespace gloam::scene::views {

using Row = nlohmann::json;

inline constexpr double full_turn = 2.0 * std::numbers::pi;  // radians

// A mesh to which shapes are added. cell: of the faces of boxes, metres.
struct Parts {
    double cell = 1.0;
    Mesh mesh{};

    void add(const Mesh& part) { append(mesh, part); }
    void box(const glm::dvec3& low, const glm::dvec3& high) { add(make_box(low, high, cell)); }
    void rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments) {
        add(make_rod(from, to, radius, segments));
    }
    void cylinder(const glm::dvec3& base_center, double radius, double height, int segments) {
        add(make_cylinder(base_center, radius, height, segments));
    }
    void sphere(const glm::dvec3& center, double radius, int rings, int segments) {
        add(make_sphere(center, radius, rings, segments));
    }
};

// A rotation about the vertical axis.
[[nodiscard]] inline glm::dmat3 upright_turn(double radians) {
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

// The row's random numbers.
[[nodiscard]] inline numeric::Random random_of(const Row& row) {
    return numeric::Random(row.at("seed").get<std::uint64_t>());
}

// A room with shelves of books along the back wall, furniture at random (fullness: share of the places that
// hold a piece), and a table with small things at the origin. Without `roofed` a floor and the back wall
// alone, as for a view from above.
[[nodiscard]] Scene make_interior(const Row& row);

// A hall from z = 2 along -z, with niches, two rows of pillars (at x = +-pillars), beams, stairs with
// railings, and balls.
[[nodiscard]] Scene make_hall(const Row& row);

// Trees, bushes and grass of flat leaves on a plane, around the origin. half_side: of the square that is
// planted. leaves: of a bush; a tree has as many.
[[nodiscard]] Scene make_foliage(const Row& row);

// Housings with fins and bolts, gears and pipes before a wall, perhaps a grating on the floor.
[[nodiscard]] Scene make_machine(const Row& row);

// Hills or ridges with stones: half_side: of their square. size: of the largest hills.
[[nodiscard]] Scene make_terrain(const Row& row);
[[nodiscard]] std::function<double(double x, double z)> height_of(const Row& terrain);

// Rows of houses along streets, from z = 0 along -z.
[[nodiscard]] Scene make_town(const Row& row);

// The built-in scenes.
[[nodiscard]] Scene make_columns(const Row& row);
[[nodiscard]] Scene make_corner(const Row& row);
[[nodiscard]] Scene make_far(const Row& row);
[[nodiscard]] Scene make_grass(const Row& row);
[[nodiscard]] Scene make_knot(const Row& row);
[[nodiscard]] Scene make_moving(const Row& row);
[[nodiscard]] Scene make_relief(const Row& row);
[[nodiscard]] Scene make_room(const Row& row);
[[nodiscard]] Scene make_sky(const Row& row);

}  // namespace gloam::scene::views
