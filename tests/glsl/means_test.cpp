// SPDX-License-Identifier: MIT
// Falloffs, contributions and estimators against closed forms: means of the references over many samples.
// tests/catalogue compares each function of the library with its reference.
#include "reference/occlusion_points.hpp"
#include "support/test.hpp"

namespace gloam::reference::means_test {

constexpr unsigned sample_count = 512 * 256;
constexpr double whole_turn = 2.0 * pi;
const dvec3 up(0, 0, 1);

// Points 1 ... sample_count of Halton's sequence.
const std::vector<dvec3>& halton() {
    static const std::vector<dvec3> points = [] {
        std::vector<dvec3> all;
        for (unsigned i = 1; i <= sample_count; ++i) all.push_back(gloam_halton_3d(i));
        return all;
    }();
    return points;
}

// (sum of weight times value, sum of weights) over all points.
template <class Sample>
dvec2 sums(const Sample& sample) {
    dvec2 sum(0);
    for (const dvec3& zeta : halton()) sum += sample(zeta);
    return sum;
}
template <class Sample>
double mean(const Sample& sample) {
    return sums([&](const dvec3& zeta) { return dvec2(sample(zeta), 1.0); }).x / sample_count;
}

// The ground in front of the eye, which is far away along +z; the point is the origin.
enum class Ground {
    plane,
    groove,
    wall
};  // tilted by a slope; rising by it for x > 0; solid beyond x = size

double height_of(Ground ground, dvec2 xy, double size) {
    if (ground == Ground::plane) return size * xy.x;
    if (ground == Ground::groove) return size * max(xy.x, 0.0);
    return xy.x > size ? 1e30 : 0.0;
}
dvec3 on_groove(dvec2 xy, double slope) {
    return {xy, height_of(Ground::groove, xy, slope)};
}
dvec3 normal_of_slope(double slope) {
    return normalize(dvec3(-slope, 0, 1));
}

// Plane z = size; plane x = size; inside a closed ball of that radius that touches the point; ball of radius
// 1 at that distance, 30 degrees from the normal.
enum class Scene { ceiling, wall, inside, ball };

// The distance of what a ray from the origin hits; negative: nothing.
double hit(Scene scene, dvec3 direction, double size) {
    if (scene == Scene::ceiling) return direction.z > 0.0 ? size / direction.z : -1.0;
    if (scene == Scene::wall) return direction.x > 0.0 ? size / direction.x : -1.0;
    if (scene == Scene::inside) return 2.0 * size * direction.z;
    const dvec3 center = size * dvec3(0.5, 0.0, std::sqrt(0.75));
    const double along = dot(center, direction);
    const double miss = dot(center, center) - along * along;
    return miss <= 1.0 && along > 0.0 ? along - std::sqrt(1.0 - miss) : -1.0;
}

enum class Falloff { step, linear, quadratic, alchemy, cubic, one };

double weigh(Falloff falloff, double d) {
    switch (falloff) {
        case Falloff::linear:
            return gloam_falloff_linear(d, 1.0);
        case Falloff::quadratic:
            return gloam_falloff_quadratic(d, 1.0);
        case Falloff::alchemy:
            return gloam_falloff_alchemy(d, 1.0);
        case Falloff::one:
            return 1.0;
        default:
            return gloam_falloff_at(falloff == Falloff::step ? 0U : 3U, d);
    }
}

// Cosine-weighted directions, V D; uniform ones, 2 V D cos; TSSAO-3 as printed: cosine-weighted, V D cos; the
// Monte-Carlo form of CS-2.4 as printed: uniform, V D cos.
enum class Form { cosine, uniform, cosine_printed, uniform_printed };

double rays(Scene scene, double size, Falloff falloff, Form form = Form::cosine) {
    return mean([=](dvec3 zeta) {
        zeta.y = 1.0;
        const bool uniform = form == Form::uniform || form == Form::uniform_printed;
        const dvec3 direction = uniform ? gloam_hemisphere_uniform(zeta) : gloam_hemisphere_cosine(zeta);
        const double d = hit(scene, direction, size);
        if (d < 0.0) return 0.0;
        if (form == Form::cosine) return weigh(falloff, d);
        const double term =
            gloam_contribution_ritschel(1.0, weigh(falloff, d), gloam_sample_cosine(direction, up));
        return form == Form::uniform ? 2.0 * term : term;
    });
}

// Points instead of rays: blocked behind what is hit. Their law of radii implies the falloff.
double points(Scene scene, double size, Falloff law) {
    const double power = law == Falloff::linear ? 1.0 : law == Falloff::quadratic ? 0.5 : 1.0 / 3.0;
    return mean([=](dvec3 zeta) {
        const double radius = std::pow(zeta.y, power);
        zeta.y = 1.0;
        const double d = hit(scene, gloam_hemisphere_cosine(zeta), size);
        return d >= 0.0 && radius > d ? 1.0 : 0.0;
    });
}

TEST(Rays, OfScenesUnderFalloffs) {
    using enum Scene;
    using enum Falloff;
    constexpr double q = 0.25;
    struct Case {
        Scene scene;
        double size;
        Falloff falloff;
        double expected;
    };
    for (const Case& known : {Case{Scene::wall, q, step, 0.342519},
                              {Scene::wall, q, linear, 0.168214},
                              {Scene::wall, q, quadratic, 0.240864},
                              {Scene::wall, q, alchemy, 0.252626},
                              {Scene::wall, 2.0, alchemy, 0.106103},
                              {Scene::wall, q, one, 0.5},
                              {ceiling, q, step, 1 - q * q},
                              {ceiling, q, linear, (1 - q) * (1 - q)},
                              {ceiling, q, quadratic, 1 - q * q + 2 * q * q * std::log(q)},
                              {ceiling, q, one, 1.0},
                              {inside, q, linear, 2.0 / 3.0},
                              {inside, q, quadratic, 1 - q / 2},
                              {inside, 1.0, step, 0.25},
                              {inside, 1.0, linear, 1.0 / 12.0},
                              {ball, 2.0, one, 0.216506},
                              {ball, 4.0, one, 0.0541266}})
        EXPECT_NEAR(rays(known.scene, known.size, known.falloff), known.expected, 1e-3)
            << static_cast<int>(known.scene) << ' ' << known.size << ' ' << static_cast<int>(known.falloff);
}

// A kernel of points implies a falloff: 1 minus the distribution of its radius. Halton points do better than
// the 4 sigma / sqrt(N) of independent ones.
TEST(Rays, PointsOfARadiusLawEstimateItsFalloff) {
    constexpr double tolerance = 4 * 0.5 / 362.0;
    for (const Falloff law : {Falloff::linear, Falloff::quadratic, Falloff::cubic})
        for (const Scene scene : {Scene::ceiling, Scene::wall, Scene::inside})
            EXPECT_NEAR(points(scene, 0.25, law), rays(scene, 0.25, law), tolerance)
                << static_cast<int>(scene) << static_cast<int>(law);
    EXPECT_NEAR(points(Scene::ceiling, 0.25, Falloff::linear), 0.5625, tolerance);
}

// Both normalised forms estimate the same; TSSAO-3 and CS-2.4 as printed miss a factor.
TEST(Rays, FormsOfTheIntegral) {
    for (const Scene scene : {Scene::ceiling, Scene::wall, Scene::inside, Scene::ball}) {
        const double size = scene == Scene::ball ? 2.0 : 0.25;
        const Falloff weight = scene == Scene::ball ? Falloff::one : Falloff::linear;
        EXPECT_NEAR(rays(scene, size, weight, Form::uniform), rays(scene, size, weight), 2e-3)
            << static_cast<int>(scene);
    }
    EXPECT_NEAR(rays(Scene::inside, 1.0, Falloff::one, Form::cosine), 1.0, 1e-6);
    EXPECT_NEAR(rays(Scene::inside, 1.0, Falloff::one, Form::uniform), 1.0, 1e-3);
    EXPECT_NEAR(rays(Scene::inside, 1.0, Falloff::one, Form::uniform_printed), 0.5, 1e-3);
    EXPECT_NEAR(rays(Scene::inside, 1.0, Falloff::one, Form::cosine_printed), 2.0 / 3.0, 1e-3);
    EXPECT_NEAR(rays(Scene::ceiling, 0.1, Falloff::linear, Form::cosine), 0.81, 1e-3);
    EXPECT_NEAR(1.5 * rays(Scene::ceiling, 0.1, Falloff::linear, Form::cosine_printed), 0.85, 1e-3);
}

// Taps in planes through the point at any tilt to the view.
TEST(Points, ABarePlaneAtAnyTiltIsOpen) {
    for (const double tilt : {0.0, 0.3, 0.9, 1.3, 1.55}) {
        for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
            const dvec3 across(std::cos(azimuth), std::sin(azimuth), 0);
            const dvec3 n = std::sin(tilt) * across + std::cos(tilt) * up;
            const dvec3 t = std::cos(tilt) * across - std::sin(tilt) * up;
            for (const dvec3 offset : {0.7 * t, -0.2 * t + 0.3 * cross(n, t)}) {
                EXPECT_EQ(gloam_contribution_alchemy(offset, n, 1e-5, 1e-5, 1.0), 0.0);
                EXPECT_EQ(gloam_contribution_issao(offset, n, 1.75, 0.4, 0.022, 0.00016), 0.0);
                EXPECT_EQ(gloam_contribution_sao(offset, n, 1.0, 0.01, 0.01, 1.0), 0.0);
            }
        }
    }
}

