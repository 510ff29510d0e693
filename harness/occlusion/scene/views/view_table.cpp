// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "scene/mesh_scene.hpp"
#include "scene/views/generators.hpp"

namespace gloam::scene {
namespace {

using namespace views;

// All views and built-in scenes, in their order: new ones are added at the end. Members: those of ViewInfo
// (what: the description); `of`: what makes it, if not the kind; the generator's own; radius:
// Scene::ao_radius; of the camera eye and target (above a terrain their heights are those above the ground),
// fovy_rad, near, far, and view_height if it is orthographic. It moves in each frame by `gliding` with its
// target, by `passing` looking at the same target, or around its target by `circling` degrees about the
// vertical axis. Or it sways: eye and target by `swaying` and `aim`, times the sine of `rate` radians a
// frame. Or it swings around the vertical axis and back, by `swinging` radians, or stands `still`. A mover
// rolls (`ball`: its radius) or turns by `turn` radians about `axis` (`box`: two corners, around the origin),
// and moves by `step`, each in a frame.
constexpr const char* rows_text = R"json([
{"name": "study", "kind": "interior", "half": "tuning", "what": "a room with books, chairs and a table",
 "seed": 11, "radius": 0.3, "eye": [1.6, 1.6, 2.2], "target": [-0.5, 0.7, -1.0], "gliding": [-0.012, 0, -0.008]},
{"name": "workshop", "kind": "interior", "half": "unseen", "what": "a large room, crowded, seen from a corner",
 "seed": 12, "half_width": 4.0, "half_depth": 3.5, "fullness": 0.85, "radius": 0.5,
 "eye": [-3.6, 1.9, 3.1], "target": [0.5, 0.5, -1.0], "passing": [0.02, 0, 0]},
{"name": "tabletop", "kind": "interior", "half": "tuning", "what": "small things on a table, close up",
 "seed": 13, "radius": 0.12, "eye": [0.7, 1.15, 0.8], "target": [0, 0.76, 0], "circling": 0.5, "near": 0.02},
{"name": "plan", "kind": "interior", "half": "unseen", "what": "furniture from above, orthographic",
 "seed": 14, "half_width": 3.5, "half_depth": 3.0, "roofed": false, "radius": 0.4,
 "eye": [2.0, 8.0, 5.0], "target": [0, 0, 0], "gliding": [0.01, 0, 0.004], "far": 40, "view_height": 5.0},
{"name": "nave", "kind": "hall", "half": "tuning", "what": "two rows of pillars, along the middle",
 "seed": 21, "radius": 0.5, "eye": [0.2, 1.7, 1.5], "target": [0, 1.6, -10], "gliding": [0, 0, -0.03]},
{"name": "aisle", "kind": "hall", "half": "unseen", "what": "behind the pillars, looking across", "seed": 22,
 "half_width": 5.0, "radius": 0.7, "eye": [-3.6, 1.5, 1.0], "target": [2.0, 1.0, -7.0], "gliding": [0.015, 0, -0.02]},
{"name": "crypt", "kind": "hall", "half": "tuning", "what": "low, with a wide angle",
 "seed": 23, "half_width": 3.0, "height": 2.8, "pillars": 1.5, "radius": 0.4,
 "eye": [1.0, 1.0, 0.8], "target": [-0.4, 1.0, -5.0], "passing": [-0.012, 0, 0], "fovy_rad": 1.25},
{"name": "stairs", "kind": "hall", "half": "unseen", "what": "stairs with railings, close up", "seed": 24,
 "length": 9.0, "radius": 0.35, "eye": [1.6, 1.5, -2.6], "target": [-0.2, 0.8, -5.6], "passing": [-0.015, 0.004, 0]},
{"name": "meadow", "kind": "foliage", "half": "tuning", "what": "grass and bushes", "seed": 31, "bushes": 8,
 "leaves": 300, "blades": 4000, "radius": 0.2, "eye": [0, 0.9, 3.2], "target": [0, 0.2, 0], "gliding": [0.01, 0, 0]},
{"name": "grove", "kind": "foliage", "half": "unseen", "what": "trees with leaves in crowns",
 "seed": 32, "half_side": 5.0, "trees": 12, "leaves": 1200, "leaf": 0.16, "blades": 1500, "radius": 0.4,
 "eye": [0, 1.5, 6.5], "target": [0, 1.2, 0], "gliding": [0.02, 0, -0.01]},
{"name": "hedge", "kind": "foliage", "half": "tuning", "what": "bushes close up, leaf by leaf", "seed": 33,
 "half_side": 0.9, "bushes": 9, "leaves": 350, "radius": 0.15,
 "eye": [0.3, 0.7, 1.9], "target": [0, 0.3, 0], "circling": 0.4},
{"name": "lawn", "kind": "foliage", "half": "unseen", "what": "grass from above, orthographic", "seed": 34,
 "half_side": 2.5, "bushes": 3, "leaves": 300, "blades": 7000, "blade": 0.15, "radius": 0.15,
 "eye": [0.5, 5.0, 4.0], "target": [0, 0, 0], "gliding": [0.006, 0, 0], "far": 40, "view_height": 2.6},
{"name": "engine", "kind": "machine", "half": "tuning", "what": "housings, gears and pipes",
 "seed": 41, "radius": 0.25, "eye": [0.8, 1.5, 2.6], "target": [0, 0.8, -1.0], "passing": [-0.015, 0, 0]},
{"name": "pipes", "kind": "machine", "half": "unseen", "what": "pipes before a wall", "seed": 42, "parts": 3,
 "pipes": 14, "radius": 0.3, "eye": [-0.8, 1.4, 2.0], "target": [0.2, 1.1, -1.5], "gliding": [0.012, 0, 0]},
{"name": "grating", "kind": "machine", "half": "tuning", "what": "a grating over the floor",
 "seed": 43, "parts": 4, "pipes": 4, "grating": true, "radius": 0.3,
 "eye": [0.3, 1.3, 2.8], "target": [0, 0.2, 0.0], "gliding": [0.01, 0, -0.005]},
{"name": "panel", "kind": "machine", "half": "unseen", "what": "machines from the front, orthographic",
 "seed": 44, "parts": 6, "pipes": 8, "radius": 0.25,
 "eye": [0.6, 2.0, 5.0], "target": [0, 1.0, -1.0], "gliding": [-0.008, 0, 0], "far": 40, "view_height": 2.6},
{"name": "hills", "kind": "terrain", "half": "tuning", "what": "hills with stones", "seed": 51, "stones": 80,
 "radius": 1.5, "eye": [0, 4.0, 18], "target": [0, 0, 0], "gliding": [0.05, 0, 0], "far": 400},
{"name": "canyon", "kind": "terrain", "half": "unseen", "what": "ridges, far away",
 "seed": 52, "half_side": 80.0, "size": 25.0, "relief": 8.0, "ridged": true, "radius": 5.0,
 "eye": [0, 14.0, 55], "target": [0, 0, 0], "gliding": [0.15, 0, 0], "far": 400},
{"name": "stones", "kind": "terrain", "half": "tuning", "what": "stones on the ground, close up",
 "seed": 53, "half_side": 8.0, "size": 5.0, "relief": 0.5, "stones": 220, "stone": 0.3, "radius": 0.35,
 "eye": [0, 1.6, 4], "target": [0, 0, 0.5], "gliding": [0.015, 0, 0], "far": 400},
{"name": "town", "kind": "terrain", "of": "town", "half": "unseen", "what": "houses along streets, from above",
 "seed": 54, "radius": 3.0, "eye": [10, 40, 45], "target": [0, 5, -40], "gliding": [0.3, 0, -0.1], "near": 1.0,
 "far": 800},
{"name": "bunny", "kind": "mesh", "half": "tuning", "what": "the bunny of glmark2-data", "file": "bunny.obj",
 "radius": 0.2, "eye": [0.4, 0.9, 1.9], "target": [0, 0.45, 0], "circling": 0.7},
{"name": "horse", "kind": "mesh", "half": "unseen", "what": "three horses of glmark2-data",
 "file": "horse.3ds", "copies": 3, "spacing": 1.4, "radius": 0.2,
 "eye": [0.5, 1.3, 3.6], "target": [0, 0.4, 0], "gliding": [0.012, 0, 0]},
{"name": "cats", "kind": "mesh", "half": "tuning", "what": "rows of cats of glmark2-data",
 "file": "cat.3ds", "up": "-z", "copies": 4, "rows": 3, "spacing": 1.6, "radius": 0.2,
 "eye": [-0.5, 1.7, 3.0], "target": [0, 0.2, -0.8], "gliding": [0.01, 0, 0]},
{"name": "asteroids", "kind": "mesh", "half": "unseen", "what": "asteroids of glmark2-data that touch",
 "file": "asteroid-high.3ds", "copies": 4, "rows": 3, "spacing": 1.05, "radius": 0.2,
 "eye": [1.2, 1.6, 2.6], "target": [0, 0.3, -0.8], "passing": [-0.015, 0, 0]},
{"name": "columns", "kind": "scene", "half": "tuning",
 "what": "a column hall, from a cable 0.1 m before the eye to 200 m away", "radius": 0.5, "fovy_rad": 1.0, "far": 250,
 "eye": [0.3, 1.75, 1.0], "target": [0, 1.9, -12.0], "swaying": [0.12, 0.02, 0], "rate": [0.05, 0.11, 0]},
{"name": "corner", "kind": "scene", "what": "a floor and two walls, whose occlusion is known in closed form",
 "radius": 1.0, "eye": [3.6, 3.1, 3.9], "target": [0.6, 0.6, 0.6], "still": true, "near": 0.1, "far": 40},
{"name": "far", "kind": "scene", "half": "unseen",
 "what": "a terrace and balls 128 km from the origin, under a slow camera", "radius": 0.4, "fovy_rad": 0.8,
 "near": 0.1, "far": 60, "eye": [98305.2, 513.6, -81916.8], "target": [98303.9, 512.6, -81921.5],
 "swaying": [-0.4, 0, 0.1], "rate": [0.01, 0, 0.013]},
{"name": "grass", "kind": "scene", "half": "tuning",
 "what": "blades and leaves without thickness, under a moving camera", "radius": 0.15, "fovy_rad": 0.8,
 "far": 60, "eye": [0, 0.42, 0.75], "target": [0, 0.1, -0.8], "swaying": [0.3, 0, 0.1], "rate": [0.02, 0, 0.013],
 "aim": [0.3, 0, 0.1]},
{"name": "knot", "kind": "scene", "half": "unseen",
 "what": "a knotted tube on the ground before a wall, under a circling camera", "radius": 0.25, "fovy_rad": 0.7,
 "near": 0.1, "far": 40, "eye": [0.9, 0.95, 2.0], "target": [0, 0.48, 0], "swinging": 0.5},
{"name": "moving", "kind": "scene", "half": "tuning",
 "what": "a rolling ball and a turning box before steps and a wall, under a moving camera", "radius": 0.4,
 "fovy_rad": 0.8, "near": 0.1, "far": 60, "eye": [0.3, 1.3, 3.0], "target": [0, 0.5, -1.0],
 "swaying": [0.5, 0, 0.2], "rate": [0.017, 0, 0.011]},
{"name": "relief", "kind": "scene", "what": "a carved panel in the hall of columns, close up", "radius": 0.5,
 "fovy_rad": 1.0, "far": 250, "eye": [-5.95, 1.75, -4.65], "target": [-6.7, 1.58, -5.0],
 "swaying": [0, 0.01, 0.06], "rate": [0, 0.11, 0.05]},
{"name": "room", "kind": "scene", "half": "unseen",
 "what": "a closed room with books, boards and other small things, under a moving camera", "radius": 0.3,
 "fovy_rad": 0.95, "far": 20, "eye": [0.7, 1.5, 1.6], "target": [-0.2, 0.8, -1.6], "swaying": [0.5, 0, -0.3],
 "rate": [0.02, 0, 0.015]},
{"name": "sky", "kind": "scene", "half": "tuning", "what": "masts, wires and a kite, mostly sky, under a moving camera",
 "radius": 0.6, "fovy_rad": 0.8, "near": 0.1, "far": 500, "eye": [0, 1.7, 0], "target": [0, 4.7, -9.0],
 "swaying": [0, 0, -0.5], "rate": [0.02, 0, 0.01], "aim": [1.5, 0, 0]},
{"name": "yard", "kind": "motion", "of": "machine", "half": "tuning",
 "what": "a ball, a box and a crate move before machines", "seed": 61, "parts": 3, "pipes": 0, "radius": 0.3,
 "eye": [0.8, 1.5, 2.6], "target": [0, 0.7, -1.0], "passing": [-0.012, 0, 0], "movers": [
  {"ball": 0.3, "from": [-1.3, 0.3, 0.3], "step": [0.045, 0, 0]},
  {"box": [[-0.25, -0.15, -0.2], [0.25, 0.15, 0.2]], "from": [1.1, 0.7, 0.2], "step": [-0.02, -0.006, 0],
   "turn": 0.08, "axis": [0.6, 0.2, 0.8]},
  {"box": [[-0.35, 0, -0.3], [0.35, 0.8, 0.3]], "from": [2.8, 0, -1.68], "step": [0.06, 0, 0]}]},
{"name": "gallery", "kind": "motion", "of": "hall", "half": "unseen",
 "what": "a ball, a plank and a chest move in a hall", "seed": 62, "radius": 0.5,
 "eye": [0.6, 1.6, 1.0], "target": [-1.0, 0.9, -6.0], "gliding": [0.008, 0, -0.012], "movers": [
  {"ball": 0.4, "from": [-0.9, 0.4, -4.6], "step": [0.01, 0, 0.05]},
  {"box": [[-0.5, -0.06, -0.15], [0.5, 0.06, 0.15]], "from": [0.5, 0.6, -2.6], "step": [-0.02, 0, -0.01],
   "turn": 0.07, "axis": [0.3, 0.4, 0.9]},
  {"box": [[-0.3, 0, -0.45], [0.3, 0.6, 0.45]], "from": [3.15, 0, -4.7], "step": [0, 0, 0.1]}]}
])json";

