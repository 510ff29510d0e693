// SPDX-License-Identifier: MIT
// Methods that pair opposite samples: volumetric obscurance and angle-based occlusion.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/lab.hpp"

namespace gloam::pairs_test {

using check::Kernel;
using glm::vec2;
using glm::vec3;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double pi = std::numbers::pi;

enum Scene { plane, groove, wall };

class Pairs : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);

    template <class Function>
    Kernel<Function> volume(const std::string& function) const {
        return {lab, "gloam/occlusion/volumetric.glsl", "gloam_" + function};
    }
    template <class Function>
    Kernel<Function> angle(const std::string& function) const {
        return {lab, "gloam/occlusion/angle_based.glsl", "gloam_" + function};
    }
    // The quotient of two sums over 2^17 samples.
    template <class Function, class... Arguments>
    double quotient(const std::string& function, const Arguments&... arguments) const {
        const Kernel<Function> kernel(lab, "pairs.glsl", function);
        std::vector<typename Kernel<Function>::Inputs> inputs;
        for (unsigned b = 0; b < 512; ++b) inputs.emplace_back(arguments..., b * 256U, 256U);
        glm::dvec2 sum(0);
        for (const vec2 part : kernel(inputs)) sum += glm::dvec2(part);
        return sum.x / sum.y;
    }
    double lines(Scene scene, float size, bool by_chord = true) const {
        return quotient<vec2(int, float, bool, unsigned, unsigned)>("lines", int{scene}, size, by_chord);
    }
    double tangent_sphere(Scene scene, float size, vec3 normal) const {
        return quotient<vec2(int, float, vec3, unsigned, unsigned)>("tangent_sphere", int{scene}, size,
                                                                    normal);
    }
    float angles(Scene scene, float size, vec3 normal, bool cubic, float bias) const {
        const Kernel<float(int, float, vec3, bool, float, unsigned)> kernel(lab, "pairs.glsl", "angle_pairs");
        return kernel(int{scene}, size, normal, cubic, bias, 1024U);
    }
};

TEST_F(Pairs, ChordsAndTheirSolidPart) {
    const auto chord = volume<float(vec2, float)>("chord_half_height");
    EXPECT_EQ(chord(vec2(0), 2.0F), 2.0F);
    EXPECT_NEAR(chord(vec2(0.6F, 0), 2.0F), 1.6, 1e-6);
    EXPECT_EQ(chord(vec2(1, 0.1F), 2.0F), 0.0F);
    EXPECT_EQ(chord(vec2(NAN), 2.0F), 0.0F);
    EXPECT_EQ(chord(vec2(0), -2.0F), 0.0F);
    const auto q = volume<float(float, float)>("line_occlusion");
    EXPECT_EQ(q(0.0F, 2.0F), 0.5F);  // T30
    EXPECT_EQ(q(2.0F, 2.0F), 1.0F);
    EXPECT_EQ(q(-2.0F, 2.0F), 0.0F);
    EXPECT_EQ(q(1.0F, 2.0F), 0.75F);
    EXPECT_EQ(q(-infinity, 2.0F), 0.0F);  // background
    EXPECT_EQ(q(1.0F, 0.0F), 0.5F);
    EXPECT_EQ(q(NAN, 2.0F), 0.5F);
    EXPECT_EQ(q(1.0F, NAN), 0.5F);
}

TEST_F(Pairs, PlacesOnAChordAreNotClamped) {
    const auto ratio = volume<float(float, float)>("line_ratio");
    for (const float h : {0.5F, 1.0F, 3.0F}) {
        for (const float height : {-7.0F, -1.0F, 0.0F, 0.25F, 1.0F, 5.0F})
            EXPECT_NEAR(ratio(height, h), (double{h} + double{height}) / (2.0 * double{h}), 1e-6);
    }
    EXPECT_EQ(ratio(-infinity, 2.0F), -infinity);  // background
    EXPECT_EQ(ratio(infinity, 2.0F), infinity);
    for (const float none : {0.0F, -1.0F, 1e-39F, infinity, NAN}) EXPECT_EQ(ratio(1.0F, none), 0.5F) << none;
    EXPECT_EQ(ratio(NAN, 2.0F), 0.5F);
}

