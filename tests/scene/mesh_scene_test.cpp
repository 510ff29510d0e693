// SPDX-License-Identifier: MIT
#include "scene/mesh_scene.hpp"

#include <algorithm>
#include <cmath>

#include "scene/primitives.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace mesh_scene_test {

// The mesh alone, without the ground.
Mesh stood(const Scene& scene, std::size_t vertices) {
    Mesh mesh = scene.mesh;
    mesh.positions.resize(vertices);
    return mesh;
}

// All of the mesh is inside the view of a frame; the largest part of half an image's side that it reaches.
double expect_seen(const Scene& scene, std::size_t vertices, int frame, double aspect) {
    const CameraFrame camera = make_frame(camera_at(scene, frame), aspect);
    const glm::dmat4 clip_of = glm::dmat4(camera.proj_vk) * glm::dmat4(camera.view);
    double reach = 0.0;
    for (std::size_t i = 0; i < vertices; ++i) {
        const glm::dvec4 clip = clip_of * glm::dvec4(glm::dvec3(scene.mesh.positions[i]), 1.0);
        EXPECT_GT(clip.z, 0.0);
        EXPECT_LT(clip.z, clip.w);
        reach = std::max({reach, std::abs(clip.x) / clip.w, std::abs(clip.y) / clip.w});
    }
    EXPECT_LE(reach, 1.0);
    return reach;
}

TEST(MeshScene, HasHeightOneAndFillsTheImage) {
    // Tall, wide, far from the origin, tiny, huge.
    for (const auto& [low, high] :
         std::vector<std::pair<glm::dvec3, glm::dvec3>>{{{0, 0, 0}, {1, 9, 1}},
                                                        {{0, 0, 0}, {9, 1, 2}},
                                                        {{1000, -1000, 500}, {1003, -998, 502}},
                                                        {{0, 0, 0}, {1e-6, 2e-6, 1e-6}},
                                                        {{-1e9, -1e9, 0}, {1e9, 1e9, 1e9}}}) {
        const Mesh box = make_box(low, high, 1e10);
        const std::size_t vertices = box.positions.size();
        for (const double aspect : {0.5, 1.0, 1.5, 2.5}) {
            const Scene scene = mesh_scene(box, "box", {.aspect = aspect});
            const Bounds bounds = bounds_of(stood(scene, vertices));
            EXPECT_NEAR(bounds.low.y, 0.0, 1e-5);
            EXPECT_NEAR(bounds.high.y, 1.0, 1e-5);
            EXPECT_NEAR(bounds.low.x, -bounds.high.x, 1e-4);
            EXPECT_NEAR(expect_seen(scene, vertices, 0, aspect), 0.84, 1e-3) << aspect;
            // The ground.
            ASSERT_GT(scene.mesh.positions.size(), vertices);
            for (std::size_t i = vertices; i < scene.mesh.positions.size(); ++i)
                ASSERT_EQ(scene.mesh.positions[i].y, 0.0F);
        }
    }
}

TEST(MeshScene, AFlatMeshIsScaledByItsLongestSide) {
    const Mesh sheet = make_parallelogram({0, 3, 0}, {0, 0, 4}, {2, 0, 0}, 10.0);
    const Scene scene = mesh_scene(sheet, "sheet");
    EXPECT_NEAR(bounds_of(stood(scene, sheet.positions.size())).high.z, 0.5, 1e-6);
    expect_seen(scene, sheet.positions.size(), 0, 1.0);
}