const Row& rows() {
    static const Row all = Row::parse(rows_text);
    return all;
}

const std::map<std::string, Scene (*)(const Row&)> generators{
    {"interior", make_interior}, {"hall", make_hall},   {"foliage", make_foliage}, {"machine", make_machine},
    {"terrain", make_terrain},   {"town", make_town},   {"columns", make_columns}, {"corner", make_corner},
    {"far", make_far},           {"grass", make_grass}, {"knot", make_knot},       {"moving", make_moving},
    {"relief", make_relief},     {"room", make_room},   {"sky", make_sky}};

glm::dvec3 vector_of(const Row& values) {
    return {values.at(0).get<double>(), values.at(1).get<double>(), values.at(2).get<double>()};
}

// 0 where the row has none.
glm::dvec3 vector_in(const Row& row, const char* key) {
    return row.contains(key) ? vector_of(row[key]) : glm::dvec3(0);
}

Camera start_of(const Row& row) {
    Camera start{.eye = vector_in(row, "eye"),
                 .target = vector_in(row, "target"),
                 .fovy_rad = row.value("fovy_rad", 0.9),
                 .near = row.value("near", 0.05),
                 .far = row.value("far", 200.0),
                 .reversed_z = true};
    if (row.contains("view_height")) {
        start.projection = Projection::orthographic;
        start.view_height = row["view_height"];
    }
    if (row["kind"] == "terrain" && !row.contains("of"))
        for (glm::dvec3* point : {&start.eye, &start.target}) point->y += height_of(row)(point->x, point->z);
    return start;
}

