// SPDX-License-Identifier: MIT
#include "scene/draw.hpp"
#include "scene/mesh.hpp"
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
    for (const ViewInfo& info : built_in_scenes()) {
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

GBuffer shot(const std::string& name, gpu::Extent extent, int frame = 0) {
    return draw(make_scene(name), extent, {.frame = frame, .ids = true});
}

double background_of(const GBuffer& view) {
    const auto count = std::ranges::count_if(view.depth, [](float d) { return std::isinf(d); });
    return static_cast<double>(count) / static_cast<double>(view.depth.size());
}

// Each is a function of the frame's number: no frame depends on which were asked for before, and the motion
// from one to the next is small.
TEST(BuiltInScenes, MoveSmoothly) {
    for (const ViewInfo& info : built_in_scenes()) {
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

TEST(BuiltInScenes, ShowWhatTheyAreFor) {
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

TEST(RigidMotion, TurnsThenMoves) {
    const glm::dvec4 moved = rigid_motion({1, 2, 3}, std::acos(-1.0) / 2, {0, 1, 0}) * glm::dvec4(0, 0, 1, 1);
    EXPECT_LT(glm::distance(glm::dvec3(moved), glm::dvec3(2, 2, 3)), 1e-12);
}

}  // namespace gloam::scene::test::scenes_test
