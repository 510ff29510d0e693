// SPDX-License-Identifier: MIT
// Accumulation over frames: blending, convergence, the history buffer, sample counts.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/lab.hpp"

namespace gloam::temporal_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();

// As in gloam/temporal/history.glsl.
struct History {
    float occlusion;
    float weight;
    unsigned index;
    float depth;

    bool operator==(const History&) const = default;
};

class Temporal : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);
    Kernel<glm::vec2(float, float, float, float, float)> blend{lab, "gloam/temporal/blend.glsl",
                                                               "gloam_blend"};
    Kernel<float(float, float)> convergence{lab, "gloam/temporal/convergence.glsl", "gloam_convergence"};
};

TEST_F(Temporal, UnsaturatedBlendIsTheMeanOfAllSamples) {
    glm::vec2 state(0);
    double sum = 0.0;
    for (int frame = 0; frame < 10; ++frame) {
        const float fresh = 0.1F + 0.08F * static_cast<float>((frame * 7) % 10);
        state = blend(state.x, state.y, fresh, 32.0F, 500.0F);
        sum += static_cast<double>(fresh);
    }
    EXPECT_NEAR(state.x, sum / 10, 1e-6);
    EXPECT_EQ(state.y, 320.0F);
}

TEST_F(Temporal, TwoBatchesEqualOneOfBoth) {
    const glm::vec2 before(0.3F, 96.0F);
    const glm::vec2 first = blend(before.x, before.y, 0.25F, 16.0F, 500.0F);
    const glm::vec2 second = blend(first.x, first.y, 0.75F, 16.0F, 500.0F);
    const glm::vec2 both = blend(before.x, before.y, 0.5F, 32.0F, 500.0F);
    EXPECT_NEAR(second.x, both.x, 1e-7);
    EXPECT_EQ(second.y, both.y);
}

TEST_F(Temporal, SaturatedBlendIsAnExponentialAverage) {
    EXPECT_NEAR(blend(0.0F, 500.0F, 1.0F, 16.0F, 500.0F).x, 16.0 / 516.0, 1e-8);
    glm::vec2 state(1.0F, 500.0F);
    for (int frame = 1; frame <= 20; ++frame) {
        state = blend(state.x, state.y, 0.0F, 16.0F, 500.0F);
        EXPECT_NEAR(state.x, std::pow(500.0 / 516.0, frame), 1e-6);
        EXPECT_EQ(state.y, 500.0F);
    }
}

TEST_F(Temporal, BlendAtItsEdges) {
    EXPECT_EQ(blend(0.7F, 0.0F, 0.3F, 32.0F, 500.0F), glm::vec2(0.3F, 32.0F));    // no weight: C exactly
    EXPECT_EQ(blend(0.7F, 100.0F, 0.3F, 0.0F, 500.0F), glm::vec2(0.7F, 100.0F));  // no samples: unchanged
    EXPECT_EQ(blend(0.7F, 0.0F, 0.3F, 0.0F, 500.0F), glm::vec2(0));
    EXPECT_EQ(blend(0.7F, 100.0F, NAN, 32.0F, 500.0F), glm::vec2(0.7F, 100.0F));
    EXPECT_EQ(blend(0.7F, 100.0F, infinity, 32.0F, 500.0F), glm::vec2(0.7F, 100.0F));
    EXPECT_EQ(blend(NAN, 100.0F, NAN, 32.0F, 500.0F), glm::vec2(0));
    for (const float unusable : {NAN, infinity, -0.1F, 1.1F}) {
        EXPECT_EQ(blend(unusable, 100.0F, 0.3F, 32.0F, 500.0F), glm::vec2(0.3F, 32.0F)) << unusable;
    }
    for (const float none : {NAN, -1.0F}) {
        EXPECT_EQ(blend(0.7F, none, 0.3F, 32.0F, 500.0F), glm::vec2(0.3F, 32.0F)) << none;
    }
    // A cap that was lowered holds at once.
    EXPECT_EQ(blend(0.0F, 1500.0F, 1.0F, 16.0F, 500.0F), blend(0.0F, 500.0F, 1.0F, 16.0F, 500.0F));
    EXPECT_EQ(blend(0.7F, 100.0F, 0.3F, 32.0F, 0.0F), glm::vec2(0.3F, 0.0F));
    EXPECT_EQ(blend(0.7F, 100.0F, 0.3F, NAN, 500.0F), glm::vec2(0.7F, 100.0F));
    EXPECT_EQ(blend(0.5F, 16777216.0F, 0.5F, 1.0F, 16777216.0F), glm::vec2(0.5F, 16777216.0F));
}

