// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"
#include "scene/rasterize.hpp"
#include "scene/scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::scenes_test {

void expect_sound(const Mesh& mesh) {
    ASSERT_GT(mesh.triangle_count(), 0U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
    // Each triangle winds counter-clockwise around its normals.
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        const glm::dvec3 b = mesh.positions[mesh.indices[i + 1]];
        const glm::dvec3 c = mesh.positions[mesh.indices[i + 2]];
        const glm::dvec3 area = glm::cross(b - a, c - a);
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_GE(glm::dot(area, glm::dvec3(mesh.normals[mesh.indices[i + k]])), -1e-9)
                << "triangle " << i / 3;
    }
}

double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.positions[mesh.indices[i]];
        area += 0.5 * glm::length(glm::cross(glm::dvec3(mesh.positions[mesh.indices[i + 1]]) - a,
                                             glm::dvec3(mesh.positions[mesh.indices[i + 2]]) - a));
    }
    return area;
}

TEST(Primitives, AreSoundAndOfTheRightArea) {
    const Mesh box = make_box({-1, 0, 2}, {1, 3, 4}, 0.7);
    const Mesh plane = make_parallelogram({0, 0, 0}, {2, 0, 0}, {1, 3, 0}, 0.5);
    const Mesh cylinder = make_cylinder({1, 2, 3}, 0.5, 4.0, 256);
    const Mesh sphere = make_sphere({1, 2, 3}, 0.5, 128, 256);
    for (const Mesh* mesh : {&box, &plane, &cylinder, &sphere}) expect_sound(*mesh);
    EXPECT_NEAR(area_of(box), 2 * (2 * 3 + 3 * 2 + 2 * 2), 1e-4);
    EXPECT_NEAR(area_of(plane), 6.0, 1e-5);
    EXPECT_NEAR(area_of(cylinder), 3.14159265 * 4.0, 2e-3);
    EXPECT_NEAR(area_of(sphere), 3.14159265, 2e-3);
}

TEST(Scenes, AreListedAndMade) {
    std::vector<std::string> names;
    for (const SceneInfo& info : built_in_scenes()) {
        EXPECT_FALSE(info.description.empty());
        const Scene scene = make_scene(info.name);
        EXPECT_EQ(scene.name, info.name);
        EXPECT_GT(scene.ao_radius, 0.0);
        expect_sound(scene.mesh);
        (void)make_frame(scene.camera, 1.5);
        names.push_back(info.name);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"columns", "corner", "far", "grass", "knot", "moving",
                                               "relief", "room", "sky"}));
    expect_error<std::invalid_argument>([] { (void)make_scene("colums"); }, {"colums", "columns", "corner"});
    expect_error<std::invalid_argument>([] { (void)make_scene(""); }, {"columns"});
}

TEST(Scenes, TheCornerIsExact) {
    for (const glm::vec3& p : make_scene("corner").mesh.positions)
        ASSERT_TRUE(p.x == 0.0F || p.y == 0.0F || p.z == 0.0F);
}

class BuiltInScenes : public gpu::test::GpuTest {
  protected:
    GBuffer shot(const std::string& name, gpu::Extent extent, int frame = 0) {
        return rasterize(device(), passes_, make_scene(name), extent,
                         {.frame = frame, .motion = true, .ids = true});
    }

  private:
    PassLibrary passes_{GLOAM_GLSL_DIR};
};

// FNV-1a of every float and index of a scene's meshes.
std::uint64_t hash_of(const Scene& scene) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    const auto add = [&](std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ (word >> shift & 0xFFU)) * 0x100000001b3U;
    };
    const auto add_mesh = [&](const Mesh& mesh) {
        for (const auto* vectors : {&mesh.positions, &mesh.normals})
            for (const glm::vec3& v : *vectors)
                for (int i = 0; i < 3; ++i) add(std::bit_cast<std::uint32_t>(v[i]));
        for (const std::uint32_t index : mesh.indices) add(index);
    };
    add_mesh(scene.mesh);
    for (const MovingObject& object : scene.objects) add_mesh(object.mesh);
    return hash;
}

double background_of(const GBuffer& view) {
    const auto count = std::ranges::count_if(view.depth, [](float d) { return std::isinf(d); });
    return static_cast<double>(count) / static_cast<double>(view.depth.size());
}

TEST_F(BuiltInScenes, AreTheSameEveryTime) {
    for (const SceneInfo& info : built_in_scenes()) {
        const Scene scene = make_scene(info.name);
        EXPECT_EQ(hash_of(scene), hash_of(make_scene(info.name))) << info.name;
        validate(scene);
    }
}

