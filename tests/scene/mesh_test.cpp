// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "scene/mesh.hpp"
#include "scene/mesh_scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::mesh_test {

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

using LoadMesh = InFolder;

TEST_F(LoadMesh, TriangleWithAFlatNormal) {
    const Mesh mesh = load_mesh(folder.write("a.obj", triangle));
    EXPECT_EQ(mesh.triangle_count(), 1U);
    ASSERT_EQ(mesh.positions.size(), 3U);
    ASSERT_EQ(mesh.normals.size(), 3U);
    for (const glm::vec3& normal : mesh.normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST_F(LoadMesh, PolygonsBecomeTriangles) {
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
TEST_F(LoadMesh, SmoothNormalsWhereFacesMeetAtASmallAngle) {
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
TEST_F(LoadMesh, FacesThatMeetAtALargeAngleKeepTheirOwnNormals) {
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

TEST_F(LoadMesh, ACubeHasFlatFacesInEveryFormat) {
    constexpr std::array<CubeFile, 3> formats{
        {{"a.obj", "", "v", "f", 1},
         {"a.off", "OFF\n8 6 0\n", "", "4", 0},
         {"a.ply",
          "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
          "element face 6\nproperty list uchar int vertex_indices\nend_header\n",
          "", "4", 0}}};
    for (const CubeFile& format : formats) {
        const TemporaryDirectory folder;
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

TEST_F(LoadMesh, LinesAreLeftOut) {
    const Mesh mesh = load_mesh(folder.write(
        "a.obj", std::string("v 9 9 9\nv 8 8 8\nl 1 2\n") + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 3 4 5\n"));
    EXPECT_EQ(mesh.triangle_count(), 1U);
    EXPECT_EQ(mesh.positions.size(), 3U);
}

TEST_F(LoadMesh, DegenerateTrianglesHaveUnitNormals) {
    const Mesh mesh = load_mesh(folder.write("a.obj", std::string(triangle) + "v 5 5 5\nf 4 4 4\n"));
    for (const glm::vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0F, 1e-6F);
}

TEST_F(LoadMesh, Bunny) {
    const std::filesystem::path file = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "glmark2-data is not installed";
    const Mesh mesh = load_mesh(file);
    EXPECT_GT(mesh.triangle_count(), 1000U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_LT(mesh.positions.size(), mesh.triangle_count());  // vertices are shared
    for (const glm::vec3& normal : mesh.normals) ASSERT_NEAR(glm::length(normal), 1.0F, 1e-5F);
    for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.positions.size());
}

TEST_F(LoadMesh, Unreadable) {
    const auto expect = [](const std::filesystem::path& file, std::initializer_list<std::string> parts) {
        expect_error<std::runtime_error>([&] { (void)load_mesh(file); }, parts);
    };
    expect(folder.path() / "none.obj", {"none.obj", "no such file"});
    expect(folder.path(), {folder.path().c_str(), "not a file"});
    expect(folder.write("empty.obj", ""), {"empty.obj"});
    expect(folder.write("a.unknown", "what"), {"a.unknown"});
    expect(folder.write("text.ply", "not a mesh\n"), {"text.ply"});
}

TEST_F(LoadMesh, WithoutATriangle) {
    for (const char* text : {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 0 0\nl 1 2\n"}) {
        const auto file = folder.write("points.obj", text);
        expect_error<std::runtime_error>([&] { (void)load_mesh(file); }, {"points.obj"});
    }
}

TEST_F(LoadMesh, VerticesThatAreNoNumbers) {
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
            const Bounds bounds = bounds_of(stood(scene, vertices));
            const double height = high.y - low.y;
            EXPECT_NEAR(bounds.low.y / height, 0.0, 1e-5);
            EXPECT_NEAR(bounds.high.y / height, 1.0, 1e-5);
            EXPECT_NEAR(bounds.low.x / height, -bounds.high.x / height, 1e-4);
            EXPECT_NEAR(scene.ao_radius / height, 0.2, 1e-5);
            EXPECT_NEAR(expect_seen(scene, vertices, 0, aspect), 0.84, 1e-3) << aspect;
            // The ground.
            ASSERT_GT(scene.mesh.positions.size(), vertices);
            for (std::size_t i = vertices; i < scene.mesh.positions.size(); ++i)
                ASSERT_EQ(scene.mesh.positions[i].y, 0.0F);
        }
    }
}

TEST(MeshScene, AFlatMeshIsMeasuredByItsLongestSide) {
    const Mesh sheet = make_parallelogram({0, 3, 0}, {0, 0, 4}, {2, 0, 0}, 10.0);
    const Scene scene = mesh_scene(sheet, "sheet");
    EXPECT_NEAR(scene.ao_radius, 0.2 * 4, 1e-6);
    EXPECT_NEAR(bounds_of(standing(sheet, {0, 1, 0}, 1.0)).high.z, 0.5, 1e-6);
    expect_seen(scene, sheet.positions.size(), 0, 1.0);
}

// A box of 1 x 2 x 3 is as high as the side along the axis that points up.
TEST(MeshScene, UpIsAnAxisOfTheFile) {
    const Mesh box = make_box({0, 0, 0}, {1, 2, 3}, 10.0);
    const std::vector<std::pair<const char*, double>> heights{{"x", 1},  {"y", 2},  {"z", 3},
                                                              {"-x", 1}, {"-y", 2}, {"-z", 3}};
    for (const auto& [name, height] : heights) {
        const auto up = axis_named(name);
        ASSERT_TRUE(up) << name;
        const Scene scene = mesh_scene(box, "box", {.up = *up, .ground = false});
        const Bounds bounds = bounds_of(scene.mesh);
        const glm::dvec3 size = bounds.high - bounds.low;
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

TEST(MeshScene, AnEyeOfOnesOwn) {
    const Mesh box = make_box({0, 0, 0}, {1, 1, 1}, 10.0);
    const Scene scene =
        mesh_scene(box, "box", {.eye = glm::dvec3(0, 0.5, 4), .look_at = glm::dvec3(0, 0.5, 0)});
    EXPECT_NEAR(glm::distance(scene.camera.eye, glm::dvec3(0, 0.5, 4)), 0.0, 1e-9);
    EXPECT_EQ(scene.camera.target, glm::dvec3(0, 0.5, 0));
    // A wider view is nearer.
    const Scene wide = mesh_scene(box, "box", {.fovy_deg = 90.0});
    EXPECT_NEAR(wide.camera.fovy_rad, 0.5 * std::numbers::pi, 1e-9);
    EXPECT_NEAR(expect_seen(wide, box.positions.size(), 0, 1.0), 0.84, 1e-3);
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
    for (const double angle : {0.0, 180.0, std::nan("")}) refused({.fovy_deg = angle}, "angle of view");
    refused({.eye = glm::dvec3(0, 1, 0), .look_at = glm::dvec3(0, 1, 0)}, "eye");
    refused({.aspect = 0.0}, "aspect");
}

}  // namespace gloam::scene::test::mesh_test
