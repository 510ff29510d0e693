// SPDX-License-Identifier: MIT
// The documented results for images of exact 0 and 1, sides of 0, and vectors that are equal, opposite,
// parallel or along an axis.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/lab.hpp"
#include "support/method_functions.hpp"

namespace gloam::exact_ends_test {

using glm::ivec2;
using glm::vec2;
using glm::vec3;
using glm::vec4;

class ExactEnds : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);

    static std::vector<vec3> directions() {
        std::vector<vec3> all{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
        for (int i = 0; i < 500; ++i) {
            const float a = 0.7F * static_cast<float>(i);
            all.push_back(glm::normalize(vec3(std::cos(a), std::sin(1.3F * a), std::sin(2.1F * a))));
        }
        return all;
    }
};

TEST_F(ExactEnds, NeighboursThatAreAllOpenOrAllBlockedAgree) {
    const check::Kernel<bool(ivec2, ivec2, float)> disagrees(lab, "gloam/filter/dual_resolution.glsl",
                                                             "gloam_dual_resolution_disagrees");
    const auto with = [&](auto occlusion) {
        return disagrees.with_images(
            {{"gloam_fetch_occlusion", check::make_image<float>(ivec2(5), occlusion)}},
            {ivec2(2), ivec2(5), 0.05F});
    };
    EXPECT_FALSE(with([](ivec2) { return 1.0F; }));
    EXPECT_FALSE(with([](ivec2) { return 0.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p.x < 2 ? 0.0F : 1.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p == ivec2(1) ? 1.0001F : 1.0F; }));
    EXPECT_TRUE(with([](ivec2 p) { return p == ivec2(1) ? -1e-6F : 0.0F; }));
}

struct History {
    float occlusion;
    float weight;
    unsigned index;
    float depth;
};

// Four texels of occlusion 1 and weight 100 are that at every position between them.
TEST_F(ExactEnds, AHistoryThatIsAllBlockedIsKeptEverywhere) {
    const check::Kernel<History(vec2, ivec2, float, float)> reprojected(
        lab, "gloam/temporal/reprojected_history.glsl", "gloam_reprojected_history");
    for (const float occlusion : {0.0F, 1.0F}) {
        const check::ImageSet images{
            {"gloam_fetch_history", check::make_image<vec4>(ivec2(40, 30), [&](ivec2) {
                 return vec4(occlusion, 100.0F, 7.0F, 5.0F);
             })}};
        std::vector<check::Kernel<History(vec2, ivec2, float, float)>::Inputs> inputs;
        for (int i = 0; i < 4000; ++i) {
            const double u = std::fmod(0.6180339887 * i, 1.0);
            const double v = std::fmod(0.7548776662 * i, 1.0);
            inputs.emplace_back(vec2(u, v), ivec2(40, 30), 5.0F, 0.02F);
        }
        for (const History& history : reprojected(inputs, images)) {
            EXPECT_NEAR(history.occlusion, occlusion, 1e-6);
            EXPECT_NEAR(history.weight, 100.0, 1e-4);
            EXPECT_EQ(history.index, 7U);
        }
        for (const ivec2 none : {ivec2(0, 30), ivec2(40, 0), ivec2(0)}) {
            EXPECT_EQ(reprojected.with_images(images, {vec2(0.5F), none, 5.0F, 0.02F}).weight, 0.0F);
        }
    }
}

// A sample straight towards the eye, or straight away from it: a cosine in [-1, 1] whatever was rounded.
TEST_F(ExactEnds, CosinesOfEqualAndOppositeVectors) {
    const check::Kernel<float(vec3, vec3, vec3)> cosine(lab, "gloam/occlusion/angle_based.glsl",
                                                        "gloam_lifted_cosine");
    for (const vec3 view : directions()) {
        for (const float length : {0.1F, 1.0F, 3.0F}) {
            const float towards = cosine(length * view, view, view);
            EXPECT_LE(towards, 1.0F);
            EXPECT_NEAR(towards, 1.0, 1e-6);
            EXPECT_EQ(cosine(-length * view, view, view), 0.0F);  // along -n
            const float away = cosine(length * view, view, -view);
            EXPECT_GE(away, -1.0F);
            EXPECT_NEAR(away, -1.0, 1e-6);
        }
    }
}

// Changes that do not span a plane have no curvature.
TEST_F(ExactEnds, ParallelStepsHaveNoCurvature) {
    const check::Kernel<vec2(vec3, vec3, vec3, vec3)> curvatures(lab, "gloam/geometry/curvature.glsl",
                                                                 "gloam_principal_curvatures");
    const vec3 turn(0.01F, 0.002F, 0.0F);
    for (const vec3 along : directions()) {
        for (const float factor : {1.0F, -1.0F, 0.5F, 3.0F, 0.0F}) {
            EXPECT_EQ(curvatures(0.01F * along, factor * 0.01F * along, turn, -turn), vec2(0)) << factor;
            EXPECT_EQ(curvatures(factor * 0.01F * along, 0.01F * along, turn, turn), vec2(0)) << factor;
        }
    }
}

