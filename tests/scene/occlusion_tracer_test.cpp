// SPDX-License-Identifier: MIT
// The ray tracer against meshes whose occlusion is known, at the points where it is.
#include <fmt/format.h>

#include "scene/internal/tracer.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::occlusion_tracer_test {

constexpr double everywhere = std::numeric_limits<double>::infinity();
constexpr double far_away = 1e4;  // where what should be infinite ends
constexpr double pi = std::numbers::pi;

struct KnownPoint {
    Receiver receiver;
    double occlusion = 0.0;
};

struct KnownScene {
    std::string name;
    Mesh mesh;
    int points = 40;
    std::function<KnownPoint(int)> point;
    RaySettings settings{.radius = everywhere, .falloff = Falloff::step, .rays = 1024};
};

// A point on the ground y = 0.
Receiver on_ground(double x, double z) {
    return {.position = {x, 0, z}, .normal = {0, 1, 0}, .facet = {0, 1, 0}, .clearance = 1e-7};
}

Mesh ground(double extent) {
    return make_parallelogram({-extent, 0, -extent}, {0, 0, 2 * extent}, {2 * extent, 0, 0}, 2 * extent);
}

// An infinite ceiling at q radii. Uniformly: the mean of 1 - q / z over the heights z of directions from q to
// 1.
KnownScene ceiling(Falloff falloff, double q, Weighting weighting = Weighting::cosine) {
    double occlusion = 1.0 - q * q;
    if (falloff == Falloff::linear) occlusion = (1.0 - q) * (1.0 - q);
    if (falloff == Falloff::quadratic) occlusion += 2.0 * q * q * std::log(q);
    if (weighting == Weighting::uniform) occlusion = 1.0 - q + q * std::log(q);
    Mesh mesh = ground(30.0);
    append(mesh, make_parallelogram({-30, q * 2.0, -30}, {60, 0, 0}, {0, 0, 60}, 60.0));
    return {.name = fmt::format("ceiling, {}", static_cast<int>(falloff)),
            .mesh = mesh,
            .point = [=](int i) -> KnownPoint { return {on_ground(0.13 * i, 0.07 * i), occlusion}; },
            .settings = {.radius = 2.0, .falloff = falloff, .rays = 1024, .weighting = weighting}};
}

// An infinite wall; points at 0.02 to 1.1 radii from it.
KnownScene wall(Falloff falloff) {
    const auto occlusion = [=](double c) {
        if (c >= 1.0) return 0.0;
        const double s = std::sqrt(1.0 - c * c);
        const double angle = std::acos(c);
        const double step = angle - c * s;
        if (falloff == Falloff::step) return step / pi;
        if (falloff == Falloff::linear) return 2.0 / pi * (0.5 * step - c * (std::acosh(1.0 / c) - s));
        return 2.0 / pi * ((0.5 + c * c) * angle - 1.5 * c * s);
    };
    Mesh mesh = ground(30.0);
    append(mesh, make_parallelogram({0, 0, -30}, {0, 30, 0}, {0, 0, 60}, 60.0));
    return {.name = fmt::format("wall, {}", static_cast<int>(falloff)),
            .mesh = mesh,
            .points = 55,
            .point = [=](int i) -> KnownPoint {
                const double c = 0.02 * (i + 1);
                return {on_ground(1.5 * c, 0.05 * i), occlusion(c)};
            },
            .settings = {.radius = 1.5, .falloff = falloff, .rays = 1024}};
}

// A point within a closed sphere of x radii across, on its wall; a little within, for the mesh is inscribed
// in the sphere.
KnownScene enclosed(Falloff falloff, double x) {
    double occlusion = x <= 1.0 ? 1.0 : 1.0 / (x * x);
    if (falloff == Falloff::linear) occlusion = x <= 1.0 ? 1.0 - 2.0 * x / 3.0 : 1.0 / (3.0 * x * x);
    if (falloff == Falloff::quadratic) occlusion = x <= 1.0 ? 1.0 - 0.5 * x * x : 0.5 / (x * x);
    return {.name = fmt::format("in a sphere, {}", static_cast<int>(falloff)),
            .mesh = make_sphere({0, 0, 0}, 0.5 * x, 256, 512),
            .point = [=](int i) -> KnownPoint {
                const double angle = 0.1 + 0.15 * i;
                const glm::dvec3 inwards{std::cos(angle) * 0.6, 0.8, std::sin(angle) * 0.6};
                return {{.position = -0.5 * x * 0.99994 * inwards, .normal = inwards, .facet = inwards},
                        occlusion};
            },
            .settings = {.radius = 1.0, .falloff = falloff, .rays = 1024}};
}

