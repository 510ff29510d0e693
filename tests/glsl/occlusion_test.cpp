// SPDX-License-Identifier: MIT
// Falloffs, contributions and estimators against closed forms: means over many samples of the functions in
// fixtures/, and what the equations give as printed.
#include "support/lab.hpp"

namespace gloam::occlusion_test {

using check::Function;
using glm::vec2;
using glm::vec3;

constexpr double pi = std::numbers::pi;

class Estimates : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);

    static constexpr unsigned batches = 512;
    static constexpr unsigned batch = 256;

    // The two sums that a function of a fixture makes of all samples, in double.
    template <class Type, class... Arguments>
    glm::dvec2 sums(const std::string& file, const std::string& function,
                    const Arguments&... arguments) const {
        const Function<Type> kernel(lab, file, function);
        std::vector<typename Function<Type>::Inputs> inputs;
        for (unsigned b = 0; b < batches; ++b) inputs.emplace_back(arguments..., b * batch, batch);
        glm::dvec2 sum(0);
        for (const vec2 part : kernel(inputs)) sum += glm::dvec2(part);
        return sum;
    }
    // Of all samples, each of which counts once.
    template <class Type, class... Arguments>
    double mean(const std::string& file, const std::string& function, const Arguments&... arguments) const {
        const glm::dvec2 sum = sums<Type>(file, function, arguments...);
        EXPECT_EQ(sum.y, double{batches} * batch);
        return sum.x / sum.y;
    }
};

enum Scene { ceiling, wall, inside, ball };
enum Falloff { step, linear, quadratic, alchemy, cubic, one };
enum Form { cosine, uniform, cosine_printed, uniform_printed };

class Occlusion : public Estimates {
  protected:
    double rays(Scene scene, float size, Falloff falloff, Form form = cosine) const {
        return mean<vec2(int, float, int, float, int, unsigned, unsigned)>(
            "closed_form.glsl", "integrate", int{scene}, size, int{falloff}, 1.0F, int{form});
    }
    double points(Scene scene, float size, Falloff law) const {
        return mean<vec2(int, float, int, float, unsigned, unsigned)>("closed_form.glsl", "integrate_points",
                                                                      int{scene}, size, int{law}, 1.0F);
    }
};

// Of rays: scenes under falloffs, by cosine-weighted directions.
TEST_F(Occlusion, OfScenesUnderFalloffs) {
    constexpr double q = 0.25;
    struct Case {
        Scene scene;
        float size;
        Falloff falloff;
        double expected;
    };
    for (const Case& known : {Case{wall, 0.25F, step, 0.342519},
                              {wall, 0.25F, linear, 0.168214},
                              {wall, 0.25F, quadratic, 0.240864},
                              {wall, 0.25F, alchemy, 0.252626},
                              {wall, 2.0F, alchemy, 0.106103},
                              {wall, 0.25F, one, 0.5},
                              {ceiling, 0.25F, step, 1 - q * q},
                              {ceiling, 0.25F, linear, (1 - q) * (1 - q)},
                              {ceiling, 0.25F, quadratic, 1 - q * q + 2 * q * q * std::log(q)},
                              {inside, 0.25F, linear, 2.0 / 3.0},
                              {inside, 0.25F, quadratic, 1 - 0.25 / 2},
                              {inside, 1.0F, step, 0.25},
                              {inside, 1.0F, linear, 1.0 / 12.0},
                              {ball, 2.0F, one, 0.216506},
                              {ball, 4.0F, one, 0.0541266}})
        EXPECT_NEAR(rays(known.scene, known.size, known.falloff), known.expected, 1e-3)
            << known.scene << ' ' << known.size << ' ' << known.falloff;
    EXPECT_NEAR(rays(ceiling, 0.25F, one), 1, 1e-6);
}

// Halton points do better than the 4 sigma / sqrt(N) of independent ones.
constexpr double tolerance = 4 * 0.5 / 362.0;