// CS-3.5 as published: what lies outside the sphere towards the eye is another object. At half chord 1.
TEST_F(Pairs, WhatStandsInFrontOfTheBallIsNotBelieved) {
    const auto ratio = volume<float(float, float)>("line_ratio");
    const auto pair = volume<vec2(vec2, float, float)>("line_pair");
    const auto mean = [&](float first, float second) {
        const vec2 solid = pair(vec2(ratio(first, 1.0F), ratio(second, 1.0F)), 0.35F, 1.0F);
        return 0.5F * (solid.x + solid.y);
    };
    EXPECT_EQ(mean(5.0F, 0.0F), 0.5F);
    EXPECT_EQ(mean(5.0F, 5.0F), 0.5F);
    EXPECT_EQ(mean(1.0F, 0.0F), 0.75F);      // on the sphere still
    EXPECT_EQ(mean(-5.0F, 0.0F), 0.5F);      // far behind
    EXPECT_EQ(mean(-infinity, 0.5F), 0.5F);  // background
    EXPECT_EQ(mean(0.5F, -0.25F), 0.5625F);  // both believed: (0.75 + 0.375) / 2
}

TEST_F(Pairs, DisbelievedLines) {
    const auto pair = volume<vec2(vec2, float, float)>("line_pair");
    EXPECT_EQ(pair(vec2(0.5F, 0.75F), 0.35F, 1.0F), vec2(0.5F, 0.75F));
    EXPECT_EQ(pair(vec2(0.25F, 0.75F), 0.35F, 1.0F), vec2(0.25F, 0.75F));  // T31: q + 1 - q
    EXPECT_EQ(pair(vec2(0.0F, 0.75F), 0.35F, 1.0F), vec2(0.25F, 0.75F));
    EXPECT_EQ(pair(vec2(0.75F, NAN), 0.35F, 1.0F), vec2(0.75F, 0.25F));
    EXPECT_EQ(pair(vec2(0.1F, 0.2F), 0.35F, 1.0F), vec2(0.5F));
    EXPECT_EQ(pair(vec2(0.75F, 0.9F), 0.35F, 0.8F), vec2(0.75F, 0.25F));
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
        EXPECT_NEAR(lines(wall, static_cast<float>(x)), 0.5 + (2 - 3 * x + x * x * x) / 8, 1e-3) << x;
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
    const auto part = volume<float(vec3, vec3, float)>("tangent_sphere_occlusion");
    EXPECT_EQ(part(vec3(0, 0, 0.5F), vec3(0, 0, 1), 1.0F), 0.5F);
    EXPECT_EQ(part(vec3(0, 0, 1), vec3(0, 0, 1), 1.0F), 1.0F);
    EXPECT_EQ(part(vec3(3, 0, 1), vec3(0, 0, 1), 1.0F), 0.0F);
    EXPECT_EQ(part(vec3(NAN), vec3(0, 0, 1), 1.0F), 0.0F);
    EXPECT_EQ(part(vec3(0, 0, 1), vec3(0, 0, 1), 0.0F), 0.0F);
}

