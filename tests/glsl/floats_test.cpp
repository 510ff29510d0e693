// SPDX-License-Identifier: MIT
// What holds of the library's floats, whatever their rounding is, beside known values and budgets.
#include "support/lab.hpp"

namespace gloam::floats_test {

using judge::Function;

class Floats : public testing::Test {
  protected:
    subject::Lab lab = test::make_lab();
};

// Whatever the bits of a NaN are.
TEST_F(Floats, NoNaNIsFinite) {
    const std::string file = "gloam/geometry/background.glsl";
    const Function<bool(float)> finite(lab, file, "gloam_is_finite");
    const Function<bool(glm::vec2)> finite2(lab, file, "gloam_is_finite2");
    const Function<bool(glm::vec3)> finite3(lab, file, "gloam_is_finite3");
    const Function<bool(glm::vec4)> finite4(lab, file, "gloam_is_finite4");
    for (const std::uint32_t bits : {0x7F800000U, 0x7FC00001U, 0xFFFFFFFFU, 0x7FD5AAAAU}) {
        const float none = std::bit_cast<float>(bits);
        EXPECT_FALSE(finite(none) || finite2(glm::vec2(0, none)) || finite3(glm::vec3(0, none, 0)) ||
                     finite4(glm::vec4(none, 0, 0, 0)))
            << bits;
    }
}

// Changes that do not span a plane have no curvature, and lengths are those of their vectors in any
// direction.
TEST_F(Floats, OfVectorsInAnyDirection) {
    const Function<glm::vec2(glm::vec3, glm::vec3, glm::vec3, glm::vec3)> curvatures(
        lab, "gloam/geometry/surface.glsl", "gloam_principal_curvatures");
    const Function<float(glm::vec3)> length(lab, "gloam/geometry/vector.glsl", "gloam_length");
    const glm::vec3 turn(0.01F, 0.002F, 0.0F);
    std::vector<std::tuple<glm::vec3, glm::vec3, glm::vec3, glm::vec3>> parallel;
    std::vector<std::tuple<glm::vec3>> vectors;
    for (int i = 0; i < 500; ++i) {
        const float a = 0.7F * static_cast<float>(i);
        const glm::vec3 direction =
            glm::normalize(glm::vec3(std::cos(a), std::sin(1.3F * a), std::sin(2.1F * a)));
        vectors.emplace_back(3.0F * direction);
        for (const float factor : {1.0F, -1.0F, 0.5F, 3.0F, 0.0F}) {
            parallel.emplace_back(0.01F * direction, factor * 0.01F * direction, turn, -turn);
            parallel.emplace_back(factor * 0.01F * direction, 0.01F * direction, turn, turn);
        }
    }
    EXPECT_THAT(curvatures(parallel), Each(glm::vec2(0)));
    EXPECT_THAT(length(vectors), Each(testing::FloatNear(3.0F, 2e-6F)));
}

TEST_F(Floats, ABlendOfAConstantIsThatConstant) {
    const Function<glm::vec2(float, float, float, float, float)> blend(lab, "gloam/temporal/blend.glsl",
                                                                       "gloam_blend");
    for (const float value : {0.0F, 0.1F, 0.5F, 0.99999994F, 1.0F})
        for (const float weight : {1.0F, 7.0F, 333.0F, 500.0F})
            EXPECT_EQ(blend(value, weight, value, 16.0F, 500.0F).x, value) << weight;
}

// The image is smaller than the size passed to the shader, so reading a neighbour is a fault. A pixel that
// passes has read none.
TEST_F(Floats, AConvergedPixelReadsNoNeighbour) {
    const Function<float(glm::ivec2, glm::ivec2, glm::ivec2, int, float, float)> filter{
        lab, "gloam/filter/convergence_filter.glsl", "gloam_convergence_filter"};
    const auto run = [&](float convergence) {
        const auto value = [&](glm::ivec2) { return glm::vec2(0.3F, convergence); };
        const subject::ImageSet images{
            {"gloam_fetch_occlusion_convergence", subject::make_image<glm::vec2>({1, 1}, value)},
            {"gloam_fetch_position",
             subject::make_image<glm::vec3>({1, 1}, [](glm::ivec2) { return glm::vec3(0, 0, -5); })}};
        return filter.with_images(images, {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(5), 2, 0.2F, 0.0125F});
    };
    EXPECT_EQ(run(0.2F), 0.3F);
    EXPECT_EQ(run(1.0F), 0.3F);
    EXPECT_THROW((void)run(0.1F), std::runtime_error);
}

// Vulkan lets a driver reorder what is not `precise`: the reductions of arguments must not be undone by it.
// Only drawn angles: one float below half a turn may be reduced to either side, and the hull of both bounds
// nothing.
TEST_F(Floats, WhateverOrderADriverTakesTheErrorIsBounded) {
    const subject::Lab shipped(
        {.device = std::string(subject::interpreter_name), .include_roots = {GLOAM_GLSL_DIR}});
    const auto expect_within = [&](const auto& function, const subject::Domain& domain, double most) {
        const judge::Answer answer = function.check_rules(domain, {.inputs = 1024});
        EXPECT_EQ(answer.criterion, judge::Criterion::rules);
        EXPECT_EQ(answer.unbounded, 0U) << answer.function;
        EXPECT_LT(answer.guarantee.absolute, most) << answer.function;
    };
    const auto drawn = [](double most) { return subject::uniform(-most, most).only_as_drawn(); };
    const std::string forward = "gloam/numeric/sincos.glsl";
    const std::string inverse = "gloam/numeric/inverse_trigonometry.glsl";
    using Wave = Function<glm::vec2(float)>;
    expect_within(Wave(shipped, forward, "gloam_sincos_turns"), {drawn(4)}, 4e-6);
    expect_within(Wave(shipped, forward, "gloam_sincos"), {drawn(100)}, 4e-6);
    expect_within(Function<float(float)>(shipped, inverse, "gloam_acos"), {drawn(1)}, 2e-4);
    expect_within(Function<float(float, float)>(shipped, inverse, "gloam_atan2"), {drawn(1), drawn(1)}, 2e-4);
}

}  // namespace gloam::floats_test