Camera camera_in(const Row& row, int frame) {
    Camera camera = start_of(row);
    const auto moved = [&](const char* way) { return static_cast<double>(frame) * vector_in(row, way); };
    const glm::dvec3 swayed = glm::sin(vector_in(row, "rate") * static_cast<double>(frame));
    camera.eye += moved("gliding") + moved("passing") + vector_in(row, "swaying") * swayed;
    camera.target += moved("gliding") + vector_in(row, "aim") * swayed;
    if (row.contains("circling")) {
        const double degrees = row["circling"];
        camera.eye = camera.target +
                     upright_turn(frame * degrees * std::numbers::pi / 180.0) * (camera.eye - camera.target);
    } else if (row.contains("swinging")) {
        const double angle = std::atan2(camera.eye.x, camera.eye.z) +
                             row["swinging"].get<double>() * (std::cos(0.02 * frame) - 1.0);
        const double distance = std::hypot(camera.eye.x, camera.eye.z);
        camera.eye = {distance * std::sin(angle), camera.eye.y, distance * std::cos(angle)};
    }
    return camera;
}

// Copies of a mesh file in rows on a plane, each turned further. spacing: in heights of the mesh. folder: of
// mesh files. Throws std::runtime_error with the file's name and the package that has it if it cannot be
// read.
Scene displayed(const Row& row, const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / row["file"].get<std::string>();
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        throw std::runtime_error(
            fmt::format("mesh {}: no such file; the package glmark2-data has it", file.string()));
    const Mesh mesh = standing(load_mesh(file), axis_named(row.value("up", "y")).value(), 1.0);
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0)};
    const int copies = row.value("copies", 1);
    const double spacing = row.value("spacing", 1.2);
    for (int line = 0; line < row.value("rows", 1); ++line) {
        for (int copy = 0; copy < copies; ++copy) {
            const double x = spacing * (copy - 0.5 * (copies - 1));
            append(scene.mesh, turned(mesh, upright_turn(0.9 * copy + 2.1 * line), {x, 0, -spacing * line}));
        }
    }
    return scene;
}