// E[occ] = (4 sigma / (pi r)) cos(beta) artanh(sin(beta)) for taps uniform on a disc: T12. As printed,
// without the factor 2 sigma, it would be half of that at sigma = 1.
TEST(Points, AlchemyOfAGroove) {
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const double beta = degrees * pi / 180.0;
        for (const double radius : {1.0, 2.0}) {
            const double m = mean([&](const dvec3& zeta) {
                return gloam_contribution_alchemy(
                    on_groove(radius * gloam_disc_sample(dvec2(zeta)), std::tan(beta)), up, 0.0, 0.0, 1.0);
            });
            const double exact = 4.0 / (pi * radius) * std::cos(beta) * std::atanh(std::sin(beta));
            EXPECT_NEAR(2.0 * m, exact, 4e-3 * exact) << degrees << " " << radius;
        }
    }
    EXPECT_NEAR(4.0 / pi * std::cos(pi / 4) * std::atanh(std::sin(pi / 4)), 0.793515, 1e-6);
}

// Constants of figure 3 in a groove of 45 degrees; area-uniform offsets give half of the polar ones.
TEST(Points, IssaoOfAGroove) {
    const auto with = [](auto offset_of) {
        return 1.06 * mean([&](const dvec3& zeta) {
                   return gloam_contribution_issao(on_groove(offset_of(dvec2(zeta)), 1.0), up, 1.75, 0.4,
                                                   0.022, 0.00016);
               });
    };
    EXPECT_NEAR(with([](dvec2 zeta) { return gloam_issao_offset_polar(zeta, 1.75); }), 0.1330, 5e-4);
    EXPECT_NEAR(with([](dvec2 zeta) { return 1.75 * gloam_disc_sample(zeta); }), 0.0677, 5e-4);
}

