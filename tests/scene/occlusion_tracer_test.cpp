// SPDX-License-Identifier: MIT
// The ray tracer against meshes whose occlusion is known, at the points where it is.
#include "scene/internal/tracer.hpp"
#include "scene/support.hpp"

namespace gloam::scene::test::occlusion_tracer_test {

constexpr double everywhere = std::numeric_limits<double>::infinity();
constexpr double far_away = 1e4;  // where what should be infinite ends
constexpr double pi = std::numbers::pi;

// A scene, its points, and the occlusion there.
struct Known {
    std::string name;
    Mesh mesh;
    std::function<std::pair<Receiver, double>(int)> point;
    int points = 40;
    RaySettings settings{.radius = everywhere, .falloff = Falloff::step, .rays = 1024};
};

// A point on the ground y = 0, or above it.
Receiver on_ground(double x, double z, double y = 0.0) {
    return {.position = {x, y, z}, .normal = {0, 1, 0}, .facet = {0, 1, 0}, .clearance = 1e-7};
}

Mesh ground(double extent) {
    return make_parallelogram({-extent, 0, -extent}, {0, 0, 2 * extent}, {2 * extent, 0, 0}, 2 * extent);
}

double by(Falloff falloff, double linear, double quadratic, double step) {
    return std::array{linear, quadratic, step}[static_cast<std::size_t>(falloff)];
}

// An infinite ceiling at q radii. Uniformly: the mean of 1 - q / z over the heights z of directions from q to
// 1.
Known ceiling(Falloff falloff, double q, Weighting weighting = Weighting::cosine) {
    const double uniform = 1.0 - q + q * std::log(q);
    const double cosine =
        by(falloff, (1.0 - q) * (1.0 - q), 1.0 - q * q + 2.0 * q * q * std::log(q), 1.0 - q * q);
    const double occlusion = weighting == Weighting::cosine ? cosine : uniform;
    Mesh mesh = ground(30.0);
    append(mesh, make_parallelogram({-30, q * 2.0, -30}, {60, 0, 0}, {0, 0, 60}, 60.0));
    return {.name = "ceiling",
            .mesh = mesh,
            .point = [=](int i) { return std::pair(on_ground(0.13 * i, 0.07 * i), occlusion); },
            .settings = {.radius = 2.0, .falloff = falloff, .rays = 1024, .weighting = weighting}};
}

// An infinite wall; points at 0.02 to 1.1 radii from it.
Known wall(Falloff falloff) {
    const auto point = [=](int i) {
        const double c = 0.02 * (i + 1);
        const double s = std::sqrt(std::max(1.0 - c * c, 0.0));
        const double angle = std::acos(std::min(c, 1.0));
        const double step = angle - c * s;
        const double occlusion = by(falloff, step - 2.0 * c * (std::acosh(std::max(1.0 / c, 1.0)) - s),
                                    (1.0 + 2.0 * c * c) * angle - 3.0 * c * s, step);
        return std::pair(on_ground(1.5 * c, 0.05 * i), c < 1.0 ? occlusion / pi : 0.0);
    };
    Mesh mesh = ground(30.0);
    append(mesh, make_parallelogram({0, 0, -30}, {0, 30, 0}, {0, 0, 60}, 60.0));
    return {.name = "wall",
            .mesh = mesh,
            .point = point,
            .points = 55,
            .settings = {.radius = 1.5, .falloff = falloff, .rays = 1024}};
}

// A point within a closed sphere of x radii across, on its wall; a little within, for the mesh is inscribed
// in the sphere.
Known enclosed(Falloff falloff, double x) {
    const double occlusion = x <= 1.0 ? by(falloff, 1.0 - 2.0 * x / 3.0, 1.0 - 0.5 * x * x, 1.0)
                                      : by(falloff, 1.0 / (3.0 * x * x), 0.5 / (x * x), 1.0 / (x * x));
    const auto point = [=](int i) {
        const double angle = 0.1 + 0.15 * i;
        const glm::dvec3 in{std::cos(angle) * 0.6, 0.8, std::sin(angle) * 0.6};
        return std::pair(Receiver{.position = -0.5 * x * 0.99994 * in, .normal = in, .facet = in}, occlusion);
    };
    return {.name = "in a sphere",
            .mesh = make_sphere({0, 0, 0}, 0.5 * x, 256, 512),
            .point = point,
            .settings = {.radius = 1.0, .falloff = falloff, .rays = 1024}};
}

// A plane that rises at the angle from the line x = 0, and one on the other side too when `both`. Uniformly:
// directions up to the angle, of pi in each plane across the line. Points just above the line: to a plane
// without end every height is the same.
Known groove(double angle, bool both, Weighting weighting) {
    const glm::dvec3 along{0, 0, 2 * far_away};
    const glm::dvec3 rise{far_away * std::cos(angle), far_away * std::sin(angle), 0};
    Mesh mesh = make_parallelogram({0, 0, -far_away}, along, rise, 2 * far_away);
    if (both) append(mesh, make_parallelogram({0, 0, -far_away}, {-rise.x, rise.y, 0}, along, 2 * far_away));
    const double one = weighting == Weighting::cosine ? 0.5 * (1.0 - std::cos(angle)) : angle / pi;
    Known scene{.name = "groove", .mesh = mesh, .point = [=](int i) {
                    return std::pair(on_ground(0.0, 0.1 * i, 0.01), both ? 2.0 * one : one);
                }};
    scene.settings.weighting = weighting;
    return scene;
}

std::vector<Known> known_scenes() {
    Mesh sphere = ground(50.0);  // of radius 0.5, all of it above the horizon
    append(sphere, make_sphere({0, 1.2, 0}, 0.5, 256, 512));
    std::vector<Known> scenes{
        {"plane", ground(100.0), [](int i) { return std::pair(on_ground(0.37 * i, -0.21 * i), 0.0); }},
        {"sphere over plane", sphere,
         [](int i) {
             return std::pair(on_ground(0.05 * i, 0.0), 0.3 / std::pow(std::hypot(0.05 * i, 1.2), 3));
         }},
        {"wall of height 1",
         make_parallelogram({0, 0, -far_away}, {0, 1, 0}, {0, 0, 2 * far_away}, 2 * far_away), [](int i) {
             const double a = 0.1 * (i + 1);
             return std::pair(on_ground(a, 0.3), 0.5 * (1.0 - a / std::hypot(a, 1.0)));
         }}};
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
    for (const Known& scene : known_scenes()) {
        SCOPED_TRACE(scene.name + ", " + std::to_string(static_cast<int>(scene.settings.falloff)));
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
    Known scene = wall(Falloff::linear);
    const auto mean_error = [&](int rays) {
        scene.settings.rays = rays;
        const OcclusionTracer tracer(scene.mesh, scene.settings);
        double sum = 0.0;
        for (int i = 0; i < scene.points; i += 2)
            sum += tracer.occlusion(scene.point(i).first, static_cast<std::uint64_t>(i)).standard_error;
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
    const std::vector<glm::uvec2> points = sobol_points(256);
    for (const std::uint64_t seed : {0ULL, 1ULL, 0x123456789abcdefULL, ~0ULL}) {
        for (int columns = 1; columns <= 256; columns *= 2) {
            std::vector<int> cells(256, 0);
            for (const glm::uvec2& point : points) {
                const glm::dvec2 p = scrambled(point, mixed(seed));
                const int x = static_cast<int>(p.x * columns);
                const int y = static_cast<int>(p.y * (256 / columns));
                ++cells[static_cast<std::size_t>(y * columns + x)];
            }
            EXPECT_EQ(*std::ranges::min_element(cells), 1) << seed << ", " << columns;
        }
    }
}

}  // namespace gloam::scene::test::occlusion_tracer_test
