// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"

#include <cmath>

#include "scene/support.hpp"

namespace gloam::scene::test {
namespace mesh_test {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(LoadMesh, TriangleWithAFlatNormal) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write("a.obj", triangle));
    EXPECT_EQ(mesh.triangle_count(), 1U);
    ASSERT_EQ(mesh.positions.size(), 3U);
    ASSERT_EQ(mesh.normals.size(), 3U);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(LoadMesh, PolygonsBecomeTriangles) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
    EXPECT_EQ(mesh.triangle_count(), 2U);
    EXPECT_EQ(mesh.positions.size(), 4U);  // the diagonal's ends are shared
}

// A roof of two faces at a right angle: the ridge's normals are the mean, the eaves' their face's.
TEST(LoadMesh, SmoothNormals) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write(
        "a.obj", "v 0 1 0\nv 0 1 1\nv -1 0 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\ns 1\nf 3 4 2 1\nf 1 2 6 5\n"));
    EXPECT_EQ(mesh.triangle_count(), 4U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float x = mesh.positions[i].x;
        const auto want = glm::normalize(glm::vec3(x, 1, 0));
        EXPECT_LT(glm::distance(mesh.normals[i], want), 1e-6F) << x;
    }
}

TEST(LoadMesh, LinesAreLeftOut) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write(
        "a.obj", std::string("v 9 9 9\nv 8 8 8\nl 1 2\n") + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n"));
    EXPECT_EQ(mesh.triangle_count(), 1U);
    EXPECT_EQ(mesh.positions.size(), 3U);
}

TEST(LoadMesh, DegenerateTrianglesHaveUnitNormals) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write("a.obj", std::string(triangle) + "v 5 5 5\nf 4 4 4\n"));
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
}

TEST(LoadMesh, Bunny) {
    const std::filesystem::path file = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "glmark2-data is not installed";
    const Mesh mesh = load_mesh(file);
    EXPECT_GT(mesh.triangle_count(), 1000U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_LT(mesh.positions.size(), mesh.triangle_count());  // vertices are shared
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
}

TEST(LoadMesh, Unreadable) {
    const Folder folder;
    const auto expect = [](const std::filesystem::path& file, std::initializer_list<const char*> parts) {
        expect_error<std::runtime_error>([&] { (void)load_mesh(file); }, parts);
    };
    expect(folder.path() / "none.obj", {"none.obj", "no such file"});
    expect(folder.path(), {folder.path().c_str(), "not a file"});
    expect(folder.write("empty.obj", ""), {"empty.obj"});
    expect(folder.write("a.unknown", "what"), {"a.unknown"});
    expect(folder.write("text.ply", "not a mesh\n"), {"text.ply"});
}

TEST(LoadMesh, WithoutATriangle) {
    const Folder folder;
    for (const char* text : {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\n"}) {
        const auto file = folder.write("points.obj", text);
        expect_error<std::runtime_error>([&] { (void)load_mesh(file); }, {"points.obj"});
    }
}

TEST(LoadMesh, VerticesThatAreNoNumbers) {
    const Folder folder;
    for (const char* bad : {"nan", "inf", "-inf", "1e39"}) {
        const auto file =
            folder.write("bad.obj", std::string("v 0 0 0\nv 1 ") + bad + " 0\nv 0 1 0\nf 1 2 3\n");
        expect_error<std::runtime_error>([&] { (void)load_mesh(file); }, {"bad.obj", "vertex 1", "finite"});
    }
}

TEST(Mesh, BoundsAppendPlaced) {
    Mesh mesh{
        .positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, .normals = {3, {0, 0, 1}}, .indices = {0, 1, 2}};
    append(mesh, placed(mesh, 2.0, {1, 1, -5}));
    EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(mesh.positions[5], glm::vec3(1, 5, -5));
    const Bounds bounds = bounds_of(mesh);
    EXPECT_EQ(bounds.low, glm::dvec3(0, 0, -5));
    EXPECT_EQ(bounds.high, glm::dvec3(3, 5, 0));
    EXPECT_THROW((void)bounds_of({}), std::invalid_argument);
}

}  // namespace mesh_test
}  // namespace gloam::scene::test