// With the weight of this pixel in the denominator, as printed, a constant does not stay constant.
TEST_F(Temporal, ConstantStaysConstant) {
    const Kernel<float(float, float, float, float, float)> printed(lab, "printed.glsl", "printed_blend");
    for (const float value : {0.0F, 0.1F, 0.5F, 0.99999994F, 1.0F}) {
        for (const float weight : {1.0F, 7.0F, 333.0F, 500.0F}) {
            EXPECT_EQ(blend(value, weight, value, 16.0F, 500.0F).x, value) << weight;
        }
    }
    EXPECT_GT(printed(0.5F, 500.0F, 0.5F, 16.0F, 100.0F), 2.0F);
}

TEST_F(Temporal, ConvergenceAtItsEdges) {
    EXPECT_EQ(convergence(0.0F, 500.0F), 0.0F);
    EXPECT_EQ(convergence(125.0F, 500.0F), 0.25F);
    EXPECT_EQ(convergence(500.0F, 500.0F), 1.0F);
    EXPECT_EQ(convergence(501.0F, 500.0F), 1.0F);
    EXPECT_EQ(convergence(infinity, 500.0F), 1.0F);
    for (const float none : {-1.0F, NAN}) EXPECT_EQ(convergence(none, 500.0F), 0.0F);
    for (const float none : {0.0F, -1.0F, NAN}) EXPECT_EQ(convergence(10.0F, none), 1.0F);
}

// w_max = 500, k_1 = 32, k_2 = 16; thresholds 0.2 (filter), 0.3 (samples), 0.5 (rotation).
TEST_F(Temporal, TimelineOfAStaticPixel) {
    const Kernel<int(float, float, int, int)> samples(lab, "gloam/temporal/sample_budget.glsl",
                                                      "gloam_sample_count");
    const Kernel<bool(float, float)> rotated(lab, "gloam/temporal/rotation_switch.glsl",
                                             "gloam_rotation_enabled");
    const Kernel<float(float, float)> shrink(lab, "gloam/filter/shrink.glsl", "gloam_shrink");
    glm::vec2 state(0);
    int unfiltered = 0;
    int fewer = 0;
    int unrotated = 0;
    int saturated = 0;
    const auto note = [](int& first, bool now, int frame) {
        if (first == 0 && now) first = frame;
    };
    for (int frame = 1; frame <= 30; ++frame) {
        const int k = samples(convergence(state.y, 500.0F), 0.3F, 32, 16);
        note(fewer, k == 16, frame);
        state = blend(state.x, state.y, 0.5F, static_cast<float>(k), 500.0F);
        const float now = convergence(state.y, 500.0F);
        note(unfiltered, shrink(now, 0.2F) == 0.0F, frame);
        note(unrotated, !rotated(now, 0.5F), frame);
        note(saturated, now == 1.0F, frame);
    }
    EXPECT_EQ(unfiltered, 4);
    EXPECT_EQ(fewer, 6);
    EXPECT_EQ(unrotated, 11);
    EXPECT_EQ(saturated, 27);
}

TEST_F(Temporal, SampleCountSwitchesAtTheThreshold) {
    const Kernel<int(float, float, int, int)> k(lab, "gloam/temporal/sample_budget.glsl",
                                                "gloam_sample_count");
    EXPECT_EQ(k(0.299F, 0.3F, 32, 12), 32);
    EXPECT_EQ(k(0.3F, 0.3F, 32, 12), 12);
    EXPECT_EQ(k(1.0F, 0.3F, 32, 12), 12);
    EXPECT_EQ(k(NAN, 0.3F, 32, 12), 32);
    EXPECT_EQ(k(0.0F, 0.3F, -1, 12), 0);
}

TEST_F(Temporal, RotationSwitchesAtTheThreshold) {
    const Kernel<bool(float, float)> on(lab, "gloam/temporal/rotation_switch.glsl", "gloam_rotation_enabled");
    EXPECT_TRUE(on(0.499F, 0.5F));
    EXPECT_FALSE(on(0.5F, 0.5F));
    EXPECT_FALSE(on(0.0F, 0.0F));
    EXPECT_TRUE(on(NAN, 0.5F));
}

class HistoryBuffer : public Temporal {
  protected:
    static constexpr const char* file = "gloam/temporal/history.glsl";
    Kernel<glm::vec4(History)> pack{lab, file, "gloam_history_pack"};
    Kernel<History(glm::vec4)> unpack{lab, file, "gloam_history_unpack"};
};

