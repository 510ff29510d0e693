// SPDX-License-Identifier: MIT
// Falloffs, contributions and estimators against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/lab.hpp"

namespace gloam::occlusion_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();

enum Scene { ceiling, wall, inside, ball };
enum Falloff { step, linear, quadratic, alchemy, cubic, one };
enum Form { cosine, uniform, cosine_printed, uniform_printed };

class Occlusion : public testing::Test {
  protected:
    check::Lab lab = test::make_lab(FIXTURES);

    static constexpr unsigned batches = 512;
    static constexpr unsigned batch = 256;
    static constexpr double samples = double{batches} * batch;

    // The mean over all samples, summed in double.
    template <class Function, class... Arguments>
    double mean(const std::string& function, const Arguments&... arguments) const {
        const Kernel<Function> kernel(lab, "closed_form.glsl", function);
        std::vector<typename Kernel<Function>::Inputs> inputs;
        for (unsigned b = 0; b < batches; ++b) inputs.emplace_back(arguments..., b * batch, batch);
        double sum = 0.0;
        double count = 0.0;
        for (const glm::vec2 part : kernel(inputs)) {
            sum += static_cast<double>(part.x);
            count += static_cast<double>(part.y);
        }
        EXPECT_EQ(count, samples);
        return sum / count;
    }
    double rays(Scene scene, float size, Falloff falloff, Form form = cosine) const {
        return mean<glm::vec2(int, float, int, float, int, unsigned, unsigned)>(
            "integrate", int{scene}, size, int{falloff}, 1.0F, int{form});
    }
    double points(Scene scene, float size, Falloff law) const {
        return mean<glm::vec2(int, float, int, float, unsigned, unsigned)>("integrate_points", int{scene},
                                                                           size, int{law}, 1.0F);
    }
    Kernel<float(float, float)> falloff(const std::string& name) const {
        return {lab, "gloam/occlusion/falloff.glsl", "gloam_falloff_" + name};
    }
};

// Halton points do better than the 4 sigma / sqrt(N) of independent ones.
constexpr double tolerance = 4 * 0.5 / 362.0;

TEST_F(Occlusion, WallUnderFourFalloffs) {
    EXPECT_NEAR(rays(wall, 0.25F, step), 0.342519, 1e-3);
    EXPECT_NEAR(rays(wall, 0.25F, linear), 0.168214, 1e-3);
    EXPECT_NEAR(rays(wall, 0.25F, quadratic), 0.240864, 1e-3);
    EXPECT_NEAR(rays(wall, 0.25F, alchemy), 0.252626, 1e-3);
    EXPECT_NEAR(rays(wall, 2.0F, alchemy), 0.106103, 1e-3);
    EXPECT_NEAR(rays(wall, 0.25F, one), 0.5, 1e-3);
}

TEST_F(Occlusion, CeilingUnderThreeFalloffs) {
    const double q = 0.25;
    EXPECT_NEAR(rays(ceiling, 0.25F, step), 1 - q * q, 1e-3);
    EXPECT_NEAR(rays(ceiling, 0.25F, linear), (1 - q) * (1 - q), 1e-3);
    EXPECT_NEAR(rays(ceiling, 0.25F, quadratic), 1 - q * q + 2 * q * q * std::log(q), 1e-3);
    EXPECT_NEAR(rays(ceiling, 0.25F, one), 1, 1e-6);
}

TEST_F(Occlusion, InsideOfASphere) {
    EXPECT_NEAR(rays(inside, 0.25F, linear), 2.0 / 3.0, 1e-3);
    EXPECT_NEAR(rays(inside, 0.25F, quadratic), 1 - 0.25 / 2, 1e-3);
    EXPECT_NEAR(rays(inside, 1.0F, step), 0.25, 1e-3);
    EXPECT_NEAR(rays(inside, 1.0F, linear), 1.0 / 12.0, 1e-3);
}

