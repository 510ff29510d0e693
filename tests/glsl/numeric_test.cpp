// SPDX-License-Identifier: MIT
// Edges of the elementary functions, which the sweep of the catalogue does not single out.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "support/lab.hpp"

namespace gloam::numeric_test {

using check::Kernel;

constexpr auto infinity = std::numeric_limits<float>::infinity();
constexpr auto nan = std::numeric_limits<float>::quiet_NaN();
constexpr auto pi = std::numbers::pi_v<float>;

class Numeric : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

TEST_F(Numeric, TurnsAreExactAtQuartersAndOddAndEven) {
    const Kernel<glm::vec2(float)> f(lab, "gloam/numeric/sincos.glsl", "gloam_sincos_turns");
    const std::array<glm::vec2, 4> quarters{glm::vec2(1, 0), {0, 1}, {-1, 0}, {0, -1}};
    for (const int turns : {0, 1, 7, 100'000}) {
        for (std::size_t q = 0; q < 4; ++q) {
            const float t = static_cast<float>(turns) + 0.25F * static_cast<float>(q);
            EXPECT_EQ(f(t), quarters[q]) << t;
        }
    }
    for (const float t : {0.1F, 0.3F, 0.77F, 12.34F}) {
        EXPECT_EQ(f(-t).x, f(t).x);
        EXPECT_EQ(f(-t).y, -f(t).y);
    }
    for (const float t : {0x1p23F, 3.4e38F, -3.4e38F, infinity, -infinity, nan}) {
        EXPECT_EQ(f(t), glm::vec2(1, 0)) << t;
    }
}

TEST_F(Numeric, RadiansOutsideTheDomainCountAsZero) {
    const Kernel<glm::vec2(float)> f(lab, "gloam/numeric/sincos.glsl", "gloam_sincos");
    for (const float a : {0.0F, 65536.01F, -1e30F, infinity, nan}) EXPECT_EQ(f(a), glm::vec2(1, 0)) << a;
    EXPECT_NEAR(f(65536.0F).x, std::cos(65536.0), 2e-7);
    EXPECT_NEAR(f(-65536.0F).y, std::sin(-65536.0), 2e-7);
}

TEST_F(Numeric, SquareRootOfZeroIsZero) {
    const Kernel<float(float)> f(lab, "gloam/numeric/square_root.glsl", "gloam_sqrt");
    for (const float x : {0.0F, -0.0F, 1e-40F, -1.0F, -infinity, nan}) EXPECT_EQ(f(x), 0.0F) << x;
    EXPECT_EQ(f(infinity), infinity);
    EXPECT_EQ(f(4.0F), 2.0F);
    EXPECT_NEAR(f(3.4e38F), 1.8439089e19F, 4e12F);
}

TEST_F(Numeric, ArcFunctionsTakeWhatIsOutsideToTheNearerEnd) {
    const Kernel<float(float)> acos(lab, "gloam/numeric/inverse_trigonometry.glsl", "gloam_acos");
    for (const float x : {1.0F, 1.0000001F, 5.0F, infinity}) {
        EXPECT_EQ(acos(x), 0.0F);
        EXPECT_EQ(acos(-x), pi);
    }
    EXPECT_EQ(acos(nan), pi / 2);
    EXPECT_NEAR(acos(0.5F), pi / 3, 3e-7);
}

TEST_F(Numeric, DirectionsOfAxesQuadrantsAndInfinities) {
    const Kernel<float(float, float)> f(lab, "gloam/numeric/inverse_trigonometry.glsl", "gloam_atan2");
    EXPECT_EQ(f(0.0F, 0.0F), 0.0F);
    EXPECT_EQ(f(1e-40F, -1e-40F), 0.0F);
    EXPECT_EQ(f(0.0F, 2.0F), 0.0F);
    EXPECT_EQ(f(3.0F, 0.0F), pi / 2);
    EXPECT_EQ(f(0.0F, -2.0F), pi);
    EXPECT_EQ(f(-0.0F, -2.0F), pi);
    EXPECT_EQ(f(-3.0F, 0.0F), -pi / 2);
    EXPECT_EQ(f(infinity, infinity), f(1.0F, 1.0F));
    EXPECT_EQ(f(-infinity, -infinity), f(-1.0F, -1.0F));
    EXPECT_EQ(f(1.0F, -infinity), pi);
    EXPECT_EQ(f(-infinity, 1.0F), -pi / 2);
    for (const float scale : {1e-37F, 1e-10F, 1.0F, 1e37F}) {
        for (const float a : {0.1F, 0.7F, 1.0F, 2.0F, 3.0F, -0.1F, -1.0F, -2.5F}) {
            EXPECT_NEAR(f(scale * std::sin(a), scale * std::cos(a)), a, 4e-7) << a << " at " << scale;
        }
    }
    for (const float y : {nan, 1.0F}) EXPECT_EQ(f(y, nan), 0.0F);
    EXPECT_EQ(f(nan, 1.0F), 0.0F);
}

// Vulkan lets a driver reorder what is not `precise`: the reductions of arguments must not be undone by it.
TEST_F(Numeric, WhateverOrderADriverTakesTheErrorIsBounded) {
    const check::Lab shipped(
        {.device = std::string(check::interpreter_name), .include_roots = {GLOAM_GLSL_DIR}});
    const std::string forward = "gloam/numeric/sincos.glsl";
    const std::string inverse = "gloam/numeric/inverse_trigonometry.glsl";
    const check::RunOptions options{.inputs = 1024};
    const auto error = [&](const check::Answer& answer) {
        EXPECT_EQ(answer.verdict, check::Verdict::rules);
        EXPECT_EQ(answer.unbounded, 0U) << answer.function;
        return answer.guarantee.absolute;
    };
    const check::Values cosine = check::uniform(-1, 1);
    EXPECT_LT(error(check::check_rules<glm::vec2(float)>(shipped, forward, "gloam_sincos_turns",
                                                         {check::uniform(-4, 4)}, options)),
              4e-6);
    EXPECT_LT(error(check::check_rules<glm::vec2(float)>(shipped, forward, "gloam_sincos",
                                                         {check::uniform(-100, 100)}, options)),
              4e-6);
    EXPECT_LT(error(check::check_rules<float(float)>(shipped, inverse, "gloam_acos", {cosine}, options)),
              2e-4);
    EXPECT_LT(error(check::check_rules<float(float, float)>(shipped, inverse, "gloam_atan2", {cosine, cosine},
                                                            options)),
              2e-4);
}

}  // namespace gloam::numeric_test
