// SPDX-License-Identifier: MIT
#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::camera_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double aspect = 1.5;

// Normalised device coordinates of a view-space point.
glm::dvec3 device_of(const CameraFrame& frame, const glm::dvec3& view) {
    const glm::dvec4 clip = glm::dmat4(frame.proj_vk) * glm::dvec4(view, 1.0);
    return glm::dvec3(clip) / clip.w;
}

void expect_near(const glm::dvec3& got, const glm::dvec3& want, double tolerance = 1e-6) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(got[i], want[i], tolerance) << "component " << i;
}

TEST(Camera, ViewTakesTheEyeToTheOriginAndLooksAlongMinusZ) {
    const Camera camera{.eye = {1, 2, 3}, .target = {1, 2, -7}, .up = {0, 5, 0}};
    const auto view = glm::dmat4(make_frame(camera, aspect).view);
    expect_near(view * glm::dvec4(1, 2, 3, 1), {0, 0, 0});
    expect_near(view * glm::dvec4(1, 2, -7, 1), {0, 0, -10});
    expect_near(view * glm::dvec4(2, 2, 3, 1), {1, 0, 0});
    expect_near(view * glm::dvec4(1, 4, 3, 1), {0, 2, 0});
    const Camera sideways{.eye = {0, 0, 0}, .target = {3, 0, 0}};
    expect_near(glm::dmat4(make_frame(sideways, aspect).view) * glm::dvec4(5, 1, 2, 1), {2, 1, -5});
}

// The corners of the view at a depth: right, and up, which is -1 in Vulkan's device coordinates.
TEST(Camera, PerspectiveCorners) {
    const Camera camera{.fovy_rad = 1.2};
    const auto frame = make_frame(camera, aspect);
    for (const double d : {0.5, 7.0, 60.0}) {
        const double top = d * std::tan(0.6);
        const auto corner = device_of(frame, {aspect * top, top, -d});
        EXPECT_NEAR(corner.x, 1.0, 1e-6);
        EXPECT_NEAR(corner.y, -1.0, 1e-6);
    }
    EXPECT_FALSE(frame.orthographic());
    EXPECT_LT(frame.p00_p11().y, 0.0F);
    EXPECT_FLOAT_EQ(frame.p00_p11().x, static_cast<float>(1.0 / (aspect * std::tan(0.6))));
}

TEST(Camera, OrthographicCorners) {
    const Camera camera{.projection = Projection::orthographic, .view_height = 4.0};
    const auto frame = make_frame(camera, aspect);
    EXPECT_TRUE(frame.orthographic());
    for (const double d : {0.5, 60.0}) {
        const auto corner = device_of(frame, {3, 2, -d});
        EXPECT_NEAR(corner.x, 1.0, 1e-6);
        EXPECT_NEAR(corner.y, -1.0, 1e-6);
    }
}

TEST(Camera, DepthRange) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed : {false, true}) {
            const Camera camera{.projection = projection, .near = 0.5, .far = 20.0, .reversed_z = reversed};
            const auto frame = make_frame(camera, aspect);
            EXPECT_NEAR(device_of(frame, {0, 0, -0.5}).z, reversed ? 1.0 : 0.0, 1e-6);
            EXPECT_NEAR(device_of(frame, {0, 0, -20}).z, reversed ? 0.0 : 1.0, 1e-6);
            const double middle = projection == Projection::perspective ? 20.0 * 0.5 * 2.0 / 20.5 : 10.25;
            EXPECT_NEAR(device_of(frame, {0, 0, -middle}).z, 0.5, 1e-6);
        }
    }
}

TEST(Camera, InfiniteFarPlane) {
    for (const bool reversed : {false, true}) {
        const auto frame = make_frame({.near = 0.5, .far = infinity, .reversed_z = reversed}, aspect);
        EXPECT_NEAR(device_of(frame, {0, 0, -0.5}).z, reversed ? 1.0 : 0.0, 1e-6);
        EXPECT_NEAR(device_of(frame, {0, 0, -1}).z, 0.5, 1e-6);
        EXPECT_NEAR(device_of(frame, {0, 0, -1e9}).z, reversed ? 0.0 : 1.0, 1e-6);
    }
}