// A kernel of points implies a falloff: 1 minus the distribution of its radius.
TEST_F(Occlusion, PointsOfARadiusLawEstimateItsFalloff) {
    for (const Falloff law : {linear, quadratic, cubic}) {
        for (const Scene scene : {ceiling, wall, inside}) {
            EXPECT_NEAR(points(scene, 0.25F, law), rays(scene, 0.25F, law), tolerance) << scene << law;
        }
    }
    EXPECT_NEAR(points(ceiling, 0.25F, linear), 0.5625, tolerance);
}

TEST_F(Occlusion, BothNormalisedFormsEstimateTheSameIntegral) {
    for (const Scene scene : {ceiling, wall, inside, ball}) {
        const float size = scene == ball ? 2.0F : 0.25F;
        const Falloff weight = scene == ball ? one : linear;
        EXPECT_NEAR(rays(scene, size, weight, uniform), rays(scene, size, weight, cosine), 2e-3) << scene;
    }
}

// What TSSAO-3 and the Monte-Carlo form of CS-2.4 give as printed, where everything is blocked.
TEST_F(Occlusion, PrintedFormsMissTheFactor) {
    EXPECT_NEAR(rays(inside, 1.0F, one, cosine), 1.0, 1e-6);
    EXPECT_NEAR(rays(inside, 1.0F, one, uniform), 1.0, 1e-3);
    EXPECT_NEAR(rays(inside, 1.0F, one, uniform_printed), 0.5, 1e-3);
    EXPECT_NEAR(rays(inside, 1.0F, one, cosine_printed), 2.0 / 3.0, 1e-3);
    EXPECT_NEAR(rays(ceiling, 0.1F, linear, cosine), 0.81, 1e-3);
    EXPECT_NEAR(1.5 * rays(ceiling, 0.1F, linear, cosine_printed), 0.85, 1e-3);
}

// Without the clamp the half space below the surface takes away what the one above gives.
TEST_F(Occlusion, UnclampedCosineOfPrintCancels) {
    const Function<float(vec3, vec3)> clamped(lab, "gloam/occlusion/cosine.glsl", "gloam_sample_cosine");
    const Function<float(vec3, vec3)> printed(lab, "printed.glsl", "printed_cosine");
    const vec3 n(0, 0, 1);
    EXPECT_NEAR(printed(vec3(3, 0, -4), n), -0.8, 1e-6);
    double clamped_sum = 0.0;
    double printed_sum = 0.0;
    for (const float z : {-0.9F, -0.5F, -0.1F, 0.1F, 0.5F, 0.9F}) {  // uniform directions: z is uniform
        const vec3 direction(std::sqrt(1.0F - z * z), 0.0F, z);
        clamped_sum += static_cast<double>(clamped(direction, n));
        printed_sum += static_cast<double>(printed(direction, n));
    }
    EXPECT_NEAR(4 * clamped_sum / 6, 1.0, 1e-6);
    EXPECT_NEAR(4 * printed_sum / 6, 0.0, 1e-6);
}

// Dividing before subtracting leaves hundreds of ULP near the radius.
TEST_F(Occlusion, LinearFalloffIsAccurateUpToItsRadius) {
    const auto exact = [](double d, double radius) { return d < radius ? 1.0 - d / radius : 0.0; };
    const check::Domain domain{check::uniform(0.99, 1.0), check::uniform(1.0, 1.01)};
    const auto check_function = [&](const std::string& file, const std::string& function) {
        return check::Function<float(float, float)>(lab, file, function).compare(exact, domain, {.ulp = 1.5});
    };
    const check::Answer ours = check_function("gloam/occlusion/falloff.glsl", "gloam_falloff_linear");
    EXPECT_TRUE(ours.passed()) << ours;
    EXPECT_GT(check_function("printed.glsl", "printed_falloff_linear").max_ulp, 100.0);
}

// cos(s, p, n) as printed, read as the cosine of s: moving the scene would change the occlusion.
TEST_F(Occlusion, FoxComptonDoesNotDependOnTheOrigin) {
    const Function<float(vec3, vec3, vec3, float)> printed(lab, "printed.glsl", "printed_fox_compton");
    const vec3 n(0, 0, 1);
    const vec3 p(0, 0, -5);
    const vec3 s(0.5F, 0, -4.5F);
    const vec3 shift(0, 0, 16);
    EXPECT_EQ(printed(p, n, s, 0.1F), 0.0F);
    EXPECT_GT(printed(p + shift, n, s + shift, 0.1F), 1.0F);
}