// A box of 1 x 2 x 3 becomes as high as the side along the axis that points up.
TEST(MeshScene, UpIsAnAxisOfTheFile) {
    const Mesh box = make_box({0, 0, 0}, {1, 2, 3}, 10.0);
    const std::vector<std::pair<const char*, double>> heights{{"x", 1},  {"y", 2},  {"z", 3},
                                                              {"-x", 1}, {"-y", 2}, {"-z", 3}};
    for (const auto& [name, height] : heights) {
        const auto up = axis_named(name);
        ASSERT_TRUE(up) << name;
        const Scene scene = mesh_scene(box, "box", {.up = *up, .ground = false});
        const Bounds bounds = bounds_of(scene.mesh);
        const glm::dvec3 size = (bounds.high - bounds.low) * height;
        EXPECT_NEAR(size.y, height, 1e-5) << name;
        EXPECT_NEAR(size.x * size.y * size.z, 6.0, 1e-4) << name;
        for (std::size_t i = 0; i < scene.mesh.indices.size(); i += 3) {  // not mirrored
            const glm::dvec3 a = scene.mesh.positions[scene.mesh.indices[i]];
            const glm::dvec3 b = scene.mesh.positions[scene.mesh.indices[i + 1]];
            const glm::dvec3 c = scene.mesh.positions[scene.mesh.indices[i + 2]];
            ASSERT_GT(
                glm::dot(glm::cross(b - a, c - a), glm::dvec3(scene.mesh.normals[scene.mesh.indices[i]])),
                0.0)
                << name;
        }
    }
    // The end of +z comes to the top.
    const Mesh wedge{
        .positions = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, .normals = {3, {0, 0, 1}}, .indices = {0, 1, 2}};
    const Scene scene = mesh_scene(wedge, "wedge", {.up = {0, 0, 1}, .ground = false});
    EXPECT_NEAR(scene.mesh.positions[0].y, 1.0, 1e-6);
    for (const char* name : {"", "w", "+x", "--x", "xy", "X"}) EXPECT_FALSE(axis_named(name)) << name;
}

TEST(MeshScene, ATurntableGoesAroundAndSeesAll) {
    const Mesh box = make_box({0, 0, 0}, {9, 1, 1}, 10.0);
    constexpr int frames = 8;
    const Scene scene = mesh_scene(box, "box", {.turntable = frames, .aspect = 1.5});
    double reach = 0.0;
    glm::dvec3 sum(0.0);
    for (int frame = 0; frame < frames; ++frame) {
        reach = std::max(reach, expect_seen(scene, box.positions.size(), frame, 1.5));
        const Camera camera = camera_at(scene, frame);
        EXPECT_NEAR(glm::distance(camera.eye, camera.target),
                    glm::distance(scene.camera.eye, scene.camera.target), 1e-9);
        sum += camera.eye - camera.target;
    }
    EXPECT_NEAR(reach, 0.84, 1e-3);
    EXPECT_NEAR(sum.x, 0.0, 1e-9);
    EXPECT_NEAR(sum.z, 0.0, 1e-9);
}

TEST(MeshScene, AnEyeOfOnesOwn) {
    const Mesh box = make_box({0, 0, 0}, {1, 1, 1}, 10.0);
    const Scene scene =
        mesh_scene(box, "box", {.eye = glm::dvec3(0, 0.5, 4), .look_at = glm::dvec3(0, 0.5, 0)});
    EXPECT_NEAR(glm::distance(scene.camera.eye, glm::dvec3(0, 0.5, 4)), 0.0, 1e-9);
    EXPECT_EQ(scene.camera.target, glm::dvec3(0, 0.5, 0));
}

TEST(MeshScene, RefusesWhatCannotBe) {
    const Mesh point{.positions = {3, {1, 1, 1}}, .normals = {3, {0, 1, 0}}, .indices = {0, 1, 2}};
    expect_error<std::invalid_argument>([&] { (void)mesh_scene(point, "dot"); }, {"dot"});
    const Mesh box = make_box({0, 0, 0}, {1, 1, 1}, 10.0);
    const auto refused = [&](const MeshView& view, const char* what) {
        expect_error<std::invalid_argument>([&] { (void)mesh_scene(box, "box", view); }, {what});
    };
    refused({.elevation_deg = 90.0}, "elevation");
    refused({.elevation_deg = std::nan("")}, "elevation");
    refused({.azimuth_deg = INFINITY}, "azimuth");
    refused({.turntable = -1}, "turntable");
    refused({.eye = glm::dvec3(0, 1, 0), .look_at = glm::dvec3(0, 1, 0)}, "eye");
    refused({.aspect = 0.0}, "aspect");
}

}  // namespace mesh_scene_test
}  // namespace gloam::scene::test
