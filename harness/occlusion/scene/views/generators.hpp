// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "scene/mesh.hpp"
#include "scene/scene.hpp"

// Shapes of the views' generators, beside those of scene/mesh.hpp.
namespace gloam::scene::views {

inline constexpr double full_turn = 2.0 * std::numbers::pi;  // radians

// The mesh rotated about the vertical axis through the origin by `radians`, then moved.
[[nodiscard]] Mesh turned(Mesh mesh, double radians, const glm::dvec3& translation);

// The mesh seen from inside: triangles and normals reversed.
[[nodiscard]] Mesh inside_out(Mesh mesh);

// A straight rod between two different points, with smooth sides and flat ends. segments: around, at least 3.
[[nodiscard]] Mesh make_rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments);

// A square height field: y = height(x, z) over x and z from -half to half, with cells x cells cells, smooth
// normals.
[[nodiscard]] Mesh make_height_field(double half, int cells,
                                     const std::function<double(double x, double z)>& height);

// Smooth noise in [-1, 1] with the features of size 1, from random values at whole coordinates.
[[nodiscard]] double smooth_noise(double x, double z, std::uint64_t seed);

// Sum of `octaves` smooth noises, each of half the size and half the height of the one before.
[[nodiscard]] double fractal_noise(double x, double z, int octaves, std::uint64_t seed);

// How a camera moves by `step` in each frame: with its target, looking at the same target, or around its
// target by step.x degrees about the vertical axis.
enum class Way { gliding, passing, circling };

// Where a view's camera starts, and its way.
struct Stand {
    glm::dvec3 eye{0};
    glm::dvec3 target{0};
    double fovy_rad = 0.9;
    double view_height = 0.0;  // > 0: orthographic, world units from bottom to top
    double near = 0.05;
    double far = 200.0;
    Way way = Way::gliding;
    glm::dvec3 step{0};
};

// The camera's path, with reversed depth.
[[nodiscard]] std::function<Camera(int frame)> path_of(const Stand& stand);

// The scene with a camera path; `camera` is its frame 0.
[[nodiscard]] Scene filmed(Scene scene, std::function<Camera(int frame)> path);

// What the views show, made by code: bit-identical for the same parameters. World units are metres. The
// scenes have no name and no camera yet.

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
[[nodiscard]] Scene make_furnished(const Interior& interior);

// A hall from z = 2 along -z, with niches, two rows of pillars, beams, stairs with railings, and balls.
struct Hall {
    std::uint64_t seed = 1;
    double half_width = 4.0;
    double length = 14.0;
    double height = 4.5;
    double pillars = 2.2;  // x of the two rows
    double radius = 0.5;
};
[[nodiscard]] Scene make_hall(const Hall& hall);

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
[[nodiscard]] Scene make_foliage(const Foliage& foliage);

// Housings with fins and bolts, gears and pipes before a wall, perhaps a grating on the floor.
struct Machine {
    std::uint64_t seed = 1;
    int parts = 5;
    int pipes = 6;
    bool grating = false;
    double radius = 0.25;
};
[[nodiscard]] Scene make_machine(const Machine& machine);

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
[[nodiscard]] Scene make_terrain(const Terrain& terrain);
[[nodiscard]] double terrain_height(const Terrain& terrain, double x, double z);

// Rows of houses along streets, from z = 0 along -z.
struct Town {
    std::uint64_t seed = 1;
    int blocks = 8;  // in each direction
    double tallest = 18.0;
    double radius = 3.0;
};
[[nodiscard]] Scene make_town(const Town& town);

// How a mesh file is shown: copies in rows on a plane, each turned further.
struct Display {
    std::string file;        // in the folder of meshes
    glm::dvec3 up{0, 1, 0};  // of the file
    int copies = 1;          // in a row
    int rows = 1;
    double spacing = 1.2;  // in heights of the mesh
    double radius = 0.2;
};

// Throws std::runtime_error with the file's name and the package that has it if it cannot be read.
[[nodiscard]] Scene make_display(const std::filesystem::path& folder, const Display& display);

}  // namespace gloam::scene::views
