// SPDX-License-Identifier: MIT
#include "scene/scene.hpp"

#include <algorithm>
#include <cmath>

#include "scene/primitives.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test {
namespace scene_test {

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

}  // namespace scene_test
}  // namespace gloam::scene::test
