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

const std::map<std::string, Scene (*)(const Row&)> generators{
    {"interior", make_interior}, {"hall", make_hall}, {"foliage", make_foliage}, {"machine", make_machine},
    {"terrain", make_terrain},   {"town", make_town}, {"grass", make_grass}};

// 0 where the row has none.
glm::dvec3 vector_in(const Row& row, const char* key) {
    return row.contains(key) ? vector_of(row[key]) : glm::dvec3(0);
}

Camera camera_in(const Row& row, int frame) {
    Camera camera{.eye = vector_in(row, "eye"),
                  .target = vector_in(row, "target"),
                  .fovy_rad = row.value("fovy_rad", 0.9),
                  .near = row.value("near", 0.05),
                  .far = row.value("far", 200.0),
                  .reversed_z = true};
    if (row.contains("view_height")) {
        camera.projection = Projection::orthographic;
        camera.view_height = row["view_height"];
    }
    if (row["kind"] == "terrain" && !row.contains("of"))
        for (glm::dvec3* at : {&camera.eye, &camera.target}) at->y += height_of(row)(at->x, at->z);
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
    const Mesh mesh = standing(read_mesh(file), axis_named(row.value("up", "y")).value(), 1.0);
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0)};
    const int copies = row.value("copies", 1);
    const double spacing = row.value("spacing", 1.2);
    for (int line = 0; line < row.value("rows", 1); ++line) {
        for (int copy = 0; copy < copies; ++copy) {
            const double x = spacing * (copy - 0.5 * (copies - 1));
            append(scene.mesh, placed(mesh, upright_turn(0.9 * copy + 2.1 * line), {x, 0, -spacing * line}));
        }
    }
    return scene;
}

// A ball rolls on a level floor without slipping.
MovingObject moving_object(const Row& mover) {
    const bool rolls = mover.contains("ball");
    const double radius = mover.value("ball", 1.0);
    const glm::dvec3 from = vector_in(mover, "from");
    const glm::dvec3 way = vector_in(mover, "way");
    const glm::dvec3 aside = vector_in(mover, "aside");
    const glm::dvec3 up{0, 1, 0};
    const glm::dvec3 axis = mover.contains("axis")          ? vector_in(mover, "axis")
                            : rolls && way != glm::dvec3(0) ? glm::cross(up, way)
                                                            : up;
    const double turn = rolls ? glm::length(way) / radius : mover.value("turn", 0.0);
    return {rolls ? make_sphere({0, 0, 0}, radius, mover.value("rings", 32))
                  : make_box(vector_of(mover["box"]), vector_of(mover["box"], 3), 1.0),
            [=, rate = mover.value("rate", 0.02), start = mover.value("start", 0.0),
             spin = mover.value("spin", 0.0)](int frame) {
                const double swing = std::sin(rate * frame);
                return rigid_motion(from + swing * way + std::cos(rate * frame) * aside,
                                    start + swing * turn + spin * frame, axis);
            }};
}

Scene filmed(const Row& row, const std::filesystem::path& meshes) {
    const std::string kind = row["kind"];
    const auto maker = generators.find(row.value("of", kind));
    Scene scene = kind == "mesh"              ? displayed(row, meshes)
                  : maker != generators.end() ? maker->second(row)
                                              : Scene{};
    if (row.contains("shapes")) append(scene.mesh, shapes_of(row));
    scene.name = row["name"];
    scene.ao_radius = row["radius"];
    if (row.contains("lamp")) scene.lamp = vector_in(row, "lamp");
    for (const Row& mover : row.value("movers", Row::array())) scene.objects.push_back(moving_object(mover));
    scene.camera = camera_in(row, 0);
    if (!row.contains("still")) scene.camera_path = [row](int frame) { return camera_in(row, frame); };
    return scene;
}

}  // namespace

std::vector<ViewInfo> all_views() {
    std::vector<ViewInfo> infos;
    for (const Row& row : rows())
        infos.push_back({row["name"], row["kind"], row["what"], row.value("half", "")});
    return infos;
}

Scene make_scene(std::string_view name, const std::filesystem::path& meshes) {
    std::string names;
    for (const Row& row : rows()) {
        const std::string known = row["name"];
        if (known == name) return filmed(row, meshes);
        names += (names.empty() ? "" : ", ") + known;
    }
    throw std::invalid_argument(fmt::format("unknown scene \"{}\": expected {}", name, names));
}

std::filesystem::path installed_meshes() {
    return "/usr/share/glmark2/models";
}

}  // namespace gloam::scene
