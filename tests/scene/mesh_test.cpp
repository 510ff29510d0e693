// SPDX-License-Identifier: MIT
#include "scene/mesh.hpp"

#include <fmt/format.h>

#include <array>
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

// A roof of two faces whose slopes meet at twice the angle whose tangent is `slope`.
std::string roof(double slope) {
    return fmt::format("v 0 {0} 0\nv 0 {0} 1\nv -1 0 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\nf 3 4 2 1\nf 1 2 6 5\n",
                       slope);
}

// At 23 degrees: the ridge's normals are the mean, the eaves' their face's.
TEST(LoadMesh, SmoothNormalsWhereFacesMeetAtASmallAngle) {
    const Folder folder;
    constexpr float slope = 0.2F;
    const Mesh mesh = load_mesh(folder.write("a.obj", roof(slope)));
    EXPECT_EQ(mesh.triangle_count(), 4U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const float x = mesh.positions[i].x;
        const auto want = glm::normalize(glm::vec3(x * slope, 1, 0));
        EXPECT_LT(glm::distance(mesh.normals[i], want), 1e-6F) << x;
    }
}

// At 90 degrees: each face keeps its own, so that the ridge is an edge.
TEST(LoadMesh, FacesThatMeetAtALargeAngleKeepTheirOwnNormals) {
    const Folder folder;
    const Mesh mesh = load_mesh(folder.write("a.obj", roof(1.0)));
    EXPECT_EQ(mesh.positions.size(), 8U);
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(std::abs(normal.x), std::sqrt(0.5F), 1e-6F);
}

// The corners of a cube, and its faces from outside, in the formats whose faces share their vertices.
struct CubeFile {
    const char* name;
    const char* head;
    const char* vertex;
    const char* face;
    int first;
};

std::string cube(const CubeFile& format) {
    std::string text = format.head;
    for (int corner = 0; corner < 8; ++corner)
        text += fmt::format("{} {} {} {}\n", format.vertex, corner & 1, corner >> 1 & 1, corner >> 2);
    constexpr std::array<std::array<int, 4>, 6> faces{
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
    for (const auto& f : faces) {
        text += fmt::format("{} {} {} {} {}\n", format.face, f[0] + format.first, f[1] + format.first,
                            f[2] + format.first, f[3] + format.first);
    }
    return text;
}

TEST(LoadMesh, ACubeHasFlatFacesInEveryFormat) {
    constexpr std::array<CubeFile, 3> formats{
        {{"a.obj", "", "v", "f", 1},
         {"a.off", "OFF\n8 6 0\n", "", "4", 0},
         {"a.ply",
          "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 6\nproperty list uchar int vertex_indices\nend_header\n",
          "", "4", 0}}};
    for (const CubeFile& format : formats) {
        const Folder folder;
        const Mesh mesh = load_mesh(folder.write(format.name, cube(format)));
        EXPECT_EQ(mesh.triangle_count(), 12U) << format.name;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const std::uint32_t* corner = &mesh.indices[i];
            const glm::vec3 origin = mesh.positions[corner[0]];
            const glm::vec3 face = glm::normalize(
                glm::cross(mesh.positions[corner[1]] - origin, mesh.positions[corner[2]] - origin));
            for (int k = 0; k < 3; ++k)
                EXPECT_LT(glm::distance(mesh.normals[corner[k]], face), 1e-6F) << format.name << " " << i;
        }
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
