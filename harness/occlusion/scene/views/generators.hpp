// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>

#include "numeric/random.hpp"
#include "scene/mesh.hpp"
#include "scene/scene.hpp"

// What the views and built-in scenes show: bit-identical for the same row of the table of views (rows.cpp),
// whose members are in metres. What is made here has no name, radius and camera yet.
namespace gloam::scene::views {

using Row = nlohmann::json;

// All views and built-in scenes.
[[nodiscard]] const Row& rows();

inline constexpr double full_turn = 2.0 * std::numbers::pi;  // radians

// Three numbers of a list, from one of its places on.
[[nodiscard]] inline glm::dvec3 vector_of(const Row& list, std::size_t first = 0) {
    return {list.at(first).get<double>(), list.at(first + 1).get<double>(), list.at(first + 2).get<double>()};
}

// A mesh to which shapes are added. cell: of the faces of boxes, metres.
struct Parts {
    double cell = 1.0;
    Mesh mesh{};

    void add(const Mesh& part) { append(mesh, part); }
    void box(const glm::dvec3& low, const glm::dvec3& high) { add(make_box(low, high, cell)); }
};

// Books in a row along x. least, most: how thick, tall and deep they are. gap: between two of them. share: of
// the places that hold one.
struct Books {
    glm::dvec3 least;
    glm::dvec3 most;
    double gap;
    double share;
};
void add_books(Parts& parts, numeric::Random& random, const Books& books, const glm::dvec3& first,
               double end);

// A rotation about the vertical axis.
[[nodiscard]] inline glm::dmat3 upright_turn(double radians) {
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
}

// The row's random numbers.
[[nodiscard]] inline numeric::Random random_of(const Row& row) {
    return numeric::Random(row.value("seed", std::uint64_t{0}));
}

// The shapes that a row lists: ["box", low, high], ["inside", low, high] (a box seen from inside),
// ["plane", corner, u, v, perhaps a colour] (make_parallelogram()), ["sphere", center, radius, rings],
// ["cylinder", base center, radius, height, segments], ["knot", scale], ["books", first corner, end along x],
// where a point is three numbers. ["each", count, step, shapes...] repeats shapes, each time moved by the
// step, and ["ring", count, distance, shapes...] around their place, in the plane of y and z. ["all of",
// name] has the shapes of another row. ["cell", size] changes the cells of the boxes and planes behind it;
// they have 1 m before it.
[[nodiscard]] Mesh shapes_of(const Row& row);

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

// A meadow of blades, and of broad leaves around one foot.
[[nodiscard]] Scene make_grass(const Row& row);

// Housings with fins and bolts, gears and pipes before a wall.
[[nodiscard]] Scene make_machine(const Row& row);

// Hills or ridges with stones: half_side: of their square. size: of the largest hills.
[[nodiscard]] Scene make_terrain(const Row& row);
[[nodiscard]] std::function<double(double x, double z)> height_of(const Row& terrain);

// Rows of houses along streets, from z = 0 along -z.
[[nodiscard]] Scene make_town(const Row& row);

}  // namespace gloam::scene::views
