// SPDX-License-Identifier: MIT
#include "scene/occlusion_tracer.hpp"
#include "scene/closed_forms.hpp"
#include "scene/internal/ray_scene.hpp"
#include "scene/lighting.hpp"
#include "scene/scene.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::occlusion_tracer_test {

std::vector<KnownScene> known_scenes() {
    std::vector<KnownScene> scenes{open_plane(),
                                   low_wall(),
                                   sphere_over_plane(),
                                   groove(0.4, true),
                                   groove(1.1, false),
                                   groove(0.8, true),
                                   groove_seen_uniformly(0.4, true),
                                   groove_seen_uniformly(1.1, false),
                                   ceiling_seen_uniformly(0.1),
                                   ceiling_seen_uniformly(0.6)};
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::step}) {
        scenes.push_back(wall(falloff));
        scenes.push_back(ceiling(falloff, 0.1));
        scenes.push_back(ceiling(falloff, 0.6));
        scenes.push_back(enclosed(falloff, 0.5));
        scenes.push_back(enclosed(falloff, 1.6));
    }
    return scenes;
}

// How often an estimate was further from the truth than 1, 2 and 3 of its own standard errors.
struct Tally {
    double points = 0.0;
    std::array<double, 3> beyond{};

    void add(double error, double standard_error) {
        points += 1.0;
        for (std::size_t k = 0; k < beyond.size(); ++k)
            if (error > static_cast<double>(k + 1) * standard_error) beyond[k] += 1.0;
    }
};

// What is not the rays' fault: a sphere of triangles, ends instead of infinity, single precision.
constexpr double modelling = 1e-4;

// Each point within six standard errors, the mean over a scene's points within three of its own.
TEST(OcclusionTracer, AgreesWithEveryClosedForm) {
    Tally tally;
    for (const KnownScene& scene : known_scenes()) {
        SCOPED_TRACE(scene.name);
        const OcclusionTracer tracer(
            scene.mesh,
            {.radius = scene.radius, .falloff = scene.falloff, .rays = 1024, .weighting = scene.weighting});
        double sum = 0.0;
        double variance = 0.0;
        double worst = 0.0;
        std::uint64_t seed = 0;
        for (const KnownPoint& point : scene.points) {
            const OcclusionEstimate estimate = tracer.occlusion(point.receiver, seed++);
            const double error = estimate.occlusion - point.occlusion;
            EXPECT_LE(std::abs(error), 6.0 * estimate.standard_error + modelling) << "point " << seed;
            sum += error;
            variance += estimate.standard_error * estimate.standard_error;
            worst = std::max(worst, std::abs(error));
            if (estimate.standard_error > 1.01 / 1024.0 ||
                (scene.falloff != Falloff::step && estimate.standard_error > modelling))
                tally.add(std::abs(error), estimate.standard_error);
        }
        const auto count = static_cast<double>(scene.points.size());
        EXPECT_LE(std::abs(sum / count), 3.0 * std::sqrt(variance) / count + 0.2 * modelling);
        std::printf("%-22s mean error %+.1e, expected %.1e, largest %.1e\n", scene.name.c_str(), sum / count,
                    std::sqrt(variance) / count, worst);
    }
    // The mean of 16 parts over its estimated error: Student's t with 15 degrees of freedom.
    const std::array<double, 3> expected{0.3332, 0.0640, 0.0090};
    std::printf("%.0f points; beyond 1, 2, 3 standard errors: %.4f %.4f %.4f\n", tally.points,
                tally.beyond[0] / tally.points, tally.beyond[1] / tally.points,
                tally.beyond[2] / tally.points);
    EXPECT_GT(tally.points, 300.0);
    for (std::size_t k = 0; k < expected.size(); ++k) {
        const double deviation = std::sqrt(expected[k] * (1.0 - expected[k]) / tally.points);
        EXPECT_NEAR(tally.beyond[k] / tally.points, expected[k], 4.0 * deviation) << k + 1;
    }
}

// All three walls of the scene, by its own closed form; the mesh is the one that is rendered.
TEST(OcclusionTracer, AgreesWithTheCorner) {
    const OcclusionTracer tracer(make_scene("corner").mesh, {.radius = 1.0, .rays = 1024});
    std::uint64_t seed = 0;
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 60; ++i) {
            Receiver receiver{.normal = {0, 0, 0}, .facet = {0, 0, 0}, .clearance = 1e-6};
            receiver.position[(axis + 1) % 3] = 0.011 + 0.017 * i;
            receiver.position[(axis + 2) % 3] = 0.7 - 0.011 * i;
            receiver.normal[axis] = receiver.facet[axis] = 1.0;
            const OcclusionEstimate estimate = tracer.occlusion(receiver, seed++);
            EXPECT_NEAR(estimate.occlusion, corner_occlusion_at(receiver.position, 1.0),
                        6.0 * estimate.standard_error + 1e-5);
        }
    }
}

