// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <variant>

#include "scene/mesh_scene.hpp"
#include "scene/views/generators.hpp"

namespace gloam::scene {
namespace {

using namespace views;
using enum ViewHalf;
using enum Way;

// Above a terrain the heights of the stand are those above the ground.
using Shown = std::variant<Interior, Hall, Foliage, Machine, Terrain, Town, Display, Scene (*)()>;

// An object that moves: by `step` in a frame, while it turns about `axis` by `turn` radians. It slows down
// and comes back after 79 frames, so that no object leaves its scene.
struct Mover {
    Mesh mesh;  // around the origin
    glm::dvec3 from;
    glm::dvec3 step;
    double turn = 0.0;
    glm::dvec3 axis{0, 1, 0};
};

struct Row {
    ViewInfo info;
    Shown shown;
    Stand stand{};
    std::vector<Mover> movers{};
};

// A ball that rolls on a level floor without slipping.
Mover rolling(double radius, const glm::dvec3& from, const glm::dvec3& step) {
    return {.mesh = make_sphere({0, 0, 0}, radius, 32, 64),
            .from = from,
            .step = step,
            .turn = glm::length(step) / radius,
            .axis = glm::cross(glm::dvec3(0, 1, 0), step)};
}

// All views and built-in scenes, in their order: new ones are added at the end.
const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {{"study", "interior", "a room with books, chairs and a table", tuning},
         Interior{.seed = 11},
         {{1.6, 1.6, 2.2}, {-0.5, 0.7, -1.0}, gliding, {-0.012, 0, -0.008}}},
        {{"workshop", "interior", "a large room, crowded, seen from a corner", unseen},
         Interior{.seed = 12, .half_width = 4.0, .half_depth = 3.5, .fullness = 0.85, .radius = 0.5},
         {{-3.6, 1.9, 3.1}, {0.5, 0.5, -1.0}, passing, {0.02, 0, 0}}},
        {{"tabletop", "interior", "small things on a table, close up", tuning},
         Interior{.seed = 13, .radius = 0.12},
         {{0.7, 1.15, 0.8}, {0, 0.76, 0}, circling, {0.5, 0, 0}, {.near = 0.02}}},
        {{"plan", "interior", "furniture from above, orthographic", unseen},
         Interior{.seed = 14, .half_width = 3.5, .half_depth = 3.0, .roofed = false, .radius = 0.4},
         {{2.0, 8.0, 5.0}, {0, 0, 0}, gliding, {0.01, 0, 0.004}, {.far = 40.0, .view_height = 5.0}}},
        {{"nave", "hall", "two rows of pillars, along the middle", tuning},
         Hall{.seed = 21},
         {{0.2, 1.7, 1.5}, {0, 1.6, -10}, gliding, {0, 0, -0.03}}},
        {{"aisle", "hall", "behind the pillars, looking across", unseen},
         Hall{.seed = 22, .half_width = 5.0, .radius = 0.7},
         {{-3.6, 1.5, 1.0}, {2.0, 1.0, -7.0}, gliding, {0.015, 0, -0.02}}},
        {{"crypt", "hall", "low, with a wide angle", tuning},
         Hall{.seed = 23, .half_width = 3.0, .height = 2.8, .pillars = 1.5, .radius = 0.4},
         {{1.0, 1.0, 0.8}, {-0.4, 1.0, -5.0}, passing, {-0.012, 0, 0}, {.fovy_rad = 1.25}}},
        {{"stairs", "hall", "stairs with railings, close up", unseen},
         Hall{.seed = 24, .length = 9.0, .radius = 0.35},
         {{1.6, 1.5, -2.6}, {-0.2, 0.8, -5.6}, passing, {-0.015, 0.004, 0}}},
        {{"meadow", "foliage", "grass and bushes", tuning},
         Foliage{.seed = 31, .bushes = 8, .leaves = 300, .blades = 4000},
         {{0, 0.9, 3.2}, {0, 0.2, 0}, gliding, {0.01, 0, 0}}},
        {{"grove", "foliage", "trees with leaves in crowns", unseen},
         Foliage{.seed = 32,
                 .half = 5.0,
                 .trees = 12,
                 .leaves = 1200,
                 .leaf = 0.16,
                 .blades = 1500,
                 .radius = 0.4},
         {{0, 1.5, 6.5}, {0, 1.2, 0}, gliding, {0.02, 0, -0.01}}},
        {{"hedge", "foliage", "bushes close up, leaf by leaf", tuning},
         Foliage{.seed = 33, .half = 0.9, .bushes = 9, .leaves = 350, .radius = 0.15},
         {{0.3, 0.7, 1.9}, {0, 0.3, 0}, circling, {0.4, 0, 0}}},
        {{"lawn", "foliage", "grass from above, orthographic", unseen},
         Foliage{.seed = 34,
                 .half = 2.5,
                 .bushes = 3,
                 .leaves = 300,
                 .blades = 7000,
                 .blade = 0.15,
                 .radius = 0.15},
         {{0.5, 5.0, 4.0}, {0, 0, 0}, gliding, {0.006, 0, 0}, {.far = 40.0, .view_height = 2.6}}},
        {{"engine", "machine", "housings, gears and pipes", tuning},
         Machine{.seed = 41},
         {{0.8, 1.5, 2.6}, {0, 0.8, -1.0}, passing, {-0.015, 0, 0}}},
        {{"pipes", "machine", "pipes before a wall", unseen},
         Machine{.seed = 42, .parts = 3, .pipes = 14, .radius = 0.3},
         {{-0.8, 1.4, 2.0}, {0.2, 1.1, -1.5}, gliding, {0.012, 0, 0}}},
        {{"grating", "machine", "a grating over the floor", tuning},
         Machine{.seed = 43, .parts = 4, .pipes = 4, .grating = true, .radius = 0.3},
         {{0.3, 1.3, 2.8}, {0, 0.2, 0.0}, gliding, {0.01, 0, -0.005}}},
        {{"panel", "machine", "machines from the front, orthographic", unseen},
         Machine{.seed = 44, .parts = 6, .pipes = 8, .radius = 0.25},
         {{0.6, 2.0, 5.0}, {0, 1.0, -1.0}, gliding, {-0.008, 0, 0}, {.far = 40.0, .view_height = 2.6}}},
        {{"hills", "terrain", "hills with stones", tuning},
         Terrain{.seed = 51, .stones = 80},
         {{0, 4.0, 18}, {0, 0, 0}, gliding, {0.05, 0, 0}, {.far = 400.0}}},
        {{"canyon", "terrain", "ridges, far away", unseen},
         Terrain{.seed = 52, .half = 80.0, .size = 25.0, .relief = 8.0, .ridged = true, .radius = 5.0},
         {{0, 14.0, 55}, {0, 0, 0}, gliding, {0.15, 0, 0}, {.far = 400.0}}},
        {{"stones", "terrain", "stones on the ground, close up", tuning},
         Terrain{.seed = 53,
                 .half = 8.0,
                 .size = 5.0,
                 .relief = 0.5,
                 .stones = 220,
                 .stone = 0.3,
                 .radius = 0.35},
         {{0, 1.6, 4}, {0, 0, 0.5}, gliding, {0.015, 0, 0}, {.far = 400.0}}},
        {{"town", "terrain", "houses along streets, from above", unseen},
         Town{.seed = 54},
         {{10, 40, 45}, {0, 5, -40}, gliding, {0.3, 0, -0.1}, {.near = 1.0, .far = 800.0}}},
        {{"bunny", "mesh", "the bunny of glmark2-data", tuning},
         Display{.file = "bunny.obj"},
         {{0.4, 0.9, 1.9}, {0, 0.45, 0}, circling, {0.7, 0, 0}}},
        {{"horse", "mesh", "three horses of glmark2-data", unseen},
         Display{.file = "horse.3ds", .copies = 3, .spacing = 1.4},
         {{0.5, 1.3, 3.6}, {0, 0.4, 0}, gliding, {0.012, 0, 0}}},
        {{"cats", "mesh", "rows of cats of glmark2-data", tuning},
         Display{.file = "cat.3ds", .up = {0, 0, -1}, .copies = 4, .rows = 3, .spacing = 1.6},
         {{-0.5, 1.7, 3.0}, {0, 0.2, -0.8}, gliding, {0.01, 0, 0}}},
        {{"asteroids", "mesh", "asteroids of glmark2-data that touch", unseen},
         Display{.file = "asteroid-high.3ds", .copies = 4, .rows = 3, .spacing = 1.05},
         {{1.2, 1.6, 2.6}, {0, 0.3, -0.8}, passing, {-0.015, 0, 0}}},
        {{"columns", "scene", "a column hall, from a cable 0.1 m before the eye to 200 m away", tuning},
         make_columns,
         {{0.3, 1.75, 1.0},
          {0.0, 1.9, -12.0},
          swaying,
          {0.12, 0.02, 0},
          {.fovy_rad = 1.0, .far = 250.0},
          {0.05, 0.11, 0}}},
        {{"corner", "scene", "a floor and two walls, whose occlusion is known in closed form", {}},
         make_corner,
         {{3.6, 3.1, 3.9}, {0.6, 0.6, 0.6}, still, {}, {.near = 0.1, .far = 40.0}}},
        {{"far", "scene", "a terrace and balls 128 km from the origin, under a slow camera", unseen},
         make_far,
         {far_place + glm::dvec3(1.2, 1.6, 3.2),
          far_place + glm::dvec3(-0.1, 0.6, -1.5),
          swaying,
          {-0.4, 0, 0.1},
          {.fovy_rad = 0.8, .near = 0.1, .far = 60.0},
          {0.01, 0, 0.013}}},
        {{"grass", "scene", "blades and leaves without thickness, under a moving camera", tuning},
         make_grass,
         {{0, 0.42, 0.75},
          {0, 0.1, -0.8},
          swaying,
          {0.3, 0, 0.1},
          {.fovy_rad = 0.8, .far = 60.0},
          {0.02, 0, 0.013},
          {0.3, 0, 0.1}}},
        {{"knot", "scene", "a knotted tube on the ground before a wall, under a circling camera", unseen},
         make_knot,
         {{0.9, 0.95, 2.0}, {0, 0.48, 0}, swinging, {}, {.fovy_rad = 0.7, .near = 0.1, .far = 40.0}}},
        {{"moving", "scene",
          "a rolling ball and a turning box before steps and a wall, under a moving camera", tuning},
         make_moving,
         {{0.3, 1.3, 3.0},
          {0, 0.5, -1.0},
          swaying,
          {0.5, 0, 0.2},
          {.fovy_rad = 0.8, .near = 0.1, .far = 60.0},
          {0.017, 0, 0.011}}},
        {{"relief", "scene", "a carved panel in the hall of columns, close up", {}},
         make_relief,
         {{relief_face + 0.75, 1.75, -5.0 + 0.35},
          {relief_face, 1.58, -5.0},
          swaying,
          {0, 0.01, 0.06},
          {.fovy_rad = 1.0, .far = 250.0},
          {0, 0.11, 0.05}}},
        {{"room", "scene", "a closed room with books, boards and other small things, under a moving camera",
          unseen},
         make_room,
         {{0.7, 1.5, 1.6},
          {-0.2, 0.8, -1.6},
          swaying,
          {0.5, 0, -0.3},
          {.fovy_rad = 0.95, .far = 20.0},
          {0.02, 0, 0.015}}},
        {{"sky", "scene", "masts, wires and a kite, mostly sky, under a moving camera", tuning},
         make_sky,
         {{0, 1.7, 0},
          {0, 4.7, -9.0},
          swaying,
          {0, 0, -0.5},
          {.fovy_rad = 0.8, .near = 0.1, .far = 500.0},
          {0.02, 0, 0.01},
          {1.5, 0, 0}}},
        // One object rolls, one tumbles, one slides along a wall out of the picture, and the camera moves.
        {{"yard", "motion", "a ball, a box and a crate move before machines", tuning},
         Machine{.seed = 61, .parts = 3, .pipes = 0, .radius = 0.3},
         {{0.8, 1.5, 2.6}, {0, 0.7, -1.0}, passing, {-0.012, 0, 0}},
         {rolling(0.3, {-1.3, 0.3, 0.3}, {0.045, 0, 0}),
          {make_box({-0.25, -0.15, -0.2}, {0.25, 0.15, 0.2}, 1.0),
           {1.1, 0.7, 0.2},
           {-0.02, -0.006, 0},
           0.08,
           {0.6, 0.2, 0.8}},
          {make_box({-0.35, 0, -0.3}, {0.35, 0.8, 0.3}, 1.0), {2.8, 0, -1.68}, {0.06, 0, 0}}}},
        {{"gallery", "motion", "a ball, a plank and a chest move in a hall", unseen},
         Hall{.seed = 62},
         {{0.6, 1.6, 1.0}, {-1.0, 0.9, -6.0}, gliding, {0.008, 0, -0.012}},
         {rolling(0.4, {-0.9, 0.4, -4.6}, {0.01, 0, 0.05}),
          {make_box({-0.5, -0.06, -0.15}, {0.5, 0.06, 0.15}, 1.0),
           {0.5, 0.6, -2.6},
           {-0.02, 0, -0.01},
           0.07,
           {0.3, 0.4, 0.9}},
          {make_box({-0.3, 0, -0.45}, {0.3, 0.6, 0.45}, 1.0), {3.15, 0, -4.7}, {0, 0, 0.1}}}}};
    return all;
}