// A point on a ball is inside it, where its normal does not matter.
TEST_F(ExactEnds, ABallBlocksThePointsOnIt) {
    const check::Kernel<float(vec3, vec3, float)> contribution(lab, "gloam/occlusion/sphere_proxy.glsl",
                                                               "gloam_contribution_sphere");
    for (const float radius : {0.25F, 3.0F}) {
        EXPECT_EQ(contribution(vec3(radius, 0, 0), vec3(0, 0, 1), radius), 1.0F);
        EXPECT_EQ(contribution(vec3(0, -radius, 0), vec3(0, 1, 0), radius), 1.0F);
        EXPECT_EQ(contribution(vec3(radius, 0, 0), vec3(0, 0, 1), std::nextafter(radius, 0.0F)), 0.0F);
    }
}

// Normals of lengths in [1e-15, 1e15].
TEST_F(ExactEnds, TheShortestAndTheLongestNormalAreNormals) {
    const check::Kernel<bool(vec3, vec3, float, effect::GatherCamera)> can(
        lab, "gloam/occlusion/gather_kernel.glsl", "gloam_can_gather");
    const auto with_length = [&](float length) {
        return can(vec3(0, 0, -1), vec3(0, 0, length), 1.0F,
                   effect::GatherCamera{vec2(1, -1), ivec2(8), false});
    };
    EXPECT_TRUE(with_length(1e-15F));
    EXPECT_FALSE(with_length(std::nextafter(1e-15F, 0.0F)));
    EXPECT_TRUE(with_length(1e15F));
    EXPECT_FALSE(with_length(1.000001e15F));
}

TEST_F(ExactEnds, LengthsOfVectorsThatHaveNone) {
    const check::Kernel<float(vec3)> length(lab, "gloam/geometry/length.glsl", "gloam_length");
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float none : {0.0F, 1e-40F, infinity, -infinity, NAN}) {
        EXPECT_EQ(length(vec3(none)), 0.0F) << none;
        EXPECT_EQ(length(vec3(none, none, 0)), 0.0F) << none;
        const bool finite = std::isfinite(none);
        EXPECT_NEAR(length(vec3(1, none, 2)), finite ? std::sqrt(5.0) : 0.0, 1e-6) << none;
    }
    for (const vec3 direction : directions()) EXPECT_NEAR(length(3.0F * direction), 3.0, 2e-6);
}

// A bias is scaled by any normal depth, of which the rounding of its quotient takes nothing away.
TEST_F(ExactEnds, BiasesOfTheSmallestAndTheLargestDepths) {
    const check::Kernel<float(float, float, float)> scaled(lab, "gloam/occlusion/bias.glsl",
                                                           "gloam_depth_bias");
    constexpr float least = 0x1p-126F;
    constexpr float most = 0x1p126F;
    constexpr float largest = std::numeric_limits<float>::max();
    for (const float reference : {least, 2.0F * least, 1.0F, 0.5F * most, most})
        EXPECT_EQ(scaled(0.25F, reference, reference), 0.25F) << reference;
    EXPECT_EQ(scaled(0.25F, 1.01F * most, 1.01F * most), 0.0F);
    EXPECT_EQ(scaled(0.25F, 1.0F, 0.5F * least), 0.0F);
    EXPECT_EQ(scaled(least, 1.0F, 1.0F), least);
    EXPECT_EQ(scaled(0.75F * largest, 1.25F, 1.0F), 0.9375F * largest);
    EXPECT_EQ(scaled(0.75F * largest, 1.5F, 1.0F), largest);
    EXPECT_EQ(scaled(std::numeric_limits<float>::infinity(), least, most), 0.0F);  // times a quotient of 0
}

// Normals of directions that are nearly parallel, or longer than unit vectors.
TEST_F(ExactEnds, NormalsOfShortAndLongProducts) {
    const check::Kernel<vec3(vec3, vec3, vec3)> facing(lab, "gloam/geometry/normal.glsl",
                                                       "gloam_facing_normal");
    const vec3 viewer(0, 0, 1);
    const auto normal = [&](float sine) { return facing(vec3(0, 1, 0), vec3(0, 0, sine), vec3(1, 0, 0)); };
    for (const float product : {1.001e-5F, 0.1F, 1.0F, 1.99F, 2.0F})
        EXPECT_NEAR(normal(product).x, 1.0, 1e-6) << product;
    for (const float none : {0.0F, 0.999e-5F, 2.001F, std::numeric_limits<float>::infinity(), NAN})
        EXPECT_EQ(normal(none), viewer) << none;
}