// An open plane in any position is exactly open: no ray meets the surface that it starts on, nor the
// neighbours of its triangle.
TEST(OcclusionTracer, TiltedPlanesFarAwayDoNotShadeThemselves) {
    for (const double away : {0.0, 10.0, 200.0, 1e5}) {
        for (const double tilt : {0.0, 0.3, 1.0, 1.5}) {
            const glm::dvec3 at(away, -0.4 * away, -0.7 * away);
            const glm::dvec3 u(std::cos(tilt), std::sin(tilt), 0.2);
            const glm::dvec3 v = glm::cross(u, glm::dvec3(0.1, -0.3, 1.0));
            const OcclusionTracer tracer(
                make_parallelogram(at - 20.0 * u - 20.0 * v, 40.0 * u, 40.0 * v, 0.7), {.rays = 256});
            const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
            for (int i = 0; i < 50; ++i) {
                const glm::dvec3 point = at + (0.31 * i - 7.0) * u + (0.17 * i - 4.0) * v;
                const auto found = tracer.surface(point + 2.0 * normal, -normal, 1.0, 3.0);
                ASSERT_TRUE(found);
                EXPECT_EQ(tracer.occlusion(*found, static_cast<std::uint64_t>(i)).occlusion, 0.0)
                    << "distance " << away << ", tilt " << tilt;
            }
        }
    }
}

// Smooth normals on a coarse sphere, which is convex: nothing blocks.
TEST(OcclusionTracer, FacetsOfASmoothShapeDoNotShadeThemselves) {
    const OcclusionTracer tracer(make_sphere({0, 0, 0}, 1.0, 8, 12), {.radius = 5.0, .rays = 256});
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 outwards{0.6 * std::cos(0.7 * i), 0.8, 0.6 * std::sin(0.7 * i)};
        auto found = tracer.surface(3.0 * outwards, -outwards, 1.0, 3.0);
        ASSERT_TRUE(found);
        found->normal = outwards;
        EXPECT_EQ(tracer.occlusion(*found, 1).occlusion, 0.0) << i;
    }
}

// The standard error over four times as many rays falls by more than the 2 of independent ones.
TEST(OcclusionTracer, ConvergesFasterThanIndependentRays) {
    const KnownScene scene = wall(Falloff::linear);
    const auto mean_error = [&](int rays) {
        const OcclusionTracer tracer(scene.mesh, {.radius = scene.radius, .rays = rays});
        double sum = 0.0;
        for (std::size_t i = 0; i < scene.points.size(); i += 2)
            sum += tracer.occlusion(scene.points[i].receiver, i).standard_error;
        return sum;
    };
    const double ratio = mean_error(256) / mean_error(4096);
    std::printf("16 times the rays: the standard error falls %.1f times\n", ratio);
    EXPECT_GT(ratio, 6.0);
}

TEST(OcclusionTracer, SettingsThatAreNotPossible) {
    const Mesh mesh = ground(1.0);
    const auto expect = [&](const RaySettings& settings, std::initializer_list<std::string> parts) {
        expect_error<std::invalid_argument>([&] { (void)OcclusionTracer(mesh, settings); }, parts);
    };
    expect({.rays = 0}, {"0 rays", "32"});
    expect({.rays = -5}, {"-5 rays"});
    expect({.rays = 31}, {"31 rays"});
    expect({.radius = 0.0}, {"radius"});
    expect({.radius = std::nan("")}, {"radius"});
    expect({.radius = everywhere}, {"infinite", "step"});
    EXPECT_EQ(OcclusionTracer(mesh, {.rays = 33}).rays(), 48U);
}

TEST(OcclusionTracer, MeshesThatCannotBeTraced) {
    const auto expect = [&](const Mesh& mesh, std::initializer_list<std::string> parts) {
        expect_error<std::invalid_argument>([&] { (void)OcclusionTracer(mesh, {}); }, parts);
    };
    expect({}, {"nothing to trace"});
    Mesh mesh = ground(1.0);
    mesh.indices.pop_back();
    expect(mesh, {"three for each triangle"});
    mesh = ground(1.0);
    mesh.indices[2] = 99;
    expect(mesh, {"index 99"});
    mesh = ground(1.0);
    mesh.positions[1].z = nan;
    expect(mesh, {"vertex 1", "nan", "finite"});
}

// Any 2^k first points have one in each cell of every grid of 2^k equal cells, scrambled in any way; the
// marks of a (0, 2)-sequence in base 2.
TEST(SobolPoints, KeepTheirStrataWhenScrambled) {
    const SobolPoints points(256);
    for (const std::uint64_t seed : {0ULL, 1ULL, 0x123456789abcdefULL, ~0ULL}) {
        for (int columns = 1; columns <= 256; columns *= 2) {
            std::vector<int> cells(256, 0);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const glm::dvec2 p = points.scrambled(i, mixed(seed));
                const int x = static_cast<int>(p.x * columns);
                const int y = static_cast<int>(p.y * (256 / columns));
                ++cells[static_cast<std::size_t>(y * columns + x)];
            }
            EXPECT_EQ(*std::ranges::min_element(cells), 1) << seed << ", " << columns;
        }
    }
}

