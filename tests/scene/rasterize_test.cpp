// SPDX-License-Identifier: MIT
#include "scene/rasterize.hpp"
#include "scene/internal/peel.hpp"
#include "scene/mesh.hpp"
#include "scene/support.hpp"
#include "support/laid_out.hpp"

namespace gloam::scene::test::rasterize_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Variant {
    const char* name;
    Projection projection;
    double far;
    bool reversed_z;
};

const std::vector<Variant> variants{
    {"perspective", Projection::perspective, 100.0, false},
    {"perspective, reversed", Projection::perspective, 100.0, true},
    {"perspective, infinite", Projection::perspective, infinity, false},
    {"perspective, infinite, reversed", Projection::perspective, infinity, true},
    {"orthographic", Projection::orthographic, 100.0, false},
    {"orthographic, reversed", Projection::orthographic, 100.0, true},
};

Camera with(Camera camera, const Variant& variant) {
    camera.projection = variant.projection;
    camera.far = variant.far;
    camera.reversed_z = variant.reversed_z;
    return camera;
}

// View-space position under the centre of a pixel, in double.
glm::dvec3 position_of(const GBuffer& g, std::size_t pixel) {
    const glm::dmat4 projection(g.camera.proj_vk);
    const double x = (2.0 * static_cast<double>(pixel % g.extent.width) + 1.0) / g.extent.width - 1.0;
    const double y = (2.0 * static_cast<double>(pixel / g.extent.width) + 1.0) / g.extent.height - 1.0;
    const double d = g.depth[pixel];
    const double scale = g.camera.orthographic() ? 1.0 : d;
    return {scale * x / projection[0][0], scale * y / projection[1][1], -d};
}

class RasterizeTest : public SceneTest {
  protected:
    GBuffer shot(const Scene& scene, gpu::Extent extent) {
        return rasterize(device(), passes_, scene, extent);
    }
};

// Relative error of the depth d for standard z, the others do better: a depth-buffer value near 1 is rounded
// by 2^-24 at most in the projection's element, the vertices' clip z, the interpolation, and when stored; d
// is d / near times as sensitive.
double depth_tolerance(double d, double near) {
    return 3e-7 + 4.0 * 0x1p-24 * d / near;
}

TEST_F(RasterizeTest, APlaneFacingTheCamera) {
    for (const Variant& variant : variants) {
        SCOPED_TRACE(variant.name);
        for (const float side : {1.0F, -1.0F}) {  // normals on either side are turned to the viewer
            Scene scene{.name = "plane",
                        .mesh = make_parallelogram({-50, -50, -5}, {100, 0, 0}, {0, 100, 0}, 5.0)};
            for (glm::vec3& normal : scene.mesh.normals) normal *= side;
            scene.camera = with({}, variant);
            scene.ao_radius = 0.75;
            const GBuffer g = shot(scene, {17, 9});
            ASSERT_EQ(g.extent, (gpu::Extent{17, 9}));
            ASSERT_EQ(g.depth.size(), 17U * 9U);
            ASSERT_EQ(g.normal.size(), 17U * 9U);
            EXPECT_TRUE(g.motion.empty());
            EXPECT_EQ(g.ao_radius, 0.75);
            for (const float d : g.depth) EXPECT_NEAR(d, 5.0, 5.0 * 1e-5);
            for (const glm::vec3& n : g.normal) EXPECT_LT(glm::distance(n, {0, 0, 1}), 1e-6F);
        }
    }
}

// The rows of a floor below the eye: those below the horizon have d = h p11 / ndc_y, those above nothing. It
// reaches behind the camera, so near triangles are clipped.
TEST_F(RasterizeTest, AFloorThroughTheNearPlane) {
    for (const Variant& variant : variants) {
        if (variant.projection == Projection::orthographic) continue;
        SCOPED_TRACE(variant.name);
        Scene scene{.name = "floor",
                    .mesh = make_parallelogram({-90, -1, 30}, {180, 0, 0}, {0, 0, -90}, 7.0)};
        scene.camera = with({.near = 0.1}, variant);
        const GBuffer g = shot(scene, {16, 32});
        for (std::size_t pixel = 0; pixel < g.depth.size(); ++pixel) {
            const double y = (2.0 * static_cast<double>(pixel / 16) + 1.0) / 32.0 - 1.0;
            const double want = y > 0.0 ? -g.camera.p00_p11().y / y : infinity;
            if (want > 60.0) {
                EXPECT_EQ(g.depth[pixel], static_cast<float>(infinity));
                EXPECT_EQ(g.normal[pixel], glm::vec3(0));
            } else {
                EXPECT_NEAR(g.depth[pixel] / want, 1.0, depth_tolerance(want, 0.1)) << pixel;
                EXPECT_LT(glm::distance(g.normal[pixel], {0, 1, 0}), 1e-6F);
            }
        }
    }
}