// Each is a function of the frame's number: no frame depends on which were asked for before, and the motion
// from one to the next is small.
TEST_F(BuiltInScenes, MoveSmoothly) {
    for (const SceneInfo& info : built_in_scenes()) {
        const Scene scene = make_scene(info.name);
        const Camera again = camera_at(scene, 5);
        for (int frame = 1; frame < 400; ++frame) {
            const Camera now = camera_at(scene, frame);
            (void)make_frame(now, 1.5, camera_at(scene, frame - 1));
            ASSERT_LT(glm::distance(now.eye, camera_at(scene, frame - 1).eye), 0.05) << info.name;
            for (const MovingObject& object : scene.objects) {
                const glm::dmat4 move = object.transform(frame);
                const glm::dmat3 turn(move);
                const glm::dmat3 square = glm::transpose(turn) * turn;
                for (int i = 0; i < 3; ++i) ASSERT_NEAR(square[i][i], 1.0, 1e-12) << info.name;
                ASSERT_NEAR(glm::determinant(turn), 1.0, 1e-12);
                ASSERT_LT(glm::distance(glm::dvec3(move[3]), glm::dvec3(object.transform(frame - 1)[3])),
                          0.1);
            }
        }
        EXPECT_EQ(camera_at(scene, 5).eye, again.eye);
    }
}

TEST_F(BuiltInScenes, ShowWhatTheyAreFor) {
    const GBuffer columns = shot("columns", {160, 90});
    EXPECT_LT(*std::ranges::min_element(columns.depth), 0.11F);
    EXPECT_GT(*std::ranges::max_element(columns.depth), 195.0F);
    EXPECT_GT(background_of(shot("sky", {160, 90})), 0.75);
    EXPECT_LT(background_of(shot("sky", {160, 90})), 0.97);
    for (const char* closed : {"room", "columns"}) EXPECT_EQ(background_of(shot(closed, {160, 90})), 0.0);
    for (const float d : shot("far", {32, 18}).depth) EXPECT_TRUE(d > 1.0F);
    EXPECT_GT(glm::length(make_scene("far").camera.eye), 1e5);
    for (const char* moving : {"moving", "sky", "far"}) {
        const GBuffer view = shot(moving, {160, 90}, 12);
        for (std::uint32_t object = 1; object <= make_scene(moving).objects.size(); ++object)
            EXPECT_GT(std::ranges::count(view.object, object), 3) << moving << " " << object;
    }
}

// Where a pixel was a frame ago, by its object's and the camera's own motion, calculated apart.
TEST_F(BuiltInScenes, MotionIsThatOfTheObject) {
    for (const char* name : {"moving", "far", "sky"}) {
        const Scene scene = make_scene(name);
        constexpr int frame = 20;
        const GBuffer view = shot(name, {96, 54}, frame);
        const Camera now = camera_at(scene, frame);
        const Camera before = camera_at(scene, frame - 1);
        int judged = 0;
        for (std::size_t i = 0; i < view.depth.size(); ++i) {
            if (std::isinf(view.depth[i])) {
                EXPECT_EQ(view.motion[i], glm::vec3(0));
                EXPECT_EQ(view.previous_position[i], glm::vec3(0));
                continue;
            }
            const glm::dvec2 size(96, 54);
            const glm::dvec2 pixel(static_cast<double>(i % 96) + 0.5, static_cast<double>(i / 96) + 0.5);
            const glm::dvec2 scale = view.camera.p00_p11();
            const double d = view.depth[i];
            const glm::dvec3 here((2.0 * pixel / size - 1.0) / scale * d, -d);
            glm::dvec3 world = now.eye + glm::transpose(view_rotation(now)) * here;
            if (view.object[i] > 0) {
                const auto& transform = scene.objects[view.object[i] - 1].transform;
                world = transform(frame - 1) * glm::inverse(transform(frame)) * glm::dvec4(world, 1.0);
            }
            const glm::dvec3 then = view_rotation(before) * (world - before.eye);
            ASSERT_LT(glm::distance(then, glm::dvec3(view.previous_position[i])), 1e-5 * d)
                << name << " " << i;
            const glm::dvec2 place = (0.5 * glm::dvec2(then) * scale / -then.z + 0.5) * size;
            ASSERT_LT(glm::distance(glm::dvec2(view.motion[i]), pixel - place), 2e-3) << name << " " << i;
            ++judged;
        }
        EXPECT_GT(judged, 300) << name;
    }
}

TEST_F(BuiltInScenes, TheFirstFrameHasNoHistory) {
    const GBuffer first = shot("moving", {32, 18});
    EXPECT_FALSE(first.camera.previous_view);
    EXPECT_FALSE(first.camera.previous_from_current);
    for (const glm::vec3& m : first.motion) EXPECT_EQ(m, glm::vec3(0));
    const GBuffer second = shot("moving", {32, 18}, 1);
    ASSERT_TRUE(second.camera.previous_view);
    EXPECT_EQ(*second.camera.previous_view, first.camera.view);
    EXPECT_TRUE(second.camera.previous_from_current);
}

// Drawn with the extras and without, the rest is the same to the bit.
TEST_F(BuiltInScenes, ExtrasChangeNothingElse) {
    PassLibrary passes(GLOAM_GLSL_DIR);
    const Scene scene = make_scene("moving");
    const GBuffer plain = rasterize(device(), passes, scene, {64, 36}, {.frame = 9});
    const GBuffer full = shot("moving", {64, 36}, 9);
    EXPECT_EQ(bits(plain.depth), bits(full.depth));
    EXPECT_EQ(plain.normal, full.normal);
    EXPECT_TRUE(plain.motion.empty() && plain.previous_position.empty() && plain.object.empty() &&
                plain.triangle.empty());
    const GBuffer ids = rasterize(device(), passes, scene, {64, 36}, {.frame = 9, .ids = true});
    EXPECT_EQ(ids.object, full.object);
    EXPECT_TRUE(ids.motion.empty());
}