// Methods that count single points: Alchemy, ISSAO, Crytek, Filion and McNaughton.
class Points : public Estimates {
  protected:
    Function<float(vec3, vec3, float, float, float)> alchemy_of{lab, "gloam/occlusion/alchemy.glsl",
                                                                "gloam_contribution_alchemy"};
    Function<float(vec3, vec3, float, float, float, float)> issao_of{lab, "gloam/occlusion/issao.glsl",
                                                                     "gloam_contribution_issao"};
    template <class Type, class... Arguments>
    double of(const std::string& function, const Arguments&... arguments) const {
        return mean<Type>("groove.glsl", function, arguments...);
    }
};

// Planes through p at any tilt to the view: taps in the tangent plane.
std::vector<std::pair<vec3, vec3>> tangent_taps() {
    std::vector<std::pair<vec3, vec3>> taps;
    for (const double tilt : {0.0, 0.3, 0.9, 1.3, 1.55}) {
        for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
            const vec3 n(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                         std::cos(tilt));
            const vec3 t(std::cos(tilt) * std::cos(azimuth), std::cos(tilt) * std::sin(azimuth),
                         -std::sin(tilt));
            taps.emplace_back(0.7F * t, n);
            taps.emplace_back(-0.2F * t + 0.3F * glm::cross(n, t), n);
        }
    }
    return taps;
}

TEST_F(Points, BarePlaneAtAnyTiltIsOpen) {
    for (const auto& [offset, normal] : tangent_taps()) {
        EXPECT_EQ(alchemy_of(offset, normal, 1e-5F, 1e-5F, 1.0F), 0.0F);
        EXPECT_LT(alchemy_of(offset, normal, 0.0F, 1e-5F, 1.0F), 1e-6F);  // rounding of the offset alone
        EXPECT_EQ(issao_of(offset, normal, 1.75F, 0.4F, 0.022F, 0.00016F), 0.0F);
    }
}

// E[occ] = (4 sigma / (pi r)) cos(beta) artanh(sin(beta)) for taps uniform on a disc: T12. As printed,
// without the factor 2 sigma, it would be half of that at sigma = 1.
TEST_F(Points, AlchemyOfAGroove) {
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const double beta = degrees * pi / 180.0;
        for (const double radius : {1.0, 2.0}) {
            const double m = of<vec2(float, float, unsigned, unsigned)>(
                "alchemy_groove", static_cast<float>(std::tan(beta)), static_cast<float>(radius));
            const double exact = 4.0 / (pi * radius) * std::cos(beta) * std::atanh(std::sin(beta));
            EXPECT_NEAR(2.0 * m, exact, 4e-3 * exact) << degrees << " " << radius;
        }
    }
    EXPECT_NEAR(4.0 / pi * std::cos(pi / 4) * std::atanh(std::sin(pi / 4)), 0.793515, 1e-6);
}

TEST_F(Points, EveryParameterOfIssaoCounts) {
    const vec3 v(0.5F, 0, 0.5F);
    const vec3 n(0, 0, 1);
    const float base = issao_of(v, n, 1.0F, 0.4F, 0.02F, 0.01F);
    EXPECT_NEAR(issao_of(v, n, 1.0F, 0.8F, 0.02F, 0.01F), 2 * base, 1e-6);
    EXPECT_LT(issao_of(v, n, 1.0F, 0.4F, 0.04F, 0.01F), 0.99F * base);
    EXPECT_LT(issao_of(v, n, 1.0F, 0.4F, 0.02F, 0.02F), 0.99F * base);
}

// Constants of figure 3 in a groove of 45 degrees; area-uniform offsets give half of the polar ones.
TEST_F(Points, IssaoOfAGroove) {
    using Groove = vec2(float, float, float, float, float, bool, unsigned, unsigned);
    const double polar = of<Groove>("issao_groove", 1.0F, 1.75F, 0.4F, 0.022F, 0.00016F, true);
    const double even = of<Groove>("issao_groove", 1.0F, 1.75F, 0.4F, 0.022F, 0.00016F, false);
    EXPECT_NEAR(1.06 * polar, 0.1330, 5e-4);
    EXPECT_NEAR(1.06 * even, 0.0677, 5e-4);
}