// A plane that rises at the angle from the line x = 0, and one on the other side too when `both`. Uniformly:
// directions up to the angle, of pi in each plane across the line. Points just above the line: to a plane
// without end every height is the same.
KnownScene groove(double angle, bool both, Weighting weighting = Weighting::cosine) {
    const glm::dvec3 along{0, 0, 2 * far_away};
    const glm::dvec3 rise{far_away * std::cos(angle), far_away * std::sin(angle), 0};
    Mesh mesh = make_parallelogram({0, 0, -far_away}, along, rise, 2 * far_away);
    if (both) append(mesh, make_parallelogram({0, 0, -far_away}, {-rise.x, rise.y, 0}, along, 2 * far_away));
    const double one = weighting == Weighting::cosine ? 0.5 * (1.0 - std::cos(angle)) : angle / pi;
    return {
        .name = both ? "groove" : "groove, one side",
        .mesh = mesh,
        .point = [=](int i) -> KnownPoint {
            Receiver receiver = on_ground(0.0, 0.1 * i);
            receiver.position.y = 0.01;
            return {receiver, (both ? 2.0 : 1.0) * one};
        },
        .settings = {.radius = everywhere, .falloff = Falloff::step, .rays = 1024, .weighting = weighting}};
}

// A long wall of height 1, and a sphere of radius 0.5 whose centre is 1.2 above a plane, where all of it is
// above the horizon; no falloff.
std::vector<KnownScene> wall_and_sphere() {
    Mesh sphere = ground(50.0);
    append(sphere, make_sphere({0, 1.2, 0}, 0.5, 256, 512));
    return {{.name = "wall of finite height",
             .mesh = make_parallelogram({0, 0, -far_away}, {0, 1, 0}, {0, 0, 2 * far_away}, 2 * far_away),
             .point = [](int i) -> KnownPoint {
                 const double a = 0.1 * (i + 1);
                 return {on_ground(a, 0.3), 0.5 * (1.0 - 1.0 / std::sqrt(1.0 + 1.0 / (a * a)))};
             }},
            {.name = "sphere over plane", .mesh = sphere, .points = 50, .point = [](int i) -> KnownPoint {
                 const double distance = std::hypot(0.05 * i, 1.2);
                 return {on_ground(0.05 * i, 0.0), 0.25 * 1.2 / (distance * distance * distance)};
             }}};
}

std::vector<KnownScene> known_scenes() {
    std::vector<KnownScene> scenes = wall_and_sphere();
    scenes.push_back({.name = "plane",
                      .mesh = ground(100.0),
                      .points = 20,
                      .point = [](int i) -> KnownPoint { return {on_ground(0.37 * i, -0.21 * i), 0.0}; },
                      .settings = {.radius = 1.0, .rays = 1024}});
    for (const auto& [angle, both] : {std::pair{0.4, true}, {1.1, false}, {0.8, true}})
        for (const Weighting weighting : {Weighting::cosine, Weighting::uniform})
            scenes.push_back(groove(angle, both, weighting));
    for (const double q : {0.1, 0.6}) scenes.push_back(ceiling(Falloff::linear, q, Weighting::uniform));
    for (const Falloff falloff : {Falloff::linear, Falloff::quadratic, Falloff::step}) {
        scenes.push_back(wall(falloff));
        for (const double q : {0.1, 0.6}) scenes.push_back(ceiling(falloff, q));
        for (const double x : {0.5, 1.6}) scenes.push_back(enclosed(falloff, x));
    }
    return scenes;
}

// What is not the rays' fault: a sphere of triangles, ends instead of infinity, single precision.
constexpr double modelling = 1e-4;

// Each point within six standard errors, the mean over a scene's points within three of its own.
TEST(OcclusionTracer, AgreesWithEveryClosedForm) {
    Tally tally;
    for (const KnownScene& scene : known_scenes()) {
        SCOPED_TRACE(scene.name);
        const OcclusionTracer tracer(scene.mesh, scene.settings);
        double sum = 0.0;
        double variance = 0.0;
        for (int i = 0; i < scene.points; ++i) {
            const auto [receiver, occlusion] = scene.point(i);
            const OcclusionEstimate estimate = tracer.occlusion(receiver, static_cast<std::uint64_t>(i));
            const double error = estimate.occlusion - occlusion;
            EXPECT_LE(std::abs(error), 6.0 * estimate.standard_error + modelling) << "point " << i;
            sum += error;
            variance += estimate.standard_error * estimate.standard_error;
            if (estimate.standard_error > 1.01 / 1024.0 ||
                (scene.settings.falloff != Falloff::step && estimate.standard_error > modelling))
                tally.add(std::abs(error), estimate.standard_error);
        }
        EXPECT_LE(std::abs(sum), 3.0 * std::sqrt(variance) + 0.2 * modelling * scene.points);
    }
    tally.expect_student(300.0);
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

// The standard error over 16 times as many rays falls by more than the 4 of independent ones.
TEST(OcclusionTracer, ConvergesFasterThanIndependentRays) {
    KnownScene scene = wall(Falloff::linear);
    const auto mean_error = [&](int rays) {
        scene.settings.rays = rays;
        const OcclusionTracer tracer(scene.mesh, scene.settings);
        double sum = 0.0;
        for (int i = 0; i < scene.points; i += 2)
            sum += tracer.occlusion(scene.point(i).receiver, static_cast<std::uint64_t>(i)).standard_error;
        return sum;
    };
    EXPECT_GT(mean_error(256) / mean_error(4096), 6.0);
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

}  // namespace gloam::scene::test::occlusion_tracer_test
