// SPDX-License-Identifier: MIT
#include "scene/views/generators.hpp"

#include <stdexcept>

namespace gloam::scene::views {
namespace {

using Path = std::filesystem::path;
using Table = std::vector<ViewMaker>;

void add_interiors(Table& table) {
    table.push_back(
        {"study", "interior", ViewHalf::tuning, "a room with books, chairs and a table", [](const Path&) {
             return filmed(
                 make_furnished({.seed = 11}),
                 gliding({.eye = {1.6, 1.6, 2.2}, .target = {-0.5, 0.7, -1.0}}, {-0.012, 0, -0.008}));
         }});
    table.push_back(
        {"workshop", "interior", ViewHalf::unseen, "a large room, crowded, seen from a corner",
         [](const Path&) {
             return filmed(
                 make_furnished(
                     {.seed = 12, .half_width = 4.0, .half_depth = 3.5, .fullness = 0.85, .radius = 0.5}),
                 passing({.eye = {-3.6, 1.9, 3.1}, .target = {0.5, 0.5, -1.0}}, {0.02, 0, 0}));
         }});
    table.push_back(
        {"tabletop", "interior", ViewHalf::tuning, "small things on a table, close up", [](const Path&) {
             return filmed(make_furnished({.seed = 13, .radius = 0.12}),
                           circling({.eye = {0.7, 1.15, 0.8}, .target = {0, 0.76, 0}, .near = 0.02}, 0.5));
         }});
    table.push_back(
        {"plan", "interior", ViewHalf::unseen, "furniture from above, orthographic", [](const Path&) {
             return filmed(
                 make_furnished(
                     {.seed = 14, .half_width = 3.5, .half_depth = 3.0, .roofed = false, .radius = 0.4}),
                 gliding({.eye = {2.0, 8.0, 5.0}, .target = {0, 0, 0}, .view_height = 5.0, .far = 40.0},
                         {0.01, 0, 0.004}));
         }});
}

void add_halls(Table& table) {
    table.push_back(
        {"nave", "hall", ViewHalf::tuning, "two rows of pillars, along the middle", [](const Path&) {
             return filmed(make_hall({.seed = 21}),
                           gliding({.eye = {0.2, 1.7, 1.5}, .target = {0, 1.6, -10}}, {0, 0, -0.03}));
         }});
    table.push_back(
        {"aisle", "hall", ViewHalf::unseen, "behind the pillars, looking across", [](const Path&) {
             return filmed(make_hall({.seed = 22, .half_width = 5.0, .radius = 0.7}),
                           gliding({.eye = {-3.6, 1.5, 1.0}, .target = {2.0, 1.0, -7.0}}, {0.015, 0, -0.02}));
         }});
    table.push_back(
        {"crypt", "hall", ViewHalf::tuning, "low, with a wide angle", [](const Path&) {
             return filmed(
                 make_hall({.seed = 23, .half_width = 3.0, .height = 2.8, .pillars = 1.5, .radius = 0.4}),
                 passing({.eye = {1.0, 1.0, 0.8}, .target = {-0.4, 1.0, -5.0}, .fovy_rad = 1.25},
                         {-0.012, 0, 0}));
         }});
    table.push_back({"stairs", "hall", ViewHalf::unseen, "stairs with railings, close up", [](const Path&) {
                         return filmed(make_hall({.seed = 24, .length = 9.0, .radius = 0.35}),
                                       passing({.eye = {1.6, 1.5, -2.6}, .target = {-0.2, 0.8, -5.6}},
                                               {-0.015, 0.004, 0}));
                     }});
}

void add_foliage(Table& table) {
    table.push_back({"meadow", "foliage", ViewHalf::tuning, "grass and bushes", [](const Path&) {
                         return filmed(make_foliage({.seed = 31, .bushes = 8, .leaves = 300, .blades = 4000}),
                                       gliding({.eye = {0, 0.9, 3.2}, .target = {0, 0.2, 0}}, {0.01, 0, 0}));
                     }});
    table.push_back({"grove", "foliage", ViewHalf::unseen, "trees with leaves in crowns", [](const Path&) {
                         return filmed(
                             make_foliage({.seed = 32,
                                           .half = 5.0,
                                           .trees = 12,
                                           .leaves = 1200,
                                           .leaf = 0.16,
                                           .blades = 1500,
                                           .radius = 0.4}),
                             gliding({.eye = {0, 1.5, 6.5}, .target = {0, 1.2, 0}}, {0.02, 0, -0.01}));
                     }});
    table.push_back(
        {"hedge", "foliage", ViewHalf::tuning, "bushes close up, leaf by leaf", [](const Path&) {
             return filmed(
                 make_foliage({.seed = 33, .half = 0.9, .bushes = 9, .leaves = 350, .radius = 0.15}),
                 circling({.eye = {0.3, 0.7, 1.9}, .target = {0, 0.3, 0}}, 0.4));
         }});
    table.push_back(
        {"lawn", "foliage", ViewHalf::unseen, "grass from above, orthographic", [](const Path&) {
             return filmed(
                 make_foliage({.seed = 34,
                               .half = 2.5,
                               .bushes = 3,
                               .leaves = 300,
                               .blades = 7000,
                               .blade = 0.15,
                               .radius = 0.15}),
                 gliding({.eye = {0.5, 5.0, 4.0}, .target = {0, 0, 0}, .view_height = 2.6, .far = 40.0},
                         {0.006, 0, 0}));
         }});
}

void add_machines(Table& table) {
    table.push_back({"engine", "machine", ViewHalf::tuning, "housings, gears and pipes", [](const Path&) {
                         return filmed(
                             make_machine({.seed = 41}),
                             passing({.eye = {0.8, 1.5, 2.6}, .target = {0, 0.8, -1.0}}, {-0.015, 0, 0}));
                     }});
    table.push_back({"pipes", "machine", ViewHalf::unseen, "pipes before a wall", [](const Path&) {
                         return filmed(
                             make_machine({.seed = 42, .parts = 3, .pipes = 14, .radius = 0.3}),
                             gliding({.eye = {-0.8, 1.4, 2.0}, .target = {0.2, 1.1, -1.5}}, {0.012, 0, 0}));
                     }});
    table.push_back(
        {"grating", "machine", ViewHalf::tuning, "a grating over the floor", [](const Path&) {
             return filmed(make_machine({.seed = 43, .parts = 4, .pipes = 4, .grating = true, .radius = 0.3}),
                           gliding({.eye = {0.3, 1.3, 2.8}, .target = {0, 0.2, 0.0}}, {0.01, 0, -0.005}));
         }});
    table.push_back(
        {"panel", "machine", ViewHalf::unseen, "machines from the front, orthographic", [](const Path&) {
             return filmed(
                 make_machine({.seed = 44, .parts = 6, .pipes = 8, .radius = 0.25}),
                 gliding({.eye = {0.6, 2.0, 5.0}, .target = {0, 1.0, -1.0}, .view_height = 2.6, .far = 40.0},
                         {-0.008, 0, 0}));
         }});
}

// Above the ground of a terrain.
glm::dvec3 above(const Terrain& terrain, double x, double z, double height) {
    return {x, terrain_height(terrain, x, z) + height, z};
}

Scene walked(const Terrain& terrain, const glm::dvec3& from, const glm::dvec3& to, double height,
             const glm::dvec3& step) {
    return filmed(make_terrain(terrain), gliding({.eye = above(terrain, from.x, from.z, height),
                                                  .target = above(terrain, to.x, to.z, 0.0),
                                                  .far = 400.0},
                                                 step));
}

void add_terrain(Table& table) {
    table.push_back({"hills", "terrain", ViewHalf::tuning, "hills with stones", [](const Path&) {
                         return walked({.seed = 51, .stones = 80}, {0, 0, 18}, {0, 0, 0}, 4.0, {0.05, 0, 0});
                     }});
    table.push_back(
        {"canyon", "terrain", ViewHalf::unseen, "ridges, far away", [](const Path&) {
             return walked(
                 {.seed = 52, .half = 80.0, .size = 25.0, .relief = 8.0, .ridged = true, .radius = 5.0},
                 {0, 0, 55}, {0, 0, 0}, 14.0, {0.15, 0, 0});
         }});
    table.push_back(
        {"stones", "terrain", ViewHalf::tuning, "stones on the ground, close up", [](const Path&) {
             return walked({.seed = 53,
                            .half = 8.0,
                            .size = 5.0,
                            .relief = 0.5,
                            .stones = 220,
                            .stone = 0.3,
                            .radius = 0.35},
                           {0, 0, 4}, {0, 0, 0.5}, 1.6, {0.015, 0, 0});
         }});
    table.push_back(
        {"town", "terrain", ViewHalf::unseen, "houses along streets, from above", [](const Path&) {
             return filmed(make_town({.seed = 54}),
                           gliding({.eye = {10, 40, 45}, .target = {0, 5, -40}, .near = 1.0, .far = 800.0},
                                   {0.3, 0, -0.1}));
         }});
}

void add_meshes(Table& table) {
    table.push_back({"bunny", "mesh", ViewHalf::tuning, "the bunny of glmark2-data", [](const Path& meshes) {
                         return filmed(make_display(meshes, {.file = "bunny.obj"}),
                                       circling({.eye = {0.4, 0.9, 1.9}, .target = {0, 0.45, 0}}, 0.7));
                     }});
    table.push_back(
        {"horse", "mesh", ViewHalf::unseen, "three horses of glmark2-data", [](const Path& meshes) {
             return filmed(make_display(meshes, {.file = "horse.3ds", .copies = 3, .spacing = 1.4}),
                           gliding({.eye = {0.5, 1.3, 3.6}, .target = {0, 0.4, 0}}, {0.012, 0, 0}));
         }});
    table.push_back(
        {"cats", "mesh", ViewHalf::tuning, "rows of cats of glmark2-data", [](const Path& meshes) {
             return filmed(
                 make_display(meshes,
                              {.file = "cat.3ds", .up = {0, 0, -1}, .copies = 4, .rows = 3, .spacing = 1.6}),
                 gliding({.eye = {-0.5, 1.7, 3.0}, .target = {0, 0.2, -0.8}}, {0.01, 0, 0}));
         }});
    table.push_back(
        {"asteroids", "mesh", ViewHalf::unseen, "asteroids of glmark2-data that touch",
         [](const Path& meshes) {
             return filmed(
                 make_display(meshes, {.file = "asteroid-high.3ds", .copies = 4, .rows = 3, .spacing = 1.05}),
                 passing({.eye = {1.2, 1.6, 2.6}, .target = {0, 0.3, -0.8}}, {-0.015, 0, 0}));
         }});
}

// Built-in scenes whose cameras move, as they are.
void add_scenes(Table& table) {
    const std::pair<const char*, ViewHalf> scenes[]{{"columns", ViewHalf::tuning}, {"far", ViewHalf::unseen},
                                                    {"grass", ViewHalf::tuning},   {"knot", ViewHalf::unseen},
                                                    {"moving", ViewHalf::tuning},  {"room", ViewHalf::unseen},
                                                    {"sky", ViewHalf::tuning}};
    for (const auto& [name, half] : scenes)
        table.push_back({name, "scene", half, "the built-in scene",
                         [name = std::string(name)](const Path&) { return make_scene(name); }});
}

}  // namespace

const std::vector<ViewMaker>& view_table() {
    static const std::vector<ViewMaker> all = [] {
        Table table;
        add_interiors(table);
        add_halls(table);
        add_foliage(table);
        add_machines(table);
        add_terrain(table);
        add_meshes(table);
        add_scenes(table);
        return table;
    }();
    return all;
}

}  // namespace gloam::scene::views

namespace gloam::scene {

const std::vector<ViewInfo>& all_views() {
    static const std::vector<ViewInfo> infos = [] {
        std::vector<ViewInfo> all;
        for (const views::ViewMaker& view : views::view_table())
            all.push_back({view.name, view.kind, view.description, view.half});
        return all;
    }();
    return infos;
}

std::string_view name_of(ViewHalf half) {
    return half == ViewHalf::tuning ? "tuning" : "unseen";
}

std::filesystem::path installed_meshes() {
    return "/usr/share/glmark2/models";
}

Scene make_view(std::string_view name, const std::filesystem::path& meshes) {
    std::string names;
    for (const views::ViewMaker& view : views::view_table()) {
        if (view.name != name) {
            names += (names.empty() ? "" : ", ") + view.name;
            continue;
        }
        Scene scene = view.make(meshes);
        scene.name = view.name;
        return scene;
    }
    throw std::invalid_argument("unknown view \"" + std::string(name) + "\": expected " + names);
}

}  // namespace gloam::scene