// The triangle that a pixel names holds the pixel's surface.
TEST_F(BuiltInScenes, TrianglesAreThoseOfTheMesh) {
    const Scene scene = make_scene("moving");
    const GBuffer view = shot("moving", {64, 36}, 4);
    const Mesh mesh = view_space_mesh(scene, 4);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        ASSERT_LT(view.triangle[i], mesh.triangle_count());
        const std::uint32_t* corner = &mesh.indices[3 * std::size_t{view.triangle[i]}];
        const glm::dvec3 a = mesh.positions[corner[0]];
        const glm::dvec3 normal = glm::normalize(
            glm::cross(glm::dvec3(mesh.positions[corner[1]]) - a, glm::dvec3(mesh.positions[corner[2]]) - a));
        const glm::dvec2 ndc{(2.0 * static_cast<double>(i % 64) + 1.0) / 64.0 - 1.0,
                             (2.0 * static_cast<double>(i / 64) + 1.0) / 36.0 - 1.0};
        const double d = view.depth[i];
        const glm::dvec3 at(ndc / glm::dvec2(view.camera.p00_p11()) * d, -d);
        ASSERT_LT(std::abs(glm::dot(normal, at - a)), 1e-5 * d) << i;
    }
    const GBuffer sky = shot("sky", {64, 36});
    EXPECT_EQ(sky.triangle.front(), 0xFFFFFFFFU);
    EXPECT_EQ(sky.object.front(), 0U);
}

TEST_F(BuiltInScenes, FramesAndObjectsThatCannotBe) {
    PassLibrary passes(GLOAM_GLSL_DIR);
    Scene scene = make_scene("moving");
    expect_error<std::invalid_argument>(
        [&] { (void)rasterize(device(), passes, scene, {4, 4}, {.frame = -1}); }, {"frame -1", "moving"});
    scene.objects[1].mesh.indices[0] = 1'000'000;
    expect_error<std::invalid_argument>([&] { (void)rasterize(device(), passes, scene, {4, 4}); },
                                        {"moving, object 2", "index 1000000"});
    scene.objects[1].transform = nullptr;
    expect_error<std::invalid_argument>([&] { (void)rasterize(device(), passes, scene, {4, 4}); },
                                        {"object 2", "transform"});
}

TEST(RigidMotion, TurnsThenMoves) {
    const glm::dvec4 moved = rigid_motion({1, 2, 3}, std::acos(-1.0) / 2, {0, 1, 0}) * glm::dvec4(0, 0, 1, 1);
    EXPECT_LT(glm::distance(glm::dvec3(moved), glm::dvec3(2, 2, 3)), 1e-12);
}

std::size_t hidden(const Mesh& mesh, bool orthographic = false) {
    const std::vector<bool> triangles = hidden_far_sides(mesh, orthographic);
    return static_cast<std::size_t>(std::ranges::count(triangles, true));
}

// A box of 12 triangles, straight before the eye.
Mesh box(double near = -5.0) {
    return make_box({-1, -1, near - 2.0}, {1, 1, near}, 10.0);
}

TEST(ClosedParts, OnlyTheFrontOfABoxIsSeen) {
    EXPECT_EQ(hidden(box()), 10U);
    EXPECT_EQ(hidden(box(), true), 10U);
}

TEST(ClosedParts, FromWithinEverySideIsSeen) {
    EXPECT_EQ(hidden(box(1.0)), 0U);
}

TEST(ClosedParts, WhatIsOpenHasTwoSides) {
    EXPECT_EQ(hidden(make_parallelogram({-1, -1, -5}, {0, 2, 0}, {2, 0, 0}, 1.0)), 0U);
    Mesh without_a_triangle = box();
    without_a_triangle.indices.resize(without_a_triangle.indices.size() - 3);
    EXPECT_EQ(hidden(without_a_triangle), 0U);
}

TEST(ClosedParts, TrianglesThatFaceInwardAreSeen) {
    Mesh inward = box();
    for (std::size_t i = 0; i < inward.indices.size(); i += 3)
        std::swap(inward.indices[i], inward.indices[i + 1]);
    EXPECT_EQ(hidden(inward), 0U);
}

// Parts of one mesh are told apart by their positions.
TEST(ClosedParts, EachPartIsJudgedAlone) {
    Mesh mesh = make_parallelogram({-9, -2, -9}, {0, 0, 9}, {18, 0, 0}, 20.0);
    append(mesh, box());
    append(mesh, make_box({4, -1, -7}, {6, 1, -5}, 10.0));
    // Of the box to the right, the front and the left side are seen.
    EXPECT_EQ(hidden(mesh), 10U + 8U);
}

}  // namespace gloam::scene::test::scenes_test