// T6: a plane is half occluded at any tilt, an inner corner of 90 degrees three quarters, a convex edge one
// quarter.
TEST_F(Points, CrytekBeforeTheRemap) {
    using Ball = vec2(int, float, unsigned, unsigned);
    for (const float slope : {0.0F, 0.7F, 3.0F, 20.0F})
        EXPECT_NEAR(of<Ball>("crytek_ball", 0, slope), 0.5, 1e-3) << slope;
    EXPECT_NEAR(of<Ball>("crytek_ball", 1, 0.0F), 0.75, 1e-3);
    EXPECT_NEAR(of<Ball>("crytek_ball", 2, 0.0F), 0.25, 1e-3);
}

TEST_F(Points, FilionLeavesAPlaneOpen) {
    for (const float slope : {0.0F, 0.7F, 3.0F, 20.0F}) {
        const double m = of<vec2(float, float, unsigned, unsigned)>("filion_half_ball", slope, 1.0F);
        EXPECT_LT(m, 1e-4) << slope;  // points within rounding of the plane
    }
}

// Methods that pair opposite samples: volumetric obscurance and angle-based occlusion.
enum Ground { plane, groove, step_up };

class Pairs : public Estimates {
  protected:
    template <class Type>
    Function<Type> volume(const std::string& function) const {
        return {lab, "gloam/occlusion/volumetric.glsl", "gloam_" + function};
    }
    template <class Type, class... Arguments>
    double quotient(const std::string& function, const Arguments&... arguments) const {
        const glm::dvec2 sum = sums<Type>("pairs.glsl", function, arguments...);
        return sum.x / sum.y;
    }
    double lines(Ground ground, float size, bool by_chord = true) const {
        return quotient<vec2(int, float, bool, unsigned, unsigned)>("lines", int{ground}, size, by_chord);
    }
    double tangent_sphere(Ground ground, float size, vec3 normal) const {
        return quotient<vec2(int, float, vec3, unsigned, unsigned)>("tangent_sphere", int{ground}, size,
                                                                    normal);
    }
    float angles(Ground ground, float size, vec3 normal, bool cubic, float bias) const {
        const Function<float(int, float, vec3, bool, float, unsigned)> kernel(lab, "pairs.glsl",
                                                                              "angle_pairs");
        return kernel(int{ground}, size, normal, cubic, bias, 1024U);
    }
};

// CS-3.5 as published: what lies outside the sphere towards the eye is another object. At half chord 1.
TEST_F(Pairs, WhatStandsInFrontOfTheBallIsNotBelieved) {
    const auto ratio = volume<float(float, float)>("line_ratio");
    const auto pair = volume<vec2(vec2, float, float)>("line_pair");
    const auto solid_part = [&](float first, float second) {
        const vec2 solid = pair(vec2(ratio(first, 1.0F), ratio(second, 1.0F)), 0.35F, 1.0F);
        return 0.5F * (solid.x + solid.y);
    };
    EXPECT_EQ(solid_part(5.0F, 0.0F), 0.5F);
    EXPECT_EQ(solid_part(5.0F, 5.0F), 0.5F);
    EXPECT_EQ(solid_part(1.0F, 0.0F), 0.75F);      // on the sphere still
    EXPECT_EQ(solid_part(-5.0F, 0.0F), 0.5F);      // far behind
    EXPECT_EQ(solid_part(-infinity, 0.5F), 0.5F);  // background
    EXPECT_EQ(solid_part(0.5F, -0.25F), 0.5625F);  // both believed: (0.75 + 0.375) / 2
}