// An object that slows down and comes back after 79 frames, so that none leaves its scene. A ball rolls on a
// level floor without slipping.
MovingObject moving_object(const Row& mover) {
    const bool rolls = mover.contains("ball");
    const double radius = mover.value("ball", 1.0);
    const glm::dvec3 from = vector_in(mover, "from");
    const glm::dvec3 step = vector_in(mover, "step");
    const double turn = rolls ? glm::length(step) / radius : mover.value("turn", 0.0);
    const glm::dvec3 up{0, 1, 0};
    const glm::dvec3 axis = rolls                    ? glm::cross(up, step)
                            : mover.contains("axis") ? vector_in(mover, "axis")
                                                     : up;
    return {rolls ? make_sphere({0, 0, 0}, radius, 32, 64)
                  : make_box(vector_of(mover["box"][0]), vector_of(mover["box"][1]), 1.0),
            [=](int frame) {
                const double steps = 50.0 * std::sin(0.02 * frame);
                return rigid_motion(from + steps * step, steps * turn, axis);
            }};
}

Scene filmed(const Row& row, const std::filesystem::path& meshes) {
    const std::string name = row["name"];
    const std::string kind = row["kind"];
    const std::string maker = row.value("of", kind == "scene" ? name : kind);
    Scene scene = kind == "mesh" ? displayed(row, meshes) : generators.at(maker)(row);
    scene.name = name;
    scene.ao_radius = row["radius"];
    for (const Row& mover : row.value("movers", Row::array())) scene.objects.push_back(moving_object(mover));
    scene.camera = camera_in(row, 0);
    if (!row.contains("still")) scene.camera_path = [row](int frame) { return camera_in(row, frame); };
    return scene;
}

// Whether a row is one of the built-in scenes, or of the views.
bool is_of(const Row& row, bool scenes) {
    return scenes ? row["kind"] == "scene" : row.contains("half");
}

std::vector<ViewInfo> infos_of(bool scenes) {
    std::vector<ViewInfo> infos;
    for (const Row& row : rows()) {
        if (!is_of(row, scenes)) continue;
        infos.push_back({row["name"], row["kind"], row["what"], row.value("half", "")});
    }
    return infos;
}

Scene named(std::string_view name, bool scenes, const std::filesystem::path& meshes) {
    std::string names;
    for (const Row& row : rows()) {
        if (!is_of(row, scenes)) continue;
        const std::string known = row["name"];
        if (known == name) return filmed(row, meshes);
        names += (names.empty() ? "" : ", ") + known;
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

std::filesystem::path installed_meshes() {
    return "/usr/share/glmark2/models";
}

}  // namespace gloam::scene
