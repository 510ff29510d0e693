// SPDX-License-Identifier: MIT
#include "stress/moved_scene.hpp"

#include <cmath>

#include "numeric/random.hpp"

namespace gloam::stress {
namespace {

constexpr double grid = 1'048'576.0;
constexpr double nearest = 0.5;
constexpr double farthest_move = 50.0;

glm::dvec3 on_grid(const glm::dvec3& x) {
    return glm::round(x * grid) / grid;
}

bool seen(const scene::Camera& camera, const glm::dvec3& point) {
    const glm::dvec3 at = scene::view_rotation(camera) * (point - camera.eye);
    const glm::dvec4 clip = projection_of(camera) * glm::dvec4(at, 1.0);
    return -at.z >= nearest && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
}

}  // namespace

glm::dmat4 projection_of(const scene::Camera& camera) {
    return glm::dmat4(scene::make_frame(camera, aspect).proj_vk);
}

MovedPoints points_at_origin(std::size_t count, std::uint64_t seed) {
    MovedPoints all{.now = {.eye = {0.125, 1.5, 3.25}, .target = {0.5, 1.25, -1.0}},
                    .before = {.eye = {-0.0625, 1.5625, 3.375}, .target = {0.25, 1.25, -1.0}}};
    const glm::dvec2 p(projection_of(all.now)[0][0], projection_of(all.now)[1][1]);
    const glm::dmat3 rotation = scene::view_rotation(all.now);
    numeric::Random random(seed);
    while (all.points.size() < count) {
        const double depth = nearest * std::pow(farthest_move / nearest, random.unit());
        const glm::dvec2 ndc(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        const glm::dvec3 at(ndc / p * depth, -depth);
        const glm::dvec3 point = on_grid(all.now.eye + glm::transpose(rotation) * at);
        if (seen(all.now, point) && seen(all.before, point)) all.points.push_back(point);
    }
    return all;
}

glm::dvec3 shift_by(double distance) {
    return std::round(distance / std::sqrt(3.0)) * glm::dvec3(1, -1, 1);
}

MovedPoints moved(MovedPoints all, double distance) {
    all.shift = shift_by(distance);
    for (scene::Camera* camera : {&all.now, &all.before}) {
        camera->eye += all.shift;
        camera->target += all.shift;
    }
    for (glm::dvec3& point : all.points) point += all.shift;
    return all;
}

scene::Scene moved_scene(const char* name, double distance) {
    const scene::Scene still = scene::make_scene(name);
    const glm::dvec3 shift = shift_by(distance);
    scene::Scene scene{.name = still.name, .camera = still.camera, .ao_radius = still.ao_radius};
    scene.camera.eye = on_grid(still.camera.eye) + shift;
    scene.camera.target = on_grid(still.camera.target) + shift;
    glm::dmat4 transform(1.0);
    transform[3] = glm::dvec4(shift, 1.0);
    scene.objects.push_back({.mesh = still.mesh, .transform = [transform](int) { return transform; }});
    return scene;
}

}  // namespace gloam::stress
