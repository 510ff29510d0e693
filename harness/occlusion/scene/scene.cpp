// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

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

}  // namespace gloam::scene