// T6 and T12: a plane is half solid at any tilt; the plain mean of the published shader is too large in a
// groove.
TEST_F(Pairs, VolumetricObscurance) {
    for (const float slope : {0.0F, 0.5F, 2.0F, 20.0F}) EXPECT_NEAR(lines(plane, slope), 0.5, 1e-3) << slope;
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const double beta = degrees * pi / 180;
        EXPECT_NEAR(lines(groove, static_cast<float>(std::tan(beta))), 0.5 + beta / (2 * pi), 1e-3)
            << degrees;
    }
    EXPECT_NEAR(lines(groove, 1.0F, false), 0.6466, 1e-3);
    for (const double x : {0.1, 0.5, 0.9})
        EXPECT_NEAR(lines(step_up, static_cast<float>(x)), 0.5 + (2 - 3 * x + x * x * x) / 8, 1e-3) << x;
}

// The sphere that touches the surface: a plane leaves it empty, a groove cuts a cap off it.
TEST_F(Pairs, TangentSphere) {
    for (const float slope : {0.0F, 0.5F, 2.0F}) {
        const float s = std::sqrt(1 + slope * slope);
        EXPECT_LT(tangent_sphere(plane, slope, vec3(-slope / s, 0, 1 / s)), 1e-6) << slope;
    }
    for (const double degrees : {30.0, 45.0, 80.0}) {
        const double c = std::cos(degrees * pi / 180);
        const auto slope = static_cast<float>(std::tan(degrees * pi / 180));
        EXPECT_NEAR(tangent_sphere(groove, slope, vec3(0, 0, 1)), (2 - 3 * c + c * c * c) / 4, 1e-3)
            << degrees;
    }
}

// T6: a plane at any tilt lacks nothing of pi; with the bias it exceeds pi, and is as open.
TEST_F(Pairs, AnglesOfAPlane) {
    for (const float slope : {0.0F, 0.5F, 2.0F, 10.0F}) {
        const float s = std::sqrt(1 + slope * slope);
        for (const bool cubic : {false, true}) {
            EXPECT_LT(angles(plane, slope, vec3(-slope / s, 0, 1 / s), cubic, 0.0F), 1e-6F) << slope << cubic;
            EXPECT_EQ(angles(plane, slope, vec3(-slope / s, 0, 1 / s), cubic, 0.08F), 0.0F) << slope << cubic;
        }
    }
}

// T12.
TEST_F(Pairs, AnglesOfAGroove) {
    EXPECT_NEAR(1 - angles(groove, 1.0F, vec3(0, 0, 1), false, 0.0F), 0.828708, 2e-6);
    EXPECT_NEAR(1 - angles(groove, 1.0F, vec3(0, 0, 1), true, 0.0F), 0.820736, 2e-6);
    EXPECT_LT(angles(groove, 1.0F, vec3(0, 0, 1), false, 0.08F), 0.15);
}

// Along the axes, and in 500 other directions.
std::vector<vec3> directions() {
    std::vector<vec3> all{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int i = 0; i < 500; ++i) {
        const float a = 0.7F * static_cast<float>(i);
        all.push_back(glm::normalize(vec3(std::cos(a), std::sin(1.3F * a), std::sin(2.1F * a))));
    }
    return all;
}

// A sample straight towards the eye, or straight away from it: a cosine in [-1, 1] whatever was rounded.
TEST_F(Pairs, CosinesOfEqualAndOppositeVectors) {
    const Function<float(vec3, vec3, vec3)> cosine(lab, "gloam/occlusion/angle_based.glsl",
                                                   "gloam_lifted_cosine");
    std::vector<std::tuple<vec3, vec3, vec3>> towards, along_the_normal, away;
    for (const vec3 view : directions()) {
        for (const float length : {0.1F, 1.0F, 3.0F}) {
            towards.emplace_back(length * view, view, view);
            along_the_normal.emplace_back(-length * view, view, view);
            away.emplace_back(length * view, view, -view);
        }
    }
    for (const float result : cosine(towards)) EXPECT_TRUE(result <= 1.0F && result > 1.0F - 1e-6F) << result;
    for (const float result : cosine(along_the_normal)) EXPECT_EQ(result, 0.0F);
    for (const float result : cosine(away)) EXPECT_TRUE(result >= -1.0F && result < -1.0F + 1e-6F) << result;
}

}  // namespace gloam::occlusion_test