TEST_F(Occlusion, BallAboveThePoint) {
    EXPECT_NEAR(rays(ball, 2.0F, one), 0.216506, 1e-3);
    EXPECT_NEAR(rays(ball, 4.0F, one), 0.0541266, 1e-3);
}

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
    const Kernel<float(glm::vec3, glm::vec3)> clamped(lab, "gloam/occlusion/cosine.glsl",
                                                      "gloam_sample_cosine");
    const Kernel<float(glm::vec3, glm::vec3)> printed(lab, "printed.glsl", "printed_cosine");
    const glm::vec3 n(0, 0, 1);
    EXPECT_EQ(clamped(glm::vec3(3, 0, -4), n), 0.0F);
    EXPECT_NEAR(printed(glm::vec3(3, 0, -4), n), -0.8, 1e-6);
    EXPECT_NEAR(clamped(glm::vec3(3, 0, 4), n), 0.8, 1e-6);
    double clamped_sum = 0.0;
    double printed_sum = 0.0;
    for (const float z : {-0.9F, -0.5F, -0.1F, 0.1F, 0.5F, 0.9F}) {  // uniform directions: z is uniform
        const glm::vec3 direction(std::sqrt(1.0F - z * z), 0.0F, z);
        clamped_sum += static_cast<double>(clamped(direction, n));
        printed_sum += static_cast<double>(printed(direction, n));
    }
    EXPECT_NEAR(4 * clamped_sum / 6, 1.0, 1e-6);
    EXPECT_NEAR(4 * printed_sum / 6, 0.0, 1e-6);
}

TEST_F(Occlusion, CosineOfOffsetsOfAnySize) {
    const Kernel<float(glm::vec3, glm::vec3)> f(lab, "gloam/occlusion/cosine.glsl", "gloam_sample_cosine");
    const glm::vec3 n(0.6F, 0, 0.8F);
    for (const float size : {1e-37F, 1e-20F, 1.0F, 1e20F, 1e38F}) {
        EXPECT_NEAR(f(size * glm::vec3(0, 0, 1), n), 0.8, 2e-7) << size;
    }
    EXPECT_EQ(f(glm::vec3(0), n), 0.0F);
    EXPECT_EQ(f(glm::vec3(infinity, 0, 0), n), 0.0F);
    EXPECT_EQ(f(glm::vec3(NAN), n), 0.0F);
    EXPECT_EQ(f(glm::vec3(1, 0, 0), glm::vec3(NAN)), 0.0F);
}

TEST_F(Occlusion, FalloffsAtTheirEdges) {
    EXPECT_EQ(falloff("linear")(0.5F, 1.0F), 0.5F);
    for (const char* name : {"linear", "quadratic"}) {
        const auto d = falloff(name);
        EXPECT_EQ(d(0.0F, 2.0F), 1.0F) << name;
        EXPECT_EQ(d(-1.0F, 2.0F), d(1.0F, 2.0F)) << name;
        EXPECT_EQ(d(NAN, 2.0F), 0.0F) << name;
        EXPECT_EQ(d(1.0F, NAN), 0.0F) << name;
        EXPECT_EQ(d(1.0F, -2.0F), 0.0F) << name;
        EXPECT_EQ(d(1.0F, 0.0F), 0.0F) << name;
        EXPECT_EQ(d(0.0F, 0.0F), 0.0F) << name;
        EXPECT_EQ(d(infinity, 2.0F), 0.0F) << name;
        EXPECT_NEAR(d(1e38F, 2e38F), d(1.0F, 2.0F), 1e-6) << name;
        EXPECT_NEAR(d(2e-38F, 4e-38F), d(1.0F, 2.0F), 1e-6) << name;
    }
}

// Dividing before subtracting leaves hundreds of ULP near the radius.
TEST_F(Occlusion, LinearFalloffIsAccurateUpToItsRadius) {
    const auto exact = [](double d, double radius) { return d < radius ? 1.0 - d / radius : 0.0; };
    const check::Domain domain{check::uniform(0.99, 1.0), check::uniform(1.0, 1.01)};
    const auto check_function = [&](const std::string& file, const std::string& function) {
        return check::compare<float(float, float)>(lab, file, function, exact, domain, {.ulp = 1.5});
    };
    const check::Answer ours = check_function("gloam/occlusion/falloff.glsl", "gloam_falloff_linear");
    EXPECT_TRUE(ours.passed()) << ours;
    EXPECT_GT(check_function("printed.glsl", "printed_falloff_linear").max_ulp, 100.0);
}

