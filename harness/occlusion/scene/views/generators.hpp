// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <numbers>
#include <string>

#include "scene/mesh.hpp"
#include "scene/scene.hpp"

// What the views and built-in scenes show, made by code: bit-identical for the same parameters. World units
// are metres. What is made here has no name and no camera yet.
namespace gloam::scene::views {

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

// A room with shelves of books along the back wall, furniture at random, and a table with small things at the
// origin.
struct Interior {
    std::uint64_t seed = 1;
    double half_width = 2.5;
    double half_depth = 2.5;
    double fullness = 0.6;  // share of the places that hold a piece
    bool roofed = true;     // false: a floor and the back wall alone, as for a view from above
    double radius = 0.3;    // Scene::ao_radius
};
[[nodiscard]] Scene made(const Interior& interior);

// A hall from z = 2 along -z, with niches, two rows of pillars, beams, stairs with railings, and balls.
struct Hall {
    std::uint64_t seed = 1;
    double half_width = 4.0;
    double length = 14.0;
    double height = 4.5;
    double pillars = 2.2;  // x of the two rows
    double radius = 0.5;
};
[[nodiscard]] Scene made(const Hall& hall);

// Trees, bushes and grass of flat leaves on a plane, around the origin.
struct Foliage {
    std::uint64_t seed = 1;
    double half = 3.0;  // of the side of the square that is planted
    int trees = 0;
    double trunk = 1.6;  // height
    int bushes = 0;
    int leaves = 400;  // of a bush; a tree has as many
    double leaf = 0.12;
    int blades = 0;
    double blade = 0.2;
    double radius = 0.2;
};
[[nodiscard]] Scene made(const Foliage& foliage);

// Housings with fins and bolts, gears and pipes before a wall, perhaps a grating on the floor.
struct Machine {
    std::uint64_t seed = 1;
    int parts = 5;
    int pipes = 6;
    bool grating = false;
    double radius = 0.25;
};
[[nodiscard]] Scene made(const Machine& machine);

// Hills or ridges with stones.
struct Terrain {
    std::uint64_t seed = 1;
    double half = 40.0;  // of the side of the square
    double size = 12.0;  // of the largest hills
    double relief = 3.0;
    bool ridged = false;
    int stones = 0;
    double stone = 0.6;  // radius
    double radius = 1.5;
};
[[nodiscard]] Scene made(const Terrain& terrain);
[[nodiscard]] double height_at(const Terrain& terrain, double x, double z);

// Rows of houses along streets, from z = 0 along -z.
struct Town {
    std::uint64_t seed = 1;
    int blocks = 8;  // in each direction
    double tallest = 18.0;
    double radius = 3.0;
};
[[nodiscard]] Scene made(const Town& town);

// How a mesh file is shown: copies in rows on a plane, each turned further.
struct Display {
    std::string file;        // in the folder of meshes
    glm::dvec3 up{0, 1, 0};  // of the file
    int copies = 1;          // in a row
    int rows = 1;
    double spacing = 1.2;  // in heights of the mesh
    double radius = 0.2;
};
// The built-in scenes.
constexpr glm::dvec3 far_place{98304.0, 512.0, -81920.0};  // of make_far(): floats are 1/128 apart there
constexpr double relief_face = -6.7;                       // of make_relief(), x of the wall
[[nodiscard]] Scene make_columns();
[[nodiscard]] Scene make_corner();
[[nodiscard]] Scene make_far();
[[nodiscard]] Scene make_grass();
[[nodiscard]] Scene make_knot();
[[nodiscard]] Scene make_moving();
[[nodiscard]] Scene make_relief();
[[nodiscard]] Scene make_room();
[[nodiscard]] Scene make_sky();

// How a camera moves by `step` in each frame: with its target, looking at the same target, or around its
// target by step.x degrees about the vertical axis. Or it sways: eye and target by step and aim, times the
// sine of rate radians a frame. Or it swings around the vertical axis and back, or stands still.
enum class Way { gliding, passing, circling, swaying, swinging, still };

struct Lens {
    double fovy_rad = 0.9;
    double near = 0.05;
    double far = 200.0;
    double view_height = 0.0;  // > 0: orthographic, world units from bottom to top
};

// Where a view's camera starts, and its way.
struct Stand {
    glm::dvec3 eye{0};
    glm::dvec3 target{0};
    Way way = Way::gliding;
    glm::dvec3 step{0};
    Lens lens{};
    glm::dvec3 rate{0};
    glm::dvec3 aim{0};
};

}  // namespace gloam::scene::views