Camera start_of(const Stand& stand) {
    Camera start{.eye = stand.eye,
                 .target = stand.target,
                 .fovy_rad = stand.lens.fovy_rad,
                 .near = stand.lens.near,
                 .far = stand.lens.far,
                 .reversed_z = true};
    if (stand.lens.view_height > 0.0) {
        start.projection = Projection::orthographic;
        start.view_height = stand.lens.view_height;
    }
    return start;
}

Camera camera_in(const Stand& stand, int frame) {
    Camera camera = start_of(stand);
    const glm::dvec3 moved = static_cast<double>(frame) * stand.step;
    const glm::dvec3 swayed = glm::sin(stand.rate * static_cast<double>(frame));
    switch (stand.way) {
        case gliding:
            camera.eye += moved;
            camera.target += moved;
            break;
        case passing:
            camera.eye += moved;
            break;
        case circling:
            camera.eye = stand.target + upright_turn(frame * stand.step.x * std::numbers::pi / 180.0) *
                                            (stand.eye - stand.target);
            break;
        case swaying:
            camera.eye += stand.step * swayed;
            camera.target += stand.aim * swayed;
            break;
        case swinging: {
            const double angle = std::atan2(stand.eye.x, stand.eye.z) + 0.5 * (std::cos(0.02 * frame) - 1.0);
            const double distance = std::hypot(stand.eye.x, stand.eye.z);
            camera.eye = {distance * std::sin(angle), camera.eye.y, distance * std::cos(angle)};
            break;
        }
        case still:
            break;
    }
    return camera;
}