// Sums whose direction is lost: nothing of it agrees, as long as the quotient can be formed.
TEST_F(ExactEnds, OpenDirectionsOfTheSmallestAndTheLargestSums) {
    const check::Kernel<float(vec4)> agreement(lab, "gloam/shading/bent_normal.glsl", "gloam_bent_length");
    for (const float sum : {0x1p-126F, 1.5F * 0x1p-126F, 1.0F, 0.75F * 0x1p126F, 0x1p126F})
        EXPECT_EQ(agreement(vec4(0, 0, 0, sum)), 0.0F) << sum;
    for (const float none : {0.0F, -1.0F, 1.01F * 0x1p126F, 0x1p127F, NAN})
        EXPECT_EQ(agreement(vec4(0, 0, 0, none)), 1.0F) << none;
    EXPECT_EQ(agreement(vec4(0, 0, 1.0001F, 1)), 1.0F);
}

// Ends of what a function takes, both included.
TEST_F(ExactEnds, ArgumentsAtTheEndsOfTheirRange) {
    const check::Kernel<vec2(float)> sincos(lab, "gloam/numeric/sincos.glsl", "gloam_sincos");
    const check::Kernel<float(float)> turns(lab, "gloam/numeric/sincos.glsl", "gloam_turns");
    for (const float end : {65536.0F, -65536.0F}) {
        EXPECT_NEAR(sincos(end).x, std::cos(double{end}), 5e-7);
        EXPECT_NEAR(turns(end), double{end} / (2.0 * std::acos(-1.0)), 0.01);
        EXPECT_EQ(turns(std::nextafter(end, 2.0F * end)), 0.0F);
        EXPECT_EQ(sincos(std::nextafter(end, 2.0F * end)), vec2(1, 0));
    }
    const check::Kernel<bool(float)> sees(lab, "gloam/occlusion/gather_kernel.glsl", "gloam_tap_sees");
    for (const float end : {1e-18F, 1.5e-18F, 0.75e18F, 1e18F}) EXPECT_TRUE(sees(end)) << end;
    for (const float none : {0.0F, 0.99e-18F, 1.01e18F, -1.0F, NAN}) EXPECT_FALSE(sees(none)) << none;
}

// Whatever the bits of a NaN are.
TEST_F(ExactEnds, NoNaNIsFinite) {
    const check::Kernel<bool(float)> finite(lab, "gloam/geometry/finite.glsl", "gloam_is_finite");
    const check::Kernel<bool(vec2)> finite2(lab, "gloam/geometry/finite.glsl", "gloam_is_finite2");
    const check::Kernel<bool(vec3)> finite3(lab, "gloam/geometry/finite.glsl", "gloam_is_finite3");
    const check::Kernel<bool(vec4)> finite4(lab, "gloam/geometry/finite.glsl", "gloam_is_finite4");
    for (const std::uint32_t bits : {0x7F800000U, 0x7FC00001U, 0xFFFFFFFFU, 0x7FD5AAAAU}) {
        const float none = std::bit_cast<float>(bits);
        EXPECT_FALSE(finite(none) || finite2(vec2(0, none)) || finite3(vec3(0, none, 0)) ||
                     finite4(vec4(none, 0, 0, 0)))
            << bits;
    }
}

TEST_F(ExactEnds, NeighboursOnAndBesideThePlane) {
    const check::Kernel<float(vec3, vec3, float, float)> weight(lab, "gloam/occlusion/separable.glsl",
                                                                "gloam_separable_weight");
    const vec3 up(0, 0, 1);
    EXPECT_EQ(weight(vec3(0), up, 1.0F, 0.0F), 1.0F);
    EXPECT_GT(weight(vec3(0.5F, 0, 0.125F), up, 1.0F, 0.125F), 0.8F);
    EXPECT_GT(weight(vec3(0.5F, 0, -0.125F), up, 1.0F, 0.125F), 0.8F);
    EXPECT_EQ(weight(vec3(0.5F, 0, 0.126F), up, 1.0F, 0.125F), 0.0F);
    EXPECT_EQ(weight(vec3(0.5F, 0, -0.126F), up, 1.0F, 0.125F), 0.0F);
    EXPECT_EQ(weight(vec3(NAN, 0, 0), up, 1.0F, 1.0F), 0.0F);
    EXPECT_EQ(weight(vec3(0), up, 1.0F, NAN), 0.0F);
}

}  // namespace gloam::exact_ends_test
