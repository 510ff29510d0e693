// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/scene.hpp"

namespace gloam::scene {
namespace {

void check_mesh(const std::string& name, const Mesh& mesh) {
    const auto fail = [&](const std::string& what) {
        throw std::invalid_argument(fmt::format("scene {}: {}", name, what));
    };
    if (mesh.indices.size() % 3 != 0)
        fail(fmt::format("{} indices, expected three for each triangle", mesh.indices.size()));
    if (mesh.normals.size() != mesh.positions.size())
        fail(fmt::format("{} normals for {} positions", mesh.normals.size(), mesh.positions.size()));
    if (!mesh.colors.empty() && mesh.colors.size() != mesh.triangle_count())
        fail(fmt::format("{} colours for {} triangles", mesh.colors.size(), mesh.triangle_count()));
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.positions.size())
            fail(fmt::format("index {} is beyond its {} positions", index, mesh.positions.size()));
    }
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3& p = mesh.positions[i];
        if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
            fail(fmt::format("vertex {} is ({}, {}, {}), expected finite numbers", i, p.x, p.y, p.z));
    }
}

}  // namespace

void validate(const Scene& scene) {
    std::size_t triangles = scene.mesh.triangle_count();
    check_mesh(scene.name, scene.mesh);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const std::string name = fmt::format("{}, object {}", scene.name, i + 1);
        if (!scene.objects[i].transform)
            throw std::invalid_argument(fmt::format("scene {}: no transform", name));
        check_mesh(name, scene.objects[i].mesh);
        triangles += scene.objects[i].mesh.triangle_count();
    }
    if (triangles == 0) throw std::invalid_argument(fmt::format("scene {}: no triangles in it", scene.name));
}

}  // namespace gloam::scene
