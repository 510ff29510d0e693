// SPDX-License-Identifier: MIT
// Accumulation over frames, and what of the history may still be used: means over many frames, surfaces that
// move, and what the equations give as printed.
#include <glm/gtc/matrix_transform.hpp>

#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::temporal_test {

using check::Function;

class Temporal : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);
    Function<glm::vec2(float, float, float, float, float)> blend{lab, "gloam/temporal/blend.glsl",
                                                                 "gloam_blend"};
    Function<float(float, float)> convergence{lab, "gloam/temporal/convergence.glsl", "gloam_convergence"};
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
    glm::vec2 state(1.0F, 500.0F);
    for (int frame = 1; frame <= 20; ++frame) {
        state = blend(state.x, state.y, 0.0F, 16.0F, 500.0F);
        EXPECT_NEAR(state.x, std::pow(500.0 / 516.0, frame), 1e-6);
        EXPECT_EQ(state.y, 500.0F);
    }
}

// With the weight of this pixel in the denominator, as printed, a constant does not stay constant.
TEST_F(Temporal, ConstantStaysConstant) {
    const Function<float(float, float, float, float, float)> printed(lab, "printed.glsl", "printed_blend");
    for (const float value : {0.0F, 0.1F, 0.5F, 0.99999994F, 1.0F}) {
        for (const float weight : {1.0F, 7.0F, 333.0F, 500.0F}) {
            EXPECT_EQ(blend(value, weight, value, 16.0F, 500.0F).x, value) << weight;
        }
    }
    EXPECT_GT(printed(0.5F, 500.0F, 0.5F, 16.0F, 100.0F), 2.0F);
}

// w_max = 500, k_1 = 32, k_2 = 16; thresholds 0.2 (filter), 0.3 (samples), 0.5 (rotation).
TEST_F(Temporal, TimelineOfAStaticPixel) {
    const Function<int(float, float, int, int)> samples(lab, "gloam/temporal/sample_budget.glsl",
                                                        "gloam_sample_count");
    const Function<bool(float, float)> rotated(lab, "gloam/temporal/rotation_switch.glsl",
                                               "gloam_rotation_enabled");
    const Function<float(float, float)> shrink(lab, "gloam/filter/shrink.glsl", "gloam_shrink");
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

// m frames of x after y leave x + (y - x) (1 - rate)^m.
TEST_F(Temporal, SmoothingIsAnExponentialMean) {
    const Function<float(float, bool, float, float)> smooth(lab, "gloam/temporal/smoothing.glsl",
                                                            "gloam_temporal_smooth");
    float value = 0.9F;
    for (int m = 1; m <= 12; ++m) {
        value = smooth(value, true, 0.2F, 0.25F);
        EXPECT_NEAR(value, 0.2 + 0.7 * std::pow(0.75, m), 1e-6);
    }
}

// As in gloam/temporal/history.glsl.
struct History {
    float occlusion;
    float weight;
    unsigned index;
    float depth;
};

// Four texels of occlusion 1 and weight 100 are that at every position between them.
TEST_F(Temporal, AHistoryThatIsAllBlockedIsKeptEverywhere) {
    const Function<History(glm::vec2, glm::ivec2, float, float)> reprojected(
        lab, "gloam/temporal/reprojected_history.glsl", "gloam_reprojected_history");
    for (const float occlusion : {0.0F, 1.0F}) {
        const check::ImageSet images{
            {"gloam_fetch_history", check::make_image<glm::vec4>(glm::ivec2(40, 30), [&](glm::ivec2) {
                 return glm::vec4(occlusion, 100.0F, 7.0F, 5.0F);
             })}};
        std::vector<Function<History(glm::vec2, glm::ivec2, float, float)>::Inputs> inputs;
        for (int i = 0; i < 4000; ++i) {
            const double u = std::fmod(0.6180339887 * i, 1.0);
            const double v = std::fmod(0.7548776662 * i, 1.0);
            inputs.emplace_back(glm::vec2(u, v), glm::ivec2(40, 30), 5.0F, 0.02F);
        }
        for (const History& history : reprojected(inputs, images)) {
            EXPECT_NEAR(history.occlusion, occlusion, 1e-6);
            EXPECT_NEAR(history.weight, 100.0, 1e-4);
            EXPECT_EQ(history.index, 7U);
        }
        for (const glm::ivec2 none : {glm::ivec2(0, 30), glm::ivec2(40, 0), glm::ivec2(0)}) {
            EXPECT_EQ(reprojected.with_images(images, {glm::vec2(0.5F), none, 5.0F, 0.02F}).weight, 0.0F);
        }
    }
}

class Validity : public testing::Test {
  protected:
    static constexpr const char* disocclusion_file = "gloam/temporal/disocclusion.glsl";
    static constexpr const char* neighborhood_file = "gloam/temporal/neighborhood.glsl";
    using Change = float(glm::vec3, glm::vec3, glm::vec3, glm::vec3);

    check::Lab lab = test::make_lab(FIXTURES);
    Function<bool(float, float, float)> consistent{lab, disocclusion_file, "gloam_depth_consistent"};
    Function<Change> change{lab, neighborhood_file, "gloam_neighborhood_change"};
};

TEST_F(Validity, DepthsWithinEpsilonAreOfOneSurface) {
    for (const float depth : {1e-3F, 1.0F, 6.0F, 1e6F}) {
        for (const float epsilon : {0.01F, 0.05F}) {
            for (const float side : {-1.0F, 1.0F}) {
                EXPECT_TRUE(consistent(depth, depth * (1 + side * epsilon * 0.999F), epsilon)) << depth;
                EXPECT_FALSE(consistent(depth, depth * (1 + side * epsilon * 1.001F), epsilon)) << depth;
            }
        }
    }
}

// The camera has moved forward by 1: a point at depth 5 was at depth 6. Its depth now, as printed, would
// reject it.
TEST_F(Validity, DollyOverAStaticSceneKeepsTheHistory) {
    const Function<float(glm::vec3, glm::mat4)> previous_depth(lab, "gloam/geometry/reprojection.glsl",
                                                               "gloam_previous_depth");
    const Function<bool(float, float, float)> printed(lab, "printed.glsl", "printed_depth_consistent");
    const glm::vec3 point(0.3F, -0.2F, -5.0F);  // the camera is at the origin now
    const glm::mat4 previous_view = glm::translate(glm::mat4(1), glm::vec3(0, 0, -1));
    const float expected = previous_depth(point, previous_view);
    EXPECT_EQ(expected, 6.0F);
    const float stored = 6.0F;
    EXPECT_TRUE(consistent(stored, expected, 0.01F));
    EXPECT_FALSE(printed(stored, 5.0F, 0.01F));
    EXPECT_FALSE(printed(stored, 5.0F, 0.05F));
}

TEST_F(Validity, RigidMotionChangesNothing) {
    numeric::Random random(5);
    const auto uniform = [&](double extent) { return random.uniform(-extent, extent); };
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 axis = glm::normalize(glm::dvec3(uniform(1), uniform(1), random.uniform(0.1, 1)));
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1), uniform(3), axis));
        const glm::dvec3 shift(uniform(2), uniform(2), uniform(2));
        const glm::vec3 p(uniform(2), uniform(2), uniform(2));
        const glm::vec3 s = p + glm::vec3(uniform(1), uniform(1), uniform(1));
        const glm::vec3 moved_p(turn * glm::dvec3(p) + shift);
        const glm::vec3 moved_s(turn * glm::dvec3(s) + shift);
        EXPECT_LE(change(s, p, moved_s, moved_p), 1e-5F * glm::length(s - p)) << i;
    }
}