constexpr gpu::Extent size{33, 33};

// A floor, and a ball above its middle; seen from right above, so that no pixel sees what is below the ball.
Scene ball_on_floor() {
    Scene scene{.name = "ball", .mesh = make_parallelogram({-20, 0, 20}, {40, 0, 0}, {0, 0, -40}, 40.0)};
    append(scene.mesh, make_sphere({0, 2, 0}, 0.5, 32, 64));
    scene.camera = {.eye = {0, 8, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}, .fovy_rad = 1.2};
    return scene;
}

// The floor of the scene as that camera sees it, the ball left out.
GBuffer floor_view(const Scene& scene) {
    const std::size_t pixels = std::size_t{size.width} * size.height;
    return {.extent = size,
            .depth = std::vector<float>(pixels, 8.0F),
            .normal = std::vector<glm::vec3>(pixels, glm::vec3(0, 0, 1)),
            .camera = make_frame(scene.camera, 1.0)};
}

float brightness(const glm::vec3& color) {
    return color.x + color.y + color.z;
}

TEST(Lighting, TheBallThrowsItsShadowAwayFromTheSun) {
    const Scene scene = ball_on_floor();
    const SplitLight with = light_of(floor_view(scene), &scene);
    const SplitLight without = light_of(floor_view(scene), nullptr);
    std::size_t dark = 0;
    double x = 0.0;
    for (std::size_t i = 0; i < with.direct.size(); ++i) {
        ASSERT_LE(brightness(with.direct[i]), brightness(without.direct[i]) + 1e-5F);
        EXPECT_EQ(with.ambient[i], without.ambient[i]);  // shadows are of the direct light
        if (brightness(with.direct[i]) > 0.01F) continue;
        ++dark;
        x += static_cast<double>(i % size.width) - 16.0;
    }
    ASSERT_GT(dark, 3U);
    EXPECT_LT(dark, 60U);
    EXPECT_GT(x / static_cast<double>(dark), 1.0);  // the sun stands at -x
}

TEST(Lighting, ALampLightsWhatFacesIt) {
    Scene scene = ball_on_floor();
    scene.lamp = glm::dvec3(0, 6, 0);
    const SplitLight lit = light_of(floor_view(scene), &scene);
    EXPECT_EQ(brightness(lit.direct[16 * 33 + 16]), 0.0F);  // below the ball
    EXPECT_GT(brightness(lit.direct[16 * 33 + 28]), 0.1F);
    scene.lamp = glm::dvec3(0, -6, 0);  // under the floor
    for (const glm::vec3& color : light_of(floor_view(scene), &scene).direct)
        EXPECT_EQ(brightness(color), 0.0F);
}

TEST(Lighting, TheBackgroundIsSkyAndHasNoOcclusion) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    view.depth[0] = infinity;
    view.depth[1] = nan;
    const SplitLight light = light_of(view, &scene);
    for (const std::size_t i : {0, 1}) {
        EXPECT_EQ(light.ambient[i], glm::vec3(0));
        EXPECT_GT(brightness(light.direct[i]), 1.0F);
    }
}

TEST(Lighting, AlbedoAndMissingNormals) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    const SplitLight grey = light_of(view, &scene);
    view.color.assign(view.depth.size(), glm::vec3(default_color.x, 0.0F, 0.0F));
    const SplitLight red = light_of(view, &scene);
    view.normal.clear();  // the depth is that of a plane
    const SplitLight found = light_of(view, &scene);
    for (std::size_t i = 0; i < red.ambient.size(); ++i) {
        EXPECT_FLOAT_EQ(red.ambient[i].x, grey.ambient[i].x);
        EXPECT_EQ(red.ambient[i].y, 0.0F);
        EXPECT_NEAR(found.ambient[i].x, red.ambient[i].x, 1e-4F);
    }
}

TEST(Lighting, IsTheSameForAnyNumberOfThreads) {
    const Scene scene = ball_on_floor();
    const SplitLight one = light_of(floor_view(scene), &scene, {.threads = 1});
    const SplitLight four = light_of(floor_view(scene), &scene, {.threads = 4});
    EXPECT_EQ(one.direct, four.direct);
    EXPECT_EQ(one.ambient, four.ambient);
}

TEST(Lighting, RefusesImagesOfAnotherSize) {
    const Scene scene = ball_on_floor();
    GBuffer view = floor_view(scene);
    view.normal.resize(5);
    expect_error<std::invalid_argument>([&] { (void)light_of(view, &scene); }, {"5 normals"});
}

}  // namespace gloam::scene::test::occlusion_tracer_test
