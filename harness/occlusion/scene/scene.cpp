// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gloam::scene {

Camera camera_at(const Scene& scene, int frame) {
    return scene.camera_path ? scene.camera_path(frame) : scene.camera;
}

Mesh view_space_mesh(const Scene& scene, int frame) {
    const Camera camera = camera_at(scene, frame);
    const glm::dmat3 rotation = view_rotation(camera);
    Mesh all;
    const auto add = [&](const Mesh& mesh, const glm::dmat4& world_from_mesh) {
        const glm::dmat3 turn = rotation * glm::dmat3(world_from_mesh);
        const glm::dvec3 move = rotation * (glm::dvec3(world_from_mesh[3]) - camera.eye);
        // A static mesh is moved relative to the eye before it is rotated, so that no digits are lost far
        // from the origin.
        const bool still = world_from_mesh == glm::dmat4(1.0);
        Mesh seen = mesh;
        for (glm::vec3& p : seen.positions)
            p = still ? rotation * (glm::dvec3(p) - camera.eye) : turn * glm::dvec3(p) + move;
        for (glm::vec3& n : seen.normals) n = turn * glm::dvec3(n);
        append(all, seen);
    };
    add(scene.mesh, glm::dmat4(1.0));
    for (const MovingObject& object : scene.objects) add(object.mesh, object.transform(frame));
    return all;
}

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