// T28.
TEST_F(Pairs, ApproximationsOfTheArcCosine) {
    const auto error = [this](const std::string& name) {
        const Kernel<float(float)> f(lab, "gloam/numeric/acos_approximation.glsl", "gloam_acos_" + name);
        EXPECT_NEAR(f(-1.0F), pi, 1e-6) << name;
        EXPECT_NEAR(f(0.0F), pi / 2, 1e-6) << name;
        EXPECT_NEAR(f(1.0F), 0.0, 1e-6) << name;
        EXPECT_EQ(f(1.5F), f(1.0F)) << name;
        EXPECT_EQ(f(-infinity), f(-1.0F)) << name;
        EXPECT_EQ(f(NAN), f(0.0F)) << name;
        EXPECT_NEAR(f(-0.3F) + f(0.3F), pi, 1e-6) << name;
        std::vector<std::tuple<float>> inputs;
        for (int i = 0; i <= 20000; ++i) inputs.emplace_back(static_cast<float>(i) / 10000.0F - 1.0F);
        const std::vector<float> results = f(inputs);
        double worst = 0.0;
        for (std::size_t i = 0; i < results.size(); ++i) {
            const double exact = std::acos(static_cast<double>(std::get<0>(inputs[i])));
            worst = std::max(worst, std::abs(static_cast<double>(results[i]) - exact));
        }
        return worst;
    };
    EXPECT_NEAR(error("cubic"), 0.178758, 1e-5);
    const Kernel<float(float)> cubic(lab, "gloam/numeric/acos_approximation.glsl", "gloam_acos_cubic");
    EXPECT_NEAR(cubic(-0.5F), 2 * pi / 3, 1e-6);
    EXPECT_NEAR(cubic(0.5F), pi / 3, 1e-6);
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

TEST_F(Pairs, LiftedSamples) {
    const auto cosine = angle<float(vec3, vec3, vec3)>("lifted_cosine");
    const vec3 view(0, 0, 1);
    EXPECT_NEAR(cosine(vec3(3, 0, 4), view, view), 0.8, 1e-6);
    EXPECT_NEAR(cosine(vec3(3, 0, -4), view, view), 0.0, 1e-6);  // lifted to the plane
    const vec3 tilted(-0.6F, 0, 0.8F);
    EXPECT_NEAR(cosine(vec3(1, 0, -1), tilted, view), 0.6, 1e-6);
    EXPECT_EQ(cosine(vec3(0, 0, -2), view, view), 0.0F);  // along -n: no direction is left
    EXPECT_EQ(cosine(1.7F * vec3(0.6F, 0, -0.8F), tilted, view), 0.0F);
    for (const vec3 nowhere : {vec3(0), vec3(NAN), vec3(0, 0, -infinity)})
        EXPECT_EQ(cosine(nowhere, view, view), 0.0F);
    EXPECT_EQ(cosine(vec3(1, 0, 0), vec3(0, 0, 1), vec3(NAN)), 0.0F);
}

// An invalid sample is replaced by the mirror image of its partner, not by its own as in the published
// shader.
TEST_F(Pairs, InvalidSamples) {
    const auto pair = angle<vec3(vec3, vec3, vec3, vec3, float)>("angle_pair");
    const vec3 view(0, 0, 1);
    const vec3 n(0, 0, 1);
    const vec3 valid(3, 0, 4);
    const vec3 below(4, 0, -3);
    const vec3 far_in_front(-3, 0, 40);
    const auto expect = [](vec3 got, vec3 want) { EXPECT_LT(glm::length(got - want), 1e-6F); };
    expect(pair(valid, below, n, view, 20.0F), vec3(0.8F, 0.0F, 1.0F));
    expect(pair(valid, far_in_front, n, view, 20.0F),
           vec3(0.8F, 0.0F, 0.5F));  // mirrored below the image plane
    expect(pair(far_in_front, below, n, view, 20.0F), vec3(0.6F, 0.0F, 0.5F));  // mirrored above
    expect(pair(far_in_front, far_in_front, n, view, 20.0F), vec3(0.0F));
    expect(pair(valid, vec3(NAN), n, view, 20.0F), vec3(0.8F, 0.0F, 0.5F));
    EXPECT_GT(pair(valid, far_in_front, n, view, 50.0F).y, 0.9F);  // the range counts
}

TEST_F(Pairs, LaterShaderOfTheEngine) {
    const auto step = angle<float(vec3, vec3, float, float)>("contribution_unreal");
    EXPECT_NEAR(step(vec3(0, 0, 2), vec3(0, 0, 1), 0.0F, 0.8F), 0.4, 1e-6);
    EXPECT_NEAR(step(vec3(0, 0, 2), vec3(0, 0, 1), 0.0F, 1.6F), 0.8, 1e-6);
    EXPECT_NEAR(step(vec3(0, 0, 0.1F), vec3(0, 0, 1), 0.0F, 0.8F), 8.0, 1e-5);  // the side limits it
    EXPECT_EQ(step(vec3(1, 0, 0), vec3(0, 0, 1), 0.0F, 0.8F), 0.0F);
    EXPECT_EQ(step(vec3(1, 0, 0.1F), vec3(0, 0, 1), 0.1F, 0.8F), 0.0F);  // no higher than the bias
    for (const vec3 nowhere : {vec3(0), vec3(NAN)}) EXPECT_EQ(step(nowhere, vec3(0, 0, 1), 0.0F, 0.8F), 0.0F);
    const auto side = angle<float(float)>("unreal_side");
    EXPECT_EQ(side(0.5F), 0.25F);
    EXPECT_EQ(side(NAN), 1.0F);
    const auto visibility = angle<float(float, float, float)>("unreal_visibility");
    EXPECT_EQ(visibility(0.5F, 1.0F, 1.0F), 0.5F);
    EXPECT_EQ(visibility(0.5F, 1.0F, 0.5F), 0.75F);
    EXPECT_NEAR(visibility(0.5F, 2.0F, 1.0F), 0.25, 1e-6);
    EXPECT_EQ(visibility(NAN, 2.0F, 1.0F), 1.0F);
    EXPECT_EQ(visibility(0.5F, 2.0F, NAN), 1.0F);
}

}  // namespace gloam::pairs_test
