// SPDX-License-Identifier: MIT
#include "scene/views/meshes.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "scene/mesh_scene.hpp"
#include "scene/primitives.hpp"
#include "scene/views/shapes.hpp"

namespace gloam::scene::views {

Scene make_display(const std::filesystem::path& folder, const Display& display) {
    const std::filesystem::path file = folder / display.file;
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        throw std::runtime_error(
            fmt::format("mesh {}: no such file; the package glmark2-data has it", file.string()));
    const Mesh mesh = mesh_scene(load_mesh(file), display.file, {.up = display.up, .ground = false}).mesh;
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0)};
    for (int row = 0; row < display.rows; ++row) {
        for (int copy = 0; copy < display.copies; ++copy) {
            const double x = display.spacing * (copy - 0.5 * (display.copies - 1));
            append(scene.mesh, turned(mesh, 0.9 * copy + 2.1 * row, {x, 0, -display.spacing * row}));
        }
    }
    scene.ao_radius = display.radius;
    return scene;
}

}  // namespace gloam::scene::views