TEST_F(Validity, OccluderThatMovesAlongTheLineChangesByItsStep) {
    const glm::vec3 p(1, 2, -5);
    const glm::vec3 direction(0.6F, 0, 0.8F);
    for (const float step : {0.5F, 0.0625F, 0.0009765625F}) {
        EXPECT_NEAR(change(p + 2.0F * direction, p, p + (2.0F + step) * direction, p), step, 1e-6) << step;
    }
}

// Where the differences of the positions are exact, so is the change; the difference of two rounded lengths
// is not.
TEST_F(Validity, SmallChangesKeepTheirAccuracy) {
    const auto exact = [](glm::dvec3 s, glm::dvec3 p, glm::dvec3 s0, glm::dvec3 p0) {
        const glm::dvec3 a = s - p;
        const glm::dvec3 b = s0 - p0;
        return std::abs(glm::dot(a - b, a + b)) / (glm::length(a) + glm::length(b));
    };
    const auto on_grid = [](double extent) {
        return check::made_by<glm::vec3>([extent](numeric::Random& random) {
            const auto axis = [&] {
                return static_cast<float>(std::round(random.uniform(-extent, extent) * 4096) / 4096);
            };
            return glm::vec3(axis(), axis(), axis());
        });
    };
    // s' and p' are drawn as small steps from s and p.
    const check::Domain domain = check::Domain{on_grid(1), on_grid(4), on_grid(0.01), on_grid(0.01)}.adjusted(
        [](std::span<check::Word> words) {
            for (std::size_t i = 0; i < 6; ++i) {
                words[i + 6] =
                    check::to_word(check::from_word<float>(words[i]) + check::from_word<float>(words[i + 6]));
            }
        });
    const auto judge = [&](const std::string& file, const std::string& function) {
        return check::Function<Change>(lab, file, function).compare(exact, domain, {.ulp = 6});
    };
    const check::Answer ours = judge(neighborhood_file, "gloam_neighborhood_change");
    EXPECT_TRUE(ours.passed()) << ours;
    const check::Answer printed = judge("printed.glsl", "printed_neighborhood_change");
    EXPECT_GT(printed.outside(), printed.inputs() / 2);
    EXPECT_GT(printed.max_ulp, 1000.0);
}

TEST_F(Validity, ConfidenceFallsWithTheChange) {
    const Function<float(float, float)> confidence(lab, "gloam/temporal/smooth_invalidation.glsl",
                                                   "gloam_confidence");
    float before = 1.0F;
    for (const float d : {0.01F, 0.1F, 1.0F, 10.0F}) {
        EXPECT_LT(confidence(d, 20.0F), before);
        before = confidence(d, 20.0F);
    }
}

}  // namespace gloam::temporal_test
