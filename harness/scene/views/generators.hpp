// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "scene/scene.hpp"

// What the views show, made by code: bit-identical for the same parameters. World units are metres. The
// scenes have no name and no camera yet.
namespace gloam::scene::views {

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

}  // namespace gloam::scene::views