struct CornerErrors {
    double position = 0.0;  // distance from the nearest plane over the depth
    double normal = 0.0;    // from the plane's normal
    double farthest = 0.0;
    std::array<int, 3> seen{};  // pixels of the planes x, y, z = 0
};

CornerErrors corner_errors(const GBuffer& g) {
    CornerErrors errors;
    const glm::dmat4 world_of_view = glm::inverse(glm::dmat4(g.camera.view));
    for (std::size_t pixel = 0; pixel < g.depth.size(); ++pixel) {
        const glm::dvec3 world = world_of_view * glm::dvec4(position_of(g, pixel), 1.0);
        const glm::dvec3 normal = glm::dmat3(world_of_view) * glm::dvec3(g.normal[pixel]);
        // The plane by the normal: near the edges the nearest plane is another.
        const int axis = normal.x > 0.5 ? 0 : (normal.y > 0.5 ? 1 : 2);
        glm::dvec3 want(0.0);
        want[axis] = 1.0;
        const double d = g.depth[pixel];
        errors.position = std::max(errors.position, std::abs(world[axis]) / d);
        errors.normal = std::max(errors.normal, glm::distance(normal, want));
        errors.farthest = std::max(errors.farthest, d);
        ++errors.seen[static_cast<std::size_t>(axis)];
    }
    return errors;
}

TEST_F(RasterizeTest, TheCornersPointsLieOnItsPlanes) {
    for (const Variant& variant : variants) {
        for (const gpu::Extent extent : {gpu::Extent{192, 108}, gpu::Extent{33, 47}}) {
            Scene scene = make_scene("corner");
            scene.camera = with(scene.camera, variant);
            const GBuffer g = shot(scene, extent);
            const CornerErrors errors = corner_errors(g);
            std::printf("%-32s %3ux%-3u position %.2e of the depth, normal %.2e\n", variant.name,
                        extent.width, extent.height, errors.position, errors.normal);
            EXPECT_LE(errors.position, depth_tolerance(errors.farthest, scene.camera.near)) << variant.name;
            EXPECT_LE(errors.normal, 1e-6) << variant.name;
            for (const int seen : errors.seen) EXPECT_GT(seen, 100) << variant.name;
        }
    }
}

TEST_F(RasterizeTest, OnePixelAndOddSizes) {
    const Scene scene = make_scene("corner");
    for (const gpu::Extent extent :
         {gpu::Extent{1, 1}, gpu::Extent{1, 7}, gpu::Extent{9, 1}, gpu::Extent{13, 5}}) {
        const GBuffer g = shot(scene, extent);
        EXPECT_EQ(g.depth.size(), std::size_t{extent.width} * extent.height);
        const CornerErrors errors = corner_errors(g);
        EXPECT_LE(errors.position, 1e-5);
        EXPECT_LE(errors.normal, 1e-6);
    }
}

// Smooth normals at the rim of a coarse sphere tip away from the viewer; none may be handed on like that.
TEST_F(RasterizeTest, NormalsFaceTheViewer) {
    for (const Variant& variant : variants) {
        Scene scene{.name = "sphere", .mesh = make_sphere({0, 0, 0}, 1.0, 6, 10)};
        scene.camera = with({.eye = {0.5, 1, 3}, .target = {0, 0, 0}, .view_height = 2.4}, variant);
        const GBuffer g = shot(scene, {64, 64});
        int covered = 0;
        for (std::size_t pixel = 0; pixel < g.depth.size(); ++pixel) {
            if (std::isinf(g.depth[pixel])) {
                EXPECT_EQ(g.normal[pixel], glm::vec3(0));
                continue;
            }
            ++covered;
            const glm::dvec3 n = g.normal[pixel];
            const glm::dvec3 away =
                g.camera.orthographic() ? glm::dvec3(0, 0, -1) : glm::normalize(position_of(g, pixel));
            ASSERT_NEAR(glm::length(n), 1.0, 1e-6);
            ASSERT_LT(glm::dot(n, away), 0.0) << variant.name << ", pixel " << pixel;
            // From the centre outwards, as far as a coarse sphere goes; never turned round.
            const glm::dvec3 center = g.camera.view * glm::vec4(0, 0, 0, 1);
            EXPECT_GT(glm::dot(n, glm::normalize(position_of(g, pixel) - center)), 0.8) << variant.name;
        }
        EXPECT_GT(covered, 1000) << variant.name;
        EXPECT_LT(covered, 4000) << variant.name;
    }
}

