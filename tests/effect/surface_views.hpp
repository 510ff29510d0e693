// SPDX-License-Identifier: MIT
#pragma once

#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/scene.hpp"
#include "support/test.hpp"

// Views of surfaces whose occlusion is known.
namespace gloam::effect {

inline constexpr double view_height = 2.0;

// A view by that camera of a surface whose depth under a ray (orthographic: at a place of the image plane) is
// given; y up. Its normals face the eye.
inline scene::GBuffer view_of(backend::Extent extent, const scene::Camera& camera,
                              const std::function<double(glm::dvec2)>& depth) {
    scene::GBuffer view{.extent = extent};
    view.camera = scene::make_frame(camera, static_cast<double>(extent.width) / extent.height);
    for (unsigned y = 0; y < extent.height; ++y)
        for (unsigned x = 0; x < extent.width; ++x) {
            const glm::dvec2 ndc(2.0 * (x + 0.5) / extent.width - 1.0, 2.0 * (y + 0.5) / extent.height - 1.0);
            view.depth.push_back(static_cast<float>(depth(ndc / glm::dvec2(view.camera.p00_p11()))));
        }
    view.normal.assign(view.depth.size(), glm::vec3(0, 0, 1));
    return view;
}
inline scene::GBuffer view_of(backend::Extent extent, bool orthographic,
                              const std::function<double(glm::dvec2)>& depth) {
    scene::Camera camera{.view_height = view_height};
    if (orthographic) camera.projection = scene::Projection::orthographic;
    return view_of(extent, camera, depth);
}

// A wall in perspective.
inline scene::GBuffer wall(backend::Extent extent, float depth) {
    return view_of(extent, false, [=](glm::dvec2) { return double{depth}; });
}

// A plane through (0, 0, -5), before the background.
inline scene::GBuffer plane(backend::Extent extent, bool orthographic, glm::dvec3 normal) {
    constexpr glm::dvec3 point{0, 0, -5};
    const glm::dvec3 n = glm::normalize(normal);
    const auto depth = [&](glm::dvec2 at) {
        const double along = n.x * at.x + n.y * at.y;
        const double at_depth =
            orthographic ? (along - glm::dot(n, point)) / n.z : glm::dot(n, point) / (along - n.z);
        return at_depth > 0.0 ? at_depth : double{infinity};
    };
    scene::GBuffer view = view_of(extent, orthographic, depth);
    view.normal.assign(view.depth.size(), glm::vec3(n));
    return view;
}

// A wall parallel to the image, orthographic, of 48 x 32 pixels. Its left part may stand nearer.
inline scene::GBuffer step(float left, float right, double height = 8.0) {
    return view_of({48, 32}, {.projection = scene::Projection::orthographic, .view_height = height},
                   [=](glm::dvec2 at) { return double{at.x < 0.0 ? left : right}; });
}
// Such a step hides the left half of the hemisphere from the pixel beside it, whose centre is a 128th away.
inline constexpr std::size_t beside = 16 * 48 + 24;
inline constexpr double close = 0.5;  // height of that view

// A floor before a wall. With `box`, a box that slides along the wall.
inline scene::Scene floor_and_wall(bool box) {
    scene::Scene scene{.name = "test"};
    scene.mesh = scene::make_parallelogram({-4, 0, -1}, {0, 0, 5}, {8, 0, 0}, 0.5);
    append(scene.mesh, scene::make_parallelogram({-4, 0, -1}, {8, 0, 0}, {0, 4, 0}, 0.5));
    scene.camera = {.eye = {0, 1.2, 3}, .target = {0, 0.4, -1}, .near = 0.1, .far = 50};
    scene.ao_radius = 0.5;
    if (box)
        scene.objects.push_back({scene::make_box({-0.3, 0, -0.3}, {0.3, 0.6, 0.3}, 0.2), [](int frame) {
                                     glm::dmat4 move(1.0);
                                     move[3] = glm::dvec4(-0.5 + 0.05 * frame, 0.0, -0.5, 1.0);
                                     return move;
                                 }});
    return scene;
}

// What an engine stores, and how its camera projects.
struct Engine {
    const char* depth;
    const char* normals;
    bool reversed;
    double far;  // world units
    scene::Projection projection = scene::Projection::perspective;
    int depth_bits = 32;
    int normal_bits = 32;
    double before_near = 0.0;  // the eye is moved by this much towards what it sees
};
inline void PrintTo(const Engine& engine, std::ostream* out) {
    *out << engine.depth << ", normals " << engine.normals << (engine.reversed ? ", reversed" : "");
}
inline constexpr double endless = std::numeric_limits<double>::infinity();
inline constexpr Engine engines[] = {
    {"buffer", "view", false, 60.0},
    {"buffer", "world", true, 60.0},
    {"buffer", "view-unorm", false, endless, scene::Projection::perspective, 32, 10},
    {"buffer", "world-octahedral-unorm", true, endless, scene::Projection::perspective, 32, 10},
    {"buffer", "world-unorm", false, 60.0, scene::Projection::orthographic, 32, 10},
    {"buffer", "view-octahedral", true, 60.0, scene::Projection::orthographic},
    {"buffer", "view", true, 60.0, scene::Projection::orthographic, 32, 32, 3.0},
    {"buffer", "view", false, 60.0, scene::Projection::orthographic, 32, 32, 9.0},
    {"buffer", "view-unorm", false, 60.0, scene::Projection::perspective, 24, 10},
    {"buffer", "world-octahedral-unorm", false, 6.0, scene::Projection::perspective, 16, 10},
    {"buffer", "view-unorm", true, 6.0, scene::Projection::orthographic, 16, 10},
    {"linear", "view-octahedral-unorm", false, 60.0, scene::Projection::perspective, 32, 10}};

// What is stored, in so many bits, by a camera that may have things behind its eye.
inline void store(const Engine& engine, scene::GBuffer& view) {
    view.stored = scene::stored_inputs(view, scene::encoding_named(engine.depth, engine.normals));
    const auto round = [](float& value, int bits) {
        const double most = std::exp2(bits) - 1.0;
        if (bits < 32) value = static_cast<float>(std::round(value * most) / most);
    };
    for (float& depth : view.stored->depth) round(depth, engine.depth_bits);
    for (glm::vec3& normal : view.stored->normal)
        for (int i = 0; i < 3; ++i) round(normal[i], engine.normal_bits);
    view.camera.proj_vk[3][2] -= static_cast<float>(engine.before_near) * view.camera.proj_vk[2][2];
}

// Before such a camera.
inline scene::Scene seen_by(const Engine& engine) {
    scene::Scene scene = floor_and_wall(true);
    scene.camera.projection = engine.projection;
    scene.camera.reversed_z = engine.reversed;
    scene.camera.far = engine.far;
    scene.camera.view_height = 2.5;
    return scene;
}

}  // namespace gloam::effect