dvec3 in_ball(const dvec3& zeta) {
    const double z = 2.0 * zeta.z - 1.0;
    return std::cbrt(zeta.y) * dvec3(std::sqrt(1.0 - z * z) * on_circle(whole_turn * zeta.x), z);
}

// T6: a plane is half occluded at any tilt, an inner corner of 90 degrees three quarters, a convex edge one
// quarter. Depths are measured from z = 64.
TEST(Points, CrytekBeforeTheRemapAndFilion) {
    const auto crytek = [](auto ground) {
        return mean([&](const dvec3& zeta) {
            const dvec3 s = in_ball(zeta);
            return gloam_contribution_crytek(64.0 - s.z, 64.0 - ground(s.x));
        });
    };
    for (const double slope : {0.0, 0.7, 3.0, 20.0}) {
        EXPECT_NEAR(crytek([&](double x) { return slope * x; }), 0.5, 1e-3) << slope;
        const dvec3 n = normal_of_slope(slope);
        const double filion = mean([&](const dvec3& zeta) {
            const dvec3 s = dot(in_ball(zeta), n) > 0.0 ? in_ball(zeta) : -in_ball(zeta);
            return gloam_contribution_filion(64.0 - s.z, 64.0 - slope * s.x, 1.0);
        });
        EXPECT_LT(filion, 1e-4) << slope;  // points within rounding of the plane
    }
    EXPECT_NEAR(crytek([](double x) { return std::abs(x); }), 0.75, 1e-3);
    EXPECT_NEAR(crytek([](double x) { return -std::abs(x); }), 0.25, 1e-3);
}

// Lines through the ball of radius 1, weighted by their chords or alike.
double lines(Ground ground, double size, bool by_chord = true) {
    const dvec2 sum = sums([&](const dvec3& zeta) {
        const dvec2 xi = gloam_disc_sample(dvec2(zeta));
        const double chord = gloam_chord_half_height(xi, 1.0);
        const double solid = gloam_line_occlusion(height_of(ground, xi, size), chord);
        return (by_chord ? chord : 1.0) * dvec2(solid, 1.0);
    });
    return sum.x / sum.y;
}

