// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "scene/internal/columns.hpp"
#include "scene/internal/corner_scene.hpp"
#include "scene/primitives.hpp"

namespace gloam::scene {
namespace {

struct BuiltIn {
    SceneInfo info;
    Scene (*make)();
};

const std::vector<BuiltIn>& all_built_in() {
    static const std::vector<BuiltIn> scenes{
        {{"columns", "a column hall, from 0.4 m before the eye to 200 m away, open to the sky at its end"},
         make_columns},
        {{"corner", "a floor and two walls, whose occlusion is known in closed form"}, make_corner}};
    return scenes;
}

}  // namespace

std::vector<SceneInfo> built_in_scenes() {
    std::vector<SceneInfo> infos;
    for (const BuiltIn& scene : all_built_in()) infos.push_back(scene.info);
    return infos;
}

Scene make_scene(std::string_view name) {
    std::string names;
    for (const BuiltIn& scene : all_built_in()) {
        if (scene.info.name == name) return scene.make();
        names += (names.empty() ? "" : ", ") + scene.info.name;
    }
    throw std::invalid_argument("unknown scene \"" + std::string(name) + "\": expected " + names);
}

Scene mesh_on_ground(Mesh mesh, std::string name) {
    const Bounds bounds = bounds_of(mesh);
    const glm::dvec3 size = bounds.high - bounds.low;
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > 0.0)) throw std::invalid_argument("mesh " + name + ": all its vertices are one point");
    const double scale = 1.0 / largest;
    const glm::dvec3 foot{0.5 * (bounds.low.x + bounds.high.x), bounds.low.y,
                          0.5 * (bounds.low.z + bounds.high.z)};
    Scene scene{.name = std::move(name), .mesh = placed(std::move(mesh), scale, -scale * foot)};
    append(scene.mesh, make_parallelogram({-6, 0, 6}, {12, 0, 0}, {0, 0, -12}, 0.25));
    const double height = scale * size.y;
    scene.camera = {.eye = {0.55, 0.45 * height + 0.75, 1.75},
                    .target = {0, 0.45 * height, 0},
                    .fovy_rad = 0.75,
                    .near = 0.1,
                    .far = 20.0,
                    .reversed_z = true};
    scene.ao_radius = 0.2;
    return scene;
}

}  // namespace gloam::scene