TEST_F(HistoryBuffer, KeepsWhatIsUsable) {
    for (const unsigned index : {0U, 1U, 1023U, 16777215U}) {
        const History h{0.25F, 320.0F, index, 7.5F};
        EXPECT_EQ(pack(h), glm::vec4(0.25F, 320.0F, static_cast<float>(index), 7.5F));
        EXPECT_EQ(unpack(pack(h)), h);
    }
    EXPECT_EQ(unpack(pack(History{0.25F, 320.0F, 16777217U, 7.5F})).index, 1U);
}

TEST_F(HistoryBuffer, StartsAgainFromWhatIsNot) {
    const History empty{0.0F, 0.0F, 0U, 7.5F};
    for (const float bad : {NAN, infinity, -0.1F, 1.1F}) {
        EXPECT_EQ(unpack(glm::vec4(bad, 320.0F, 5.0F, 7.5F)), empty) << bad;
        EXPECT_EQ(pack(History{bad, 320.0F, 5U, 7.5F}), glm::vec4(0, 0, 0, 7.5F)) << bad;
    }
    for (const float bad : {NAN, infinity, -1.0F, 0.0F}) {
        EXPECT_EQ(unpack(glm::vec4(0.5F, bad, 5.0F, 7.5F)), empty) << bad;
    }
    for (const float background : {NAN, infinity, -1.0F, 0.0F}) {
        EXPECT_EQ(unpack(glm::vec4(0.5F, 320.0F, 5.0F, background)), (History{0.0F, 0.0F, 0U, infinity}))
            << background;
    }
    for (const float bad : {NAN, infinity, -1.0F, 16777216.0F}) {
        EXPECT_EQ(unpack(glm::vec4(0.5F, 320.0F, bad, 7.5F)), (History{0.5F, 320.0F, 0U, 7.5F})) << bad;
    }
    EXPECT_EQ(unpack(glm::vec4(0.5F, 320.0F, 5.75F, 7.5F)).index, 5U);
    EXPECT_EQ(unpack(glm::vec4(0)), (History{0.0F, 0.0F, 0U, infinity}));  // the first frame: cleared memory
}

TEST_F(HistoryBuffer, IndexWrapsWithoutOverflow) {
    const Kernel<unsigned(unsigned, unsigned, unsigned)> next(lab, file, "gloam_next_index");
    EXPECT_EQ(next(1008U, 16U, 1024U), 0U);
    EXPECT_EQ(next(1020U, 16U, 1024U), 12U);
    EXPECT_EQ(next(4294967295U, 4294967295U, 1024U), 1022U);
    EXPECT_EQ(next(5U, 0U, 1024U), 5U);
    EXPECT_EQ(next(5U, 7U, 1U), 0U);
    EXPECT_EQ(next(16777215U, 2U, 0U), 1U);
    EXPECT_EQ(next(16777215U, 2U, 4294967295U), 1U);
}

TEST_F(Temporal, BilinearWeightsOfTheValidTexels) {
    const std::string file = "gloam/temporal/validated_bilinear.glsl";
    const Kernel<glm::vec4(glm::vec2)> weights(lab, file, "gloam_bilinear_weights");
    const Kernel<glm::vec4(glm::vec4, glm::bvec4)> validated(lab, file, "gloam_validated_weights");
    const glm::vec4 all = weights(glm::vec2(0.25F, 0.5F));
    EXPECT_EQ(all, glm::vec4(0.375F, 0.125F, 0.375F, 0.125F));
    EXPECT_EQ(weights(glm::vec2(0.0F, 1.0F)), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(weights(glm::vec2(NAN, 2.0F)), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(validated(all, glm::bvec4(true)), all);
    EXPECT_EQ(validated(all, glm::bvec4(true, false, true, false)), glm::vec4(0.5F, 0, 0.5F, 0));
    EXPECT_EQ(validated(all, glm::bvec4(false, true, false, false)), glm::vec4(0, 1, 0, 0));
    EXPECT_EQ(validated(all, glm::bvec4(false)), glm::vec4(0));
    EXPECT_EQ(validated(glm::vec4(0, 1, 0, 0), glm::bvec4(true, false, true, true)), glm::vec4(0));
    EXPECT_EQ(validated(glm::vec4(NAN, 0.5F, -1, 0.5F), glm::bvec4(true)), glm::vec4(0, 0.5F, 0, 0.5F));
}

}  // namespace gloam::temporal_test