// T6 and T12: a plane is half solid at any tilt; the plain mean of the published shader is too large in a
// groove.
TEST(Pairs, VolumetricObscurance) {
    for (const double slope : {0.0, 0.5, 2.0, 20.0})
        EXPECT_NEAR(lines(Ground::plane, slope), 0.5, 1e-3) << slope;
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const double beta = degrees * pi / 180;
        EXPECT_NEAR(lines(Ground::groove, std::tan(beta)), 0.5 + beta / whole_turn, 1e-3) << degrees;
    }
    EXPECT_NEAR(lines(Ground::groove, 1.0, false), 0.6466, 1e-3);
    for (const double x : {0.1, 0.5, 0.9})
        EXPECT_NEAR(lines(Ground::wall, x), 0.5 + (2 - 3 * x + x * x * x) / 8, 1e-3) << x;
}

// CS-3.5 as published: what lies outside the sphere towards the eye is another object. At half chord 1.
TEST(Pairs, WhatStandsInFrontOfTheBallIsNotBelieved) {
    const auto solid_part = [](double first, double second) {
        const dvec2 solid =
            gloam_line_pair({gloam_line_ratio(first, 1.0), gloam_line_ratio(second, 1.0)}, 0.35, 1.0);
        return 0.5 * (solid.x + solid.y);
    };
    for (const auto& [first, second, part] : {std::tuple{5.0, 0.0, 0.5},
                                              {5.0, 5.0, 0.5},
                                              {1.0, 0.0, 0.75} /* on the sphere */,
                                              {-5.0, 0.0, 0.5},
                                              {-infinity, 0.5, 0.5} /* background */,
                                              {0.5, -0.25, 0.5625}})
        EXPECT_EQ(solid_part(first, second), part) << first << ' ' << second;
}

// The sphere that touches the surface: a plane leaves it empty, a groove cuts a cap off it.
TEST(Pairs, TangentSphere) {
    const auto solid = [](Ground ground, double size, dvec3 normal) {
        const dvec2 sum = sums([&](const dvec3& zeta) {
            const dvec2 xy = 0.5 * (dvec2(normal) + gloam_disc_sample(dvec2(zeta)));
            const dvec3 offset(xy, height_of(ground, xy, size));
            return gloam_tangent_sphere_half_height(offset, normal, 1.0) *
                   dvec2(gloam_tangent_sphere_occlusion(offset, normal, 1.0), 1.0);
        });
        return sum.x / sum.y;
    };
    for (const double slope : {0.0, 0.5, 2.0})
        EXPECT_LT(solid(Ground::plane, slope, normal_of_slope(slope)), 1e-6) << slope;
    for (const double degrees : {30.0, 45.0, 80.0}) {
        const double c = std::cos(degrees * pi / 180);
        EXPECT_NEAR(solid(Ground::groove, std::tan(degrees * pi / 180), up), (2 - 3 * c + c * c * c) / 4,
                    1e-3)
            << degrees;
    }
}

// By pairs of all azimuths at one distance. T6: a plane at any tilt lacks nothing of pi, and with the bias is
// as open; T12.
TEST(Pairs, Angles) {
    const auto occlusion = [](Ground ground, double size, dvec3 normal, bool cubic, double bias) {
        const auto angle = [&](double c) {
            return cubic ? gloam_acos_cubic(c - bias) : gloam_acos(c - bias);
        };
        dvec2 sum(0);
        for (unsigned i = 0; i < 1024U; ++i) {
            const dvec2 xy = 0.5 * on_circle(pi * (i + 0.5) / 1024.0);
            const dvec3 pair = gloam_angle_pair({xy, height_of(ground, xy, size)},
                                                {-xy, height_of(ground, -xy, size)}, normal, up, 20.0);
            sum += pair.z * dvec2(1.0 - (angle(pair.x) + angle(pair.y)) / pi, 1.0);
        }
        return max(sum.x / sum.y, 0.0);
    };
    for (const double slope : {0.0, 0.5, 2.0, 10.0}) {
        for (const bool cubic : {false, true}) {
            EXPECT_LT(occlusion(Ground::plane, slope, normal_of_slope(slope), cubic, 0.0), 1e-6) << slope;
            EXPECT_EQ(occlusion(Ground::plane, slope, normal_of_slope(slope), cubic, 0.08), 0.0) << slope;
        }
    }
    EXPECT_NEAR(1 - occlusion(Ground::groove, 1.0, up, false, 0.0), 0.828708, 2e-6);
    EXPECT_NEAR(1 - occlusion(Ground::groove, 1.0, up, true, 0.0), 0.820736, 2e-6);
    EXPECT_LT(occlusion(Ground::groove, 1.0, up, false, 0.08), 0.15);
}

