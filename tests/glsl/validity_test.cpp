// SPDX-License-Identifier: MIT
// What of the history may still be used: disocclusion, changes of the neighbourhood, smooth invalidation.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::validity_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float float_max = std::numeric_limits<float>::max();

class Validity : public testing::Test {
  protected:
    static constexpr const char* disocclusion_file = "gloam/temporal/disocclusion.glsl";
    static constexpr const char* neighborhood_file = "gloam/temporal/neighborhood.glsl";
    using Change = float(glm::vec3, glm::vec3, glm::vec3, glm::vec3);

    check::Lab lab = test::make_lab(FIXTURES);
    Kernel<bool(float, float, float)> consistent{lab, disocclusion_file, "gloam_depth_consistent"};
    Kernel<Change> change{lab, neighborhood_file, "gloam_neighborhood_change"};
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
    EXPECT_TRUE(consistent(5.0F, 5.0F, 1e-6F));
    EXPECT_FALSE(consistent(5.0F, 5.0F, 0.0F));
    EXPECT_FALSE(consistent(5.0F, 5.0F, NAN));
}

TEST_F(Validity, BackgroundIsNoSurface) {
    for (const float background : {0.0F, -5.0F, infinity, NAN}) {
        EXPECT_FALSE(consistent(background, background, 0.05F)) << background;
        EXPECT_FALSE(consistent(5.0F, background, 0.05F)) << background;
        EXPECT_FALSE(consistent(background, 5.0F, 0.05F)) << background;
    }
}

// The camera has moved forward by 1: a point at depth 5 was at depth 6. Its depth now, as printed, would
// reject it.
TEST_F(Validity, DollyOverAStaticSceneKeepsTheHistory) {
    const Kernel<float(glm::vec3, glm::mat4)> previous_depth(lab, "gloam/geometry/reprojection.glsl",
                                                             "gloam_previous_depth");
    const Kernel<bool(float, float, float)> printed(lab, "printed.glsl", "printed_depth_consistent");
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
    const glm::vec3 up(0, 0, 1);  // exact positions: the exact step
    EXPECT_EQ(change(p + 2.0F * up, p, p + 2.25F * up, p), 0.25F);
    EXPECT_EQ(change(p + up, p, p + 1.0009765625F * up, p), 0.0009765625F);
}

TEST_F(Validity, ChangeAtItsEdges) {
    const glm::vec3 p(1, 2, -5);
    EXPECT_EQ(change(p, p, p, p), 0.0F);
    EXPECT_EQ(change(p + glm::vec3(0, 0, 3), p, p, p), 3.0F);
    for (const float bad : {NAN, infinity}) {
        for (int i = 0; i < 4; ++i) {
            glm::vec3 points[4] = {p, p, p, p};
            points[i].y = bad;
            EXPECT_EQ(change(points[0], points[1], points[2], points[3]), float_max);
        }
    }
    for (const float size : {1e-35F, 1e-20F, 1e20F, 1e37F}) {
        EXPECT_NEAR(
            change(glm::vec3(3, 0, 4) * size, glm::vec3(0), glm::vec3(0, 6, 0) * size, glm::vec3(0)) / size,
            1.0, 1e-6)
            << size;
    }
    const Kernel<bool(float, float)> unchanged(lab, neighborhood_file, "gloam_neighborhood_unchanged");
    EXPECT_TRUE(unchanged(0.009F, 0.01F));
    EXPECT_FALSE(unchanged(0.01F, 0.01F));
    EXPECT_FALSE(unchanged(NAN, 0.01F));
    EXPECT_FALSE(unchanged(0.0F, NAN));
    EXPECT_FALSE(unchanged(float_max, float_max));
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
        return check::compare<Change>(lab, file, function, exact, domain, {.ulp = 6});
    };
    const check::Answer ours = judge(neighborhood_file, "gloam_neighborhood_change");
    EXPECT_TRUE(ours.passed()) << ours;
    const check::Answer printed = judge("printed.glsl", "printed_neighborhood_change");
    EXPECT_GT(printed.outside(), printed.inputs() / 2);
    EXPECT_GT(printed.max_ulp, 1000.0);
}

