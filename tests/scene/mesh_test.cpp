// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "scene/mesh_scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::mesh_test {

using ReadMesh = InFolder;

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

// A roof of two faces whose slopes meet at twice the angle whose tangent is `slope`.
std::string roof(double slope) {
    return fmt::format("v 0 {0} 0\nv 0 {0} 1\nv -1 0 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\nf 3 4 2 1\nf 1 2 6 5\n",
                       slope);
}

// Faces that meet at 90 degrees keep their own normals. Polygons become triangles with a common diagonal,
// lines are left out.
TEST_F(ReadMesh, FlatFaces) {
    struct Row {
        const char* name;
        std::string text;
        std::size_t triangles;
        std::size_t vertices;
    };
    const char* off = "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 1 2 3\n3 0 3 4\n";
    for (const auto& [name, text, triangles, vertices] :
         {Row{"triangle.obj", triangle, 1, 3}, Row{"faces.off", off, 3, 7},
          Row{"line.obj", "v 9 9 9\nv 8 8 8\nl 1 2\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n", 1, 3},
          Row{"roof.obj", roof(1.0), 4, 8}}) {
        SCOPED_TRACE(name);
        const Mesh mesh = read_mesh(folder.write(name, text));
        EXPECT_EQ(mesh.triangle_count(), triangles);
        EXPECT_EQ(mesh.positions.size(), vertices);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i)
            EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[mesh.indices[i]]),
                                    glm::normalize(area_of(mesh, i / 3))),
                      1e-6);
    }
}

// At 23 degrees: the ridge's normals are the mean, the eaves' their face's.
TEST_F(ReadMesh, SmoothNormalsWhereFacesMeetAtASmallAngle) {
    constexpr float slope = 0.2F;
    const Mesh mesh = read_mesh(folder.write("a.obj", roof(slope)));
    EXPECT_EQ(mesh.triangle_count(), 4U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float x = mesh.positions[i].x;
        EXPECT_LT(glm::distance(mesh.normals[i], glm::normalize(glm::vec3(x * slope, 1, 0))), 1e-6F) << x;
    }
}

TEST_F(ReadMesh, DegenerateTrianglesHaveUnitNormals) {
    const Mesh mesh = read_mesh(folder.write("a.obj", triangle + "v 5 5 5\nf 4 4 4\n"));
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
}

// tests/tools/stories has files that are no meshes.
TEST_F(ReadMesh, Unreadable) {
    for (const auto& [name, text, why] :
         {std::tuple{"points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no triangle"},
          {"lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", "no triangle"},
          {"large.obj", "v 0 0 0\nv 1 1e39 0\nv 0 1 0\nf 1 2 3\n",
           "vertex 1 is (1, inf, 0), expected finite"}})
        expect_error<std::runtime_error>([&] { (void)read_mesh(folder.write(name, text)); }, {name, why});
}

// All of the first vertices are inside the view; the largest part of half an image's side that they reach.
double expect_seen(const Scene& scene, std::size_t vertices, double aspect) {
    const CameraFrame camera = make_frame(scene.camera, aspect);
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

TEST(MeshScene, KeepsItsUnitsAndFillsTheImage) {
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
            Mesh stood = scene.mesh;
            stood.positions.resize(vertices);  // without the ground
            const Bounds bounds = bounds_of(stood);
            const double height = high.y - low.y;
            EXPECT_NEAR(bounds.low.y / height, 0.0, 1e-5);
            EXPECT_NEAR(bounds.high.y / height, 1.0, 1e-5);
            EXPECT_NEAR(bounds.low.x / height, -bounds.high.x / height, 1e-4);
            EXPECT_NEAR(scene.ao_radius / height, 0.2, 1e-5);
            EXPECT_NEAR(expect_seen(scene, vertices, aspect), 0.84, 1e-3) << aspect;
            ASSERT_GT(scene.mesh.positions.size(), vertices);
            for (std::size_t i = vertices; i < scene.mesh.positions.size(); ++i)
                ASSERT_EQ(scene.mesh.positions[i].y, 0.0F);
        }
    }
}

// A box of 1 x 2 x 3 is as high as the side along the axis that points up, whose end comes to the top, and
// not mirrored.
TEST(MeshScene, UpIsAnAxisOfTheFile) {
    const Mesh box = make_box({0, 0, 0}, {1, 2, 3}, 10.0);
    for (const auto& [name, height] :
         {std::pair{"x", 1}, {"y", 2}, {"z", 3}, {"-x", 1}, {"-y", 2}, {"-z", 3}}) {
        SCOPED_TRACE(name);
        const auto up = axis_named(name);
        ASSERT_TRUE(up);
        const Scene scene = mesh_scene(box, "box", {.up = *up, .ground = false});
        const Bounds bounds = bounds_of(scene.mesh);
        const glm::dvec3 size = bounds.high - bounds.low;
        EXPECT_NEAR(size.y, height, 1e-5);
        EXPECT_NEAR(size.x * size.y * size.z, 6.0, 1e-4);
        expect_whole(scene.mesh);
        for (std::size_t i = 0; i < box.positions.size(); ++i) {
            const double along = glm::dot(glm::dvec3(box.positions[i]), *up) + (*name == '-' ? height : 0);
            EXPECT_NEAR(scene.mesh.positions[i].y, along, 1e-5);
        }
    }
    for (const char* name : {"", "w", "+x", "--x", "xy", "X"}) EXPECT_FALSE(axis_named(name)) << name;
}

// A flat mesh is measured by its longest side, a wider view is nearer, and an eye may be one's own.
TEST(MeshScene, OfOnesOwn) {
    const Mesh sheet = make_parallelogram({0, 3, 0}, {0, 0, 4}, {2, 0, 0}, 10.0);
    const Scene flat = mesh_scene(sheet, "sheet");
    EXPECT_NEAR(flat.ao_radius, 0.2 * 4, 1e-6);
    EXPECT_NEAR(bounds_of(standing(sheet, {0, 1, 0}, 1.0)).high.z, 0.5, 1e-6);
    expect_seen(flat, sheet.positions.size(), 1.0);
    const Mesh box = make_box({0, 0, 0}, {1, 1, 1}, 10.0);
    const Scene wide = mesh_scene(box, "box", {.fovy_deg = 90.0});
    EXPECT_NEAR(wide.camera.fovy_rad, 0.5 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(expect_seen(wide, box.positions.size(), 1.0), 0.84, 1e-3);
    const Scene own =
        mesh_scene(box, "box", {.eye = glm::dvec3(0, 0.5, 4), .look_at = glm::dvec3(0, 0.5, 0)});
    EXPECT_NEAR(glm::distance(own.camera.eye, glm::dvec3(0, 0.5, 4)), 0.0, 1e-9);
    EXPECT_EQ(own.camera.target, glm::dvec3(0, 0.5, 0));
}

}  // namespace gloam::scene::test::mesh_test