// folder: of mesh files. Throws std::runtime_error with the file's name and the package that has it if it
// cannot be read.
Scene made(const Display& display, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / display.file;
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        throw std::runtime_error(
            fmt::format("mesh {}: no such file; the package glmark2-data has it", file.string()));
    const Mesh mesh = standing(load_mesh(file), display.up, 1.0);
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0),
                .ao_radius = display.radius};
    for (int row = 0; row < display.rows; ++row) {
        for (int copy = 0; copy < display.copies; ++copy) {
            const double x = display.spacing * (copy - 0.5 * (display.copies - 1));
            append(scene.mesh,
                   turned(mesh, upright_turn(0.9 * copy + 2.1 * row), {x, 0, -display.spacing * row}));
        }
    }
    return scene;
}

Scene made_of(const Shown& shown, const std::filesystem::path& meshes) {
    if (const auto* display = std::get_if<Display>(&shown)) return made(*display, meshes);
    return std::visit(
        [](const auto& what) -> Scene {
            if constexpr (std::is_invocable_v<decltype(what)>)
                return what();
            else if constexpr (!std::is_same_v<decltype(what), const Display&>)
                return made(what);
            return {};
        },
        shown);
}

Scene filmed(const Row& row, const std::filesystem::path& meshes) {
    Scene scene = made_of(row.shown, meshes);
    scene.name = row.info.name;
    for (const Mover& mover : row.movers)
        scene.objects.push_back({mover.mesh, [mover](int frame) {
                                     const double steps = 50.0 * std::sin(0.02 * frame);
                                     return rigid_motion(mover.from + steps * mover.step, steps * mover.turn,
                                                         mover.axis);
                                 }});
    Stand stand = row.stand;
    if (const auto* terrain = std::get_if<Terrain>(&row.shown))
        for (glm::dvec3* point : {&stand.eye, &stand.target})
            point->y += height_at(*terrain, point->x, point->z);
    scene.camera = row.info.kind == "scene" ? start_of(stand) : camera_in(stand, 0);
    if (stand.way != still) scene.camera_path = [stand](int frame) { return camera_in(stand, frame); };
    return scene;
}