// Directions and points of the kernels: as long as their radius, and with the means of their distributions.
TEST(Kernels, HaveTheirDistributions) {
    constexpr auto off = [](double variance) { return 4.0 * std::sqrt(variance / 4096.0); };
    for (const dvec3& zeta : {halton()[0], halton()[77], halton()[1023]})
        for (const dvec3 s : {gloam_hemisphere_cosine(zeta), gloam_hemisphere_uniform(zeta)})
            EXPECT_TRUE(s.z >= 0.0 && std::abs(length(s) - zeta.y) < 1e-12);
    EXPECT_NEAR(mean([](dvec3 zeta) { return gloam_hemisphere_cosine({zeta.x, 1, zeta.z}).z; }), 2.0 / 3,
                off(1.0 / 18));
    EXPECT_NEAR(mean([](dvec3 zeta) { return gloam_hemisphere_uniform({zeta.x, 1, zeta.z}).z; }), 0.5,
                off(1.0 / 12));
    const auto disc = [](const dvec3& zeta) { return gloam_disc_sample(dvec2(zeta)); };
    EXPECT_NEAR(mean([&](const dvec3& zeta) { return length(disc(zeta)); }), 2.0 / 3, off(1.0 / 18));
    EXPECT_NEAR(mean([&](const dvec3& zeta) { return disc(zeta).x; }), 0.0, off(0.25));
    EXPECT_NEAR(mean([&](const dvec3& zeta) { return disc(zeta).y; }), 0.0, off(0.25));
    EXPECT_NEAR(mean([&](const dvec3& zeta) { return gloam_hemisphere_lift(disc(zeta)).z; }), 2.0 / 3,
                off(1.0 / 18));
    EXPECT_NEAR(mean([](const dvec3& zeta) { return length(gloam_issao_offset_polar(dvec2(zeta), 1.0)); }),
                0.5, 1e-3);
    // What leaves the disc as printed, and is put on its rim.
    EXPECT_NEAR(mean([](const dvec3& zeta) {
                    return length(gloam_issao_offset_printed(dvec2(zeta), 1.0)) > 0.99999 ? 1.0 : 0.0;
                }),
                0.031, 0.003);
}

// Bent normals of an open half space, half of one, and a cap, which is its own cone.
TEST(BentNormals, OfOpenDirections) {
    const auto bent = [](auto open) {
        dvec4 sum(0);
        for (const dvec3& zeta : halton()) {
            const dvec3 w = gloam_hemisphere_uniform({zeta.x, 1, zeta.z});
            sum = gloam_bent_add(sum, w, open(w) ? 1.0 : 0.0);
        }
        return std::pair(gloam_bent_normal(sum, up), gloam_bent_length(sum));
    };
    const auto [of_all, agreement] = bent([](dvec3) { return true; });
    EXPECT_NEAR(agreement, 0.5, 1e-3);
    EXPECT_NEAR(of_all.z, 1.0, 1e-6);
    const dvec3 of_half = bent([](dvec3 w) { return w.x > 0; }).first;
    EXPECT_LT(length(of_half - std::sqrt(0.5) * dvec3(1, 0, 1)), 2e-3);
    const double of_cap = bent([](dvec3 w) { return w.z > 0.5; }).second;
    EXPECT_NEAR(of_cap, 0.75, 1e-3);
    EXPECT_NEAR(gloam_cone_angle(of_cap), pi / 3, 2e-3);
}

// Under light that is the same from everywhere a point sends on albedo times visibility, the cosine-weighted
// one.
TEST(DirectionalOcclusion, UniformLightGivesAlbedoTimesVisibility) {
    const dvec3 radiance(1, 0.5, 0.25);
    const dvec3 albedo(1, 0.8, 0.6);
    for (const double horizon : {0.0, 0.5, 1.0}) {  // all around, as a sine
        dvec3 sum(0);
        for (const dvec3& zeta : halton()) {
            const dvec3 w = gloam_hemisphere_uniform({zeta.x, 1, zeta.z});
            sum += gloam_ssdo_direct(w, up, radiance, w.z > horizon ? 1.0 : 0.0);
        }
        const dvec3 got = gloam_ssdo_light(sum, sample_count, albedo);
        EXPECT_LT(length(got - albedo * radiance * (1 - horizon * horizon)), 1e-3) << horizon;
    }
}

}  // namespace gloam::reference::means_test