TEST_F(Validity, ProbesLieAboveTheTangentPlane) {
    const Kernel<bool(glm::vec3, glm::vec3)> useful(lab, neighborhood_file, "gloam_probe_useful");
    const glm::vec3 n(0, 0, 1);
    EXPECT_TRUE(useful(glm::vec3(1, 1, 1e-6F), n));
    EXPECT_FALSE(useful(glm::vec3(1, 1, 0), n));
    EXPECT_FALSE(useful(glm::vec3(1, 1, -1), n));
    EXPECT_FALSE(useful(glm::vec3(0, 0, infinity), n));
    EXPECT_FALSE(useful(glm::vec3(NAN, 0, 1), n));
    EXPECT_FALSE(useful(glm::vec3(0, 0, 1), glm::vec3(NAN)));
}

TEST_F(Validity, ProbesThatCannotBlockDoNotChange) {
    const Kernel<float(glm::vec3, glm::vec3, glm::vec3, float)> change_of(lab, neighborhood_file,
                                                                          "gloam_probe_change");
    const glm::vec3 n(0, 0, 1);
    const glm::vec3 near(0, 3, 4);
    const glm::vec3 far(0, 6, 8);
    EXPECT_EQ(change_of(near, far, n, 5.0F), 5.0F);
    EXPECT_EQ(change_of(far, near, n, 5.0F), 5.0F);
    EXPECT_EQ(change_of(near, far, n, 4.0F), 0.0F);
    EXPECT_EQ(change_of(near, far, -n, 5.0F), 0.0F);
    EXPECT_EQ(change_of(glm::vec3(NAN), near, n, 5.0F), 0.0F);
    EXPECT_EQ(change_of(near, glm::vec3(NAN), n, 5.0F), float_max);
    EXPECT_EQ(change_of(near, glm::vec3(infinity), n, 5.0F), float_max);
}

TEST_F(Validity, SmoothInvalidation) {
    const std::string file = "gloam/temporal/smooth_invalidation.glsl";
    const Kernel<float(float, float)> clamped(lab, file, "gloam_invalidate_clamp");
    const Kernel<float(float, float)> confidence(lab, file, "gloam_confidence");
    const Kernel<float(float, float)> scaled(lab, file, "gloam_invalidate_confidence");
    EXPECT_EQ(clamped(500.0F, 32.0F), 32.0F);
    EXPECT_EQ(clamped(10.0F, 32.0F), 10.0F);
    for (const float none : {NAN, -1.0F}) {
        EXPECT_EQ(clamped(none, 32.0F), 0.0F);
        EXPECT_EQ(clamped(500.0F, none), 0.0F);
        EXPECT_EQ(scaled(none, 1.0F), 0.0F);
        EXPECT_EQ(scaled(500.0F, none), 0.0F);
    }
    EXPECT_EQ(confidence(0.0F, 15.0F), 1.0F);
    EXPECT_NEAR(confidence(1.0F / 15.0F, 15.0F), 0.5, 1e-7);
    EXPECT_EQ(confidence(float_max, 15.0F), 0.0F);
    EXPECT_EQ(confidence(infinity, 15.0F), 0.0F);
    EXPECT_EQ(confidence(NAN, 15.0F), 0.0F);
    EXPECT_EQ(confidence(1.0F, NAN), 0.0F);
    float before = 1.0F;
    for (const float d : {0.01F, 0.1F, 1.0F, 10.0F}) {
        EXPECT_LT(confidence(d, 20.0F), before);
        before = confidence(d, 20.0F);
    }
    EXPECT_EQ(scaled(500.0F, 0.5F), 250.0F);
    EXPECT_EQ(scaled(500.0F, 2.0F), 500.0F);
}

}  // namespace gloam::validity_test