// The rows of built-in scenes, or of views.
std::vector<const Row*> rows_of(bool scenes) {
    std::vector<const Row*> some;
    for (const Row& row : rows())
        if (scenes ? row.info.kind == "scene" : row.info.half.has_value()) some.push_back(&row);
    return some;
}

std::vector<ViewInfo> infos_of(bool scenes) {
    std::vector<ViewInfo> infos;
    for (const Row* row : rows_of(scenes)) infos.push_back(row->info);
    return infos;
}

Scene named(std::string_view name, bool scenes, const std::filesystem::path& meshes) {
    std::string names;
    for (const Row* row : rows_of(scenes)) {
        if (row->info.name == name) return filmed(*row, meshes);
        names += (names.empty() ? "" : ", ") + row->info.name;
    }
    throw std::invalid_argument(
        fmt::format("unknown {} \"{}\": expected {}", scenes ? "scene" : "view", name, names));
}

}  // namespace

std::vector<ViewInfo> built_in_scenes() {
    return infos_of(true);
}

std::vector<ViewInfo> all_views() {
    return infos_of(false);
}

Scene make_scene(std::string_view name) {
    return named(name, true, {});
}

Scene make_view(std::string_view name, const std::filesystem::path& meshes) {
    return named(name, false, meshes);
}

std::string_view name_of(ViewHalf half) {
    return half == tuning ? "tuning" : "unseen";
}

std::filesystem::path installed_meshes() {
    return "/usr/share/glmark2/models";
}

}  // namespace gloam::scene