TEST(Camera, OpenGlAndBack) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera{.projection = projection, .near = 0.5, .far = 20.0};
        const glm::dmat4 vk(make_frame(camera, aspect).proj_vk);
        const glm::dmat4 gl = gl_from_vk(vk);
        const auto depth = [&](double d) {
            const glm::dvec4 clip = gl * glm::dvec4(0, 0, -d, 1);
            return clip.z / clip.w;
        };
        EXPECT_NEAR(depth(0.5), -1.0, 1e-6);
        EXPECT_NEAR(depth(20.0), 1.0, 1e-6);
        EXPECT_GT(gl[1][1], 0.0);
        const glm::dmat4 back = vk_from_gl(gl);
        for (int i = 0; i < 16; ++i) EXPECT_NEAR(back[i / 4][i % 4], vk[i / 4][i % 4], 1e-15);
    }
}

TEST(Camera, PlanesOfAProjection) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        for (const bool reversed : {false, true}) {
            const Camera camera{.projection = projection, .near = 0.5, .far = 20.0, .reversed_z = reversed};
            const Planes planes = planes_of(make_frame(camera, aspect).proj_vk);
            // A unit in the last place of an element near 1, over the slope 1 / (far - near) or steeper.
            EXPECT_NEAR(planes.near, 0.5, 0x1p-23 * 20.0);
            EXPECT_NEAR(planes.far, 20.0, 0x1p-23 * 20.0 * 20.0 / 0.5);
            EXPECT_EQ(planes.reversed_z, reversed);
        }
    }
    for (const bool reversed : {false, true}) {
        const Planes planes =
            planes_of(make_frame({.far = infinity, .reversed_z = reversed}, aspect).proj_vk);
        EXPECT_NEAR(planes.near, 0.1, 1e-7);
        EXPECT_EQ(planes.far, infinity);
        EXPECT_EQ(planes.reversed_z, reversed);
    }
}

TEST(Camera, Impossible) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr auto orthographic = Projection::orthographic;
    const std::vector<Camera> cameras{
        {.eye = {1, 1, 1}, .target = {1, 1, 1}},
        {.eye = {nan, 0, 0}},
        {.eye = {infinity, 0, 0}},
        {.target = {0, 3, 0}},
        {.up = {0, 0, 0}},
        {.fovy_rad = 0.0},
        {.fovy_rad = 3.15},
        {.fovy_rad = nan},
        {.near = 0.0},
        {.near = -1.0},
        {.near = 5.0, .far = 5.0},
        {.far = nan},
        {.near = infinity, .far = infinity},
        {.projection = orthographic, .far = infinity},
        {.projection = orthographic, .view_height = 0.0},
        {.projection = orthographic, .view_height = infinity},
    };
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        SCOPED_TRACE(i);
        expect_error<std::invalid_argument>([&] { (void)make_frame(cameras[i], aspect); }, {"camera"});
    }
    for (const double bad : {0.0, -1.0, nan, infinity})
        expect_error<std::invalid_argument>([&] { (void)make_frame({}, bad); }, {"camera", "aspect"});
}

// Depth layers as files.

constexpr float nothing = std::numeric_limits<float>::infinity();

TEST(LayerFiles, AreReadInTheirOrder) {
    const TemporaryDirectory folder;
    const GBuffer view{.extent = {2, 2}, .depth = {1, 2, 3, 4}, .camera = make_frame({}, 1.0)};
    write_frame(folder, 0, view);
    EXPECT_THAT(read_gbuffer(folder.path(), 0).layers, IsEmpty());
    folder.write("f0000_layer1.pfm", pfm_text(view.extent, {-2, 0, std::nanf(""), -nothing}));
    folder.write("f0000_layer2.pfm", pfm_text(view.extent, {5, 6, 7, 8}));
    const GBuffer read = read_gbuffer(folder.path(), 0);
    EXPECT_THAT(read.layers,
                ElementsAre(ElementsAre(-2, nothing, nothing, nothing), ElementsAre(5, 6, 7, 8)));
}

TEST(LayerFiles, ALayerNeedsTheOneBefore) {
    const TemporaryDirectory folder;
    const GBuffer view{.extent = {2, 2}, .depth = {1, 2, 3, 4}, .camera = make_frame({}, 1.0)};
    write_frame(folder, 0, view);
    folder.write("f0000_layer2.pfm", pfm_text(view.extent, {5, 6, 7, 8}));
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_layer2.pfm", "the layer before it"});
    folder.write("f0000_layer1.pfm", pfm_text({1, 2}, {5, 6}));
    expect_error<std::runtime_error>([&] { (void)read_gbuffer(folder.path(), 0); },
                                     {"f0000_layer1.pfm", "1x2", "expected 2x2"});
}

}  // namespace gloam::scene::test::camera_test