TEST_F(Occlusion, SampleBlockedByTheDepthBuffer) {
    const Kernel<bool(float, float, float, float)> v(lab, "gloam/occlusion/blocked.glsl",
                                                     "gloam_sample_blocked");
    EXPECT_TRUE(v(5.0F, 4.5F, 0.01F, 1.0F));
    EXPECT_FALSE(v(5.0F, 5.5F, 0.01F, 1.0F));
    EXPECT_FALSE(v(5.0F, 4.75F, 0.25F, 1.0F));  // not more than the bias
    EXPECT_TRUE(v(5.0F, 4.0F, 0.01F, 1.0F));    // exactly the range
    EXPECT_FALSE(v(5.0F, 3.9F, 0.01F, 1.0F));   // too far in front
    EXPECT_TRUE(v(5.0F, 3.9F, 0.01F, infinity));
    for (const float background : {0.0F, -1.0F, infinity, NAN})
        EXPECT_FALSE(v(5.0F, background, 0.01F, infinity)) << background;
    for (const float behind : {0.0F, -1.0F, NAN}) EXPECT_FALSE(v(behind, 4.5F, 0.01F, infinity)) << behind;
    EXPECT_FALSE(v(5.0F, 4.5F, NAN, 1.0F));
    EXPECT_FALSE(v(5.0F, 4.5F, 0.01F, NAN));
}

TEST_F(Occlusion, FoxComptonContribution) {
    const Kernel<float(glm::vec3, glm::vec3, float)> c(lab, "gloam/occlusion/fox_compton.glsl",
                                                       "gloam_contribution_fox_compton");
    const glm::vec3 n(0, 0, 1);
    EXPECT_NEAR(c(glm::vec3(0, 0, 0.5F), n, 0.25F), 0.5, 1e-6);    // epsilon / distance
    EXPECT_NEAR(c(glm::vec3(0, 0, 0.125F), n, 0.25F), 1.0, 1e-6);  // within epsilon
    EXPECT_NEAR(c(glm::vec3(0.3F, 0, 0.4F), n, 0.25F), 0.4, 1e-6);
    EXPECT_EQ(c(glm::vec3(0.5F, -0.25F, 0), n, 0.25F), 0.0F);  // in the tangent plane
    EXPECT_EQ(c(glm::vec3(0), n, 0.25F), 0.0F);
    EXPECT_LT(c(glm::vec3(0, 0, -1), n, 0.25F), 0.0F);  // behind it
    EXPECT_EQ(c(glm::vec3(0, 0, 1), n, 0.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(0, 0, 1), n, -1.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(0, 0, 1), n, 1e18F), 1.0F);
}

// cos(s, p, n) as printed, read as the cosine of s: moving the scene would change the occlusion.
TEST_F(Occlusion, FoxComptonDoesNotDependOnTheOrigin) {
    const Kernel<float(glm::vec3, glm::vec3, float)> c(lab, "gloam/occlusion/fox_compton.glsl",
                                                       "gloam_contribution_fox_compton");
    const Kernel<float(glm::vec3, glm::vec3, glm::vec3, float)> printed(lab, "printed.glsl",
                                                                        "printed_fox_compton");
    const glm::vec3 n(0, 0, 1);
    const glm::vec3 p(0, 0, -5);
    const glm::vec3 s(0.5F, 0, -4.5F);
    const glm::vec3 shift(0, 0, 16);
    EXPECT_NEAR(c(s - p, n, 0.1F), 0.1, 1e-7);  // epsilon cos 45 / (1 / sqrt 2)
    EXPECT_EQ(printed(p, n, s, 0.1F), 0.0F);
    EXPECT_GT(printed(p + shift, n, s + shift, 0.1F), 1.0F);
}

TEST_F(Occlusion, MeanOfContributions) {
    const std::string file = "gloam/occlusion/estimator.glsl";
    const Kernel<glm::vec2(glm::vec2, float)> add(lab, file, "gloam_estimator_add");
    const Kernel<float(glm::vec2)> mean_of(lab, file, "gloam_estimator_mean");
    glm::vec2 accumulated(0);
    EXPECT_EQ(mean_of(accumulated), 0.0F);
    for (const float c : {0.5F, NAN, 1.0F, infinity, -infinity, 0.0F}) accumulated = add(accumulated, c);
    EXPECT_EQ(accumulated, glm::vec2(1.5F, 3.0F));
    EXPECT_EQ(mean_of(accumulated), 0.5F);
    EXPECT_EQ(mean_of(glm::vec2(5, 4)), 1.0F);
    EXPECT_EQ(mean_of(glm::vec2(-1, 4)), 0.0F);
    EXPECT_EQ(mean_of(glm::vec2(NAN, 4)), 0.0F);
    EXPECT_EQ(mean_of(glm::vec2(1, NAN)), 0.0F);
}

}  // namespace gloam::occlusion_test