TEST_F(RasterizeTest, NormalsWithoutADirectionComeFromTheTriangle) {
    for (const Variant& variant : variants) {
        for (const glm::vec3 none : {glm::vec3(0), glm::vec3(nan)}) {
            Scene scene{.name = "slope",
                        .mesh = make_parallelogram({-9, -3, -2}, {18, 0, 0}, {0, 8, -8}, 50.0)};
            std::ranges::fill(scene.mesh.normals, none);
            scene.camera = with({}, variant);
            const GBuffer g = shot(scene, {16, 16});
            const glm::vec3 want = glm::normalize(glm::vec3(0, 1, 1));
            for (std::size_t pixel = 0; pixel < g.depth.size(); ++pixel) {
                if (std::isinf(g.depth[pixel])) continue;
                EXPECT_LT(glm::distance(g.normal[pixel], want), 1e-4F) << variant.name;
            }
            EXPECT_FALSE(std::isinf(g.depth[16 * 15 + 8]));
        }
    }
}

TEST_F(RasterizeTest, NothingInView) {
    Scene scene{.name = "behind", .mesh = make_box({-1, -1, 2}, {1, 1, 3}, 9.0)};
    const GBuffer g = shot(scene, {5, 4});
    EXPECT_EQ(g.depth, std::vector<float>(20, static_cast<float>(infinity)));
    EXPECT_EQ(g.normal, std::vector<glm::vec3>(20, glm::vec3(0)));
}

TEST_F(RasterizeTest, TheHallIsDeep) {
    const GBuffer g = shot(make_scene("columns"), {320, 180});
    const auto [nearest, farthest] = std::ranges::minmax(g.depth);
    EXPECT_GT(nearest, 0.09F);
    EXPECT_LT(nearest, 0.11F);
    EXPECT_GT(farthest, 150.0F);
    EXPECT_LT(farthest, 210.0F);  // closed: no background
}

TEST_F(RasterizeTest, SizesThatAreNotPossible) {
    const Scene scene = make_scene("corner");
    const std::uint32_t beyond = device().info().max_image_size + 1;
    for (const gpu::Extent extent : {gpu::Extent{0, 5}, gpu::Extent{5, 0}, gpu::Extent{0, 0},
                                     gpu::Extent{beyond, 1}, gpu::Extent{1, beyond}}) {
        const std::string size = std::to_string(extent.width) + "x" + std::to_string(extent.height);
        expect_error<std::runtime_error>([&] { (void)shot(scene, extent); }, {size.c_str()});
    }
}

TEST_F(RasterizeTest, MeshesThatDoNotFit) {
    const auto expect = [&](const Mesh& mesh, std::initializer_list<std::string> parts) {
        expect_error<std::invalid_argument>([&] { (void)shot({.name = "odd", .mesh = mesh}, {4, 4}); },
                                            parts);
    };
    const Mesh good{
        .positions = {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}}, .normals = {3, {0, 0, 1}}, .indices = {0, 1, 2}};
    expect({}, {"odd", "no triangles"});
    Mesh mesh = good;
    mesh.indices[1] = 3;
    expect(mesh, {"odd", "index 3", "3 positions"});
    mesh = good;
    mesh.indices.push_back(0);
    expect(mesh, {"odd", "4 indices"});
    mesh = good;
    mesh.normals.pop_back();
    expect(mesh, {"odd", "2 normals", "3 positions"});
}

// The push constants of the raster passes have the layout that C++ gives them.

void expect_pushed(const char* file, std::size_t bytes, const std::vector<std::string>& members) {
    const PassLibrary passes(GLOAM_GLSL_DIR);
    const shader::ModuleInterface found = shader::reflect(passes.compile(file));
    ASSERT_TRUE(found.push_constants.has_value()) << file;
    EXPECT_EQ(gloam::test::lines_of(found.push_constants->members), members) << file;
    EXPECT_EQ(found.push_constants->size, bytes) << file;
}

TEST(RasterLayouts, PushConstants) {
    using R = RasterConstants;
    expect_pushed("gbuffer.vert", sizeof(R), {MEMBER(R, projection)});
    using P = PeelConstants;
    expect_pushed("peel.frag", sizeof(P), {MEMBER(P, projection), MEMBER(P, reversed_z)});
}

}  // namespace gloam::scene::test::rasterize_test
