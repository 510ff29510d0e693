// SPDX-License-Identifier: MIT
// The ray tracer against meshes whose occlusion is known, at the points where it is.
#include "scene/tracer.hpp"

#include <fmt/format.h>

#include "scene/support.hpp"

namespace gloam::scene::test::occlusion_tracer_test {

Mesh ground(double extent) {
    return make_parallelogram({-extent, 0, -extent}, {0, 0, 2 * extent}, {2 * extent, 0, 0}, 2 * extent);
}

// A point on the ground.
Receiver on_ground(int i) {
    return {.position = {0.13 * i, 0, 0.07 * i}, .normal = {0, 1, 0}, .facet = {0, 1, 0}, .clearance = 1e-7};
}

// An infinite ceiling at q radii of 2. Uniformly: the mean of 1 - q / z over the heights z of directions from
// q to 1.
struct Ceiling {
    Falloff falloff;
    double q;
    Weighting weighting = Weighting::cosine;

    [[nodiscard]] double occlusion() const {
        if (weighting == Weighting::uniform) return 1.0 - q + q * std::log(q);
        if (falloff == Falloff::linear) return (1.0 - q) * (1.0 - q);
        return falloff == Falloff::step ? 1.0 - q * q : 1.0 - q * q + 2.0 * q * q * std::log(q);
    }

    [[nodiscard]] OcclusionTracer tracer() const {
        Mesh mesh = ground(30.0);
        append(mesh, make_parallelogram({-30, q * 2.0, -30}, {60, 0, 0}, {0, 0, 60}, 60.0));
        return {mesh, {.radius = 2.0, .falloff = falloff, .weighting = weighting}};
    }
};

// The mean of 16 parts over its estimated error: Student's t with 15 degrees of freedom. errors: in units of
// their own estimates.
void expect_student(const std::vector<double>& errors) {
    const auto points = static_cast<double>(errors.size());
    EXPECT_GT(points, 100.0);
    for (const auto& [limit, share] : {std::pair(1.0, 0.3332), {2.0, 0.0640}, {3.0, 0.0090}}) {
        const auto beyond =
            static_cast<double>(std::ranges::count_if(errors, [&](double error) { return error > limit; }));
        EXPECT_NEAR(beyond / points, share, 4.0 * std::sqrt(share * (1.0 - share) / points)) << limit;
    }
}

// What is not the rays' fault: ends instead of infinity, single precision.
constexpr double modelling = 1e-4;

// Each point within six standard errors, the mean over a scene's points within three of its own.
TEST(OcclusionTracer, AgreesWithEveryClosedForm) {
    std::vector<double> errors;
    for (const double q : {0.1, 0.3, 0.6, 0.9}) {
        for (const Ceiling& ceiling :
             {Ceiling{Falloff::linear, q}, Ceiling{Falloff::quadratic, q}, Ceiling{Falloff::step, q},
              Ceiling{Falloff::linear, q, Weighting::uniform}}) {
            SCOPED_TRACE(fmt::format("{} {}", q, static_cast<int>(ceiling.falloff)));
            const OcclusionTracer tracer = ceiling.tracer();
            constexpr int points = 40;
            double sum = 0.0;
            double variance = 0.0;
            for (int i = 0; i < points; ++i) {
                const OcclusionEstimate estimate =
                    tracer.occlusion(on_ground(i), static_cast<std::uint64_t>(i));
                const double error = estimate.occlusion - ceiling.occlusion();
                EXPECT_LE(std::abs(error), 6.0 * estimate.standard_error + modelling) << "point " << i;
                sum += error;
                variance += estimate.standard_error * estimate.standard_error;
                if (estimate.standard_error > (ceiling.falloff == Falloff::step ? 1.01 / 1024.0 : modelling))
                    errors.push_back(std::abs(error) / estimate.standard_error);
            }
            EXPECT_LE(std::abs(sum), 3.0 * std::sqrt(variance) + 0.2 * modelling * points);
        }
    }
    expect_student(errors);
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
    const OcclusionTracer tracer(make_sphere({0, 0, 0}, 1.0, 8), {.radius = 5.0, .rays = 256});
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 outwards{0.6 * std::cos(0.7 * i), 0.8, 0.6 * std::sin(0.7 * i)};
        auto found = tracer.surface(3.0 * outwards, -outwards, 1.0, 3.0);
        ASSERT_TRUE(found);
        found->normal = outwards;
        EXPECT_EQ(tracer.occlusion(*found, 1).occlusion, 0.0) << i;
    }
}

TEST(OcclusionTracer, SettingsThatAreNotPossible) {
    const Mesh mesh = ground(1.0);
    const auto expect = [&](const RaySettings& settings, std::initializer_list<std::string> parts) {
        expect_error<std::invalid_argument>([&] { (void)OcclusionTracer(mesh, settings); }, parts);
    };
    expect({.rays = -5}, {"-5 rays", "32"});
    expect({.rays = 31}, {"31 rays"});
    expect({.radius = 0.0}, {"radius"});
    expect({.radius = double{nan}}, {"radius"});
    expect({.radius = double{infinity}}, {"infinite", "step"});
    EXPECT_EQ(OcclusionTracer(mesh, {.rays = 33}).rays(), 48U);
}

// The views whose occlusion is known in closed form: their meshes have it at the point that they show in the
// middle.
TEST(ClosedFormViews, HaveTheOcclusionThatTheySay) {
    for (const Projection projection : projections)
        for (const ClosedFormView& view : closed_form_views(projection)) {
            SCOPED_TRACE(view.scene.name);
            const OcclusionTracer tracer(view.scene.mesh, {.radius = 1.0, .rays = 1 << 16});
            EXPECT_NEAR(tracer.occlusion({.clearance = 1e-5}, 0).occlusion, view.occlusion, 5e-4);
            const GBuffer buffer = draw(view, 65);
            const std::size_t middle = std::size_t{65} * 32 + 32;
            EXPECT_NEAR(double{buffer.depth[middle]}, glm::length(view.scene.camera.eye), 1e-5);
            EXPECT_EQ(buffer.normal[middle], glm::vec3(view_rotation(view.scene.camera)[2]));
            EXPECT_EQ(buffer.border, (backend::Extent{32, 32}));
            for (std::size_t i = 0; i < buffer.depth.size(); ++i)
                EXPECT_NEAR(glm::length(glm::dvec3(buffer.normal[i])),
                            std::isfinite(buffer.depth[i]) ? 1.0 : 0.0, 1e-6);
        }
}

}  // namespace gloam::scene::test::occlusion_tracer_test
