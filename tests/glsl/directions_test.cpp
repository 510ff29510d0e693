// SPDX-License-Identifier: MIT
// Bent normals and cones; occlusion by curvature.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/lab.hpp"

namespace gloam::directions_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double right = std::numbers::pi / 2;
const glm::vec3 up(0, 0, 1);

class Directions : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    Kernel<float(float)> cone{lab, "gloam/shading/bent_cone.glsl", "gloam_cone_angle"};
    Kernel<glm::vec4(glm::vec4, glm::vec3, float)> add{lab, "gloam/shading/bent_normal.glsl",
                                                       "gloam_bent_add"};
    Kernel<glm::vec3(glm::vec4, glm::vec3)> bent{lab, "gloam/shading/bent_normal.glsl", "gloam_bent_normal"};
    Kernel<float(glm::vec4)> agreement{lab, "gloam/shading/bent_normal.glsl", "gloam_bent_length"};

    // The sums over many directions of the hemisphere, of which some are open.
    template <class Open>
    glm::vec4 sums(Open open) const {
        std::vector<std::tuple<glm::vec4, glm::vec3, float>> inputs;
        constexpr int rings = 48;
        for (int i = 0; i < rings; ++i) {
            for (int j = 0; j < 96; ++j) {
                const double z = (i + 0.5) / rings;
                const double angle = 2 * std::numbers::pi * (j + 0.5) / 96;
                const double r = std::sqrt(1 - z * z);
                const glm::vec3 w(r * std::cos(angle), r * std::sin(angle), z);
                inputs.emplace_back(glm::vec4(0), w, open(w) ? 1.0F : 0.0F);
            }
        }
        glm::dvec4 sum(0);
        for (const glm::vec4 part : add(inputs)) sum += part;
        return sum;
    }
};

// Sums outside the range in which they can be divided: no direction is left.
TEST_F(Directions, AgreementOfSumsAtTheEndsOfTheirRange) {
    constexpr float least = 1.175494351e-38F;
    constexpr float most = 8.507059173e37F;
    for (const float weight : {least, most, 1.0F})
        EXPECT_EQ(agreement(glm::vec4(0, 0, 0, weight)), 0.0F) << weight;
    for (const float weight :
         {0.0F, -1.0F, std::nextafter(least, 0.0F), std::nextafter(most, infinity), infinity})
        EXPECT_EQ(agreement(glm::vec4(0, 0, 0, weight)), 1.0F) << weight;
}

TEST_F(Directions, ConesOfKnownLength) {
    EXPECT_NEAR(cone(0.5F), right, 1e-6);
    EXPECT_NEAR(cone(0.75F), right * 2 / 3, 1e-6);
    EXPECT_EQ(cone(1.0F), 0.0F);
    EXPECT_EQ(cone(1.0001F), 0.0F);  // rounding of L
    EXPECT_NEAR(cone(0.25F), right, 1e-6);
    EXPECT_NEAR(cone(NAN), right, 1e-6);
}

TEST_F(Directions, OpenHemisphereBendsNothing) {
    const glm::vec4 sum = sums([](glm::vec3) { return true; });
    EXPECT_NEAR(agreement(sum), 0.5, 1e-3);
    EXPECT_NEAR(bent(sum, up).z, 1.0, 1e-6);
}

TEST_F(Directions, HalfSpaceBlockedBendsTheNormalBy45Degrees) {
    const glm::vec4 sum = sums([](glm::vec3 w) { return w.x > 0; });
    const glm::vec3 b = bent(sum, up);
    EXPECT_NEAR(b.x, std::numbers::sqrt2 / 2, 2e-3);
    EXPECT_NEAR(b.y, 0.0, 1e-5);
    EXPECT_NEAR(b.z, std::numbers::sqrt2 / 2, 2e-3);
}

TEST_F(Directions, CapIsItsOwnCone) {
    const glm::vec4 sum = sums([](glm::vec3 w) { return w.z > 0.5F; });
    EXPECT_NEAR(agreement(sum), 0.75, 1e-3);
    EXPECT_NEAR(cone(agreement(sum)), right * 2 / 3, 2e-3);
}

TEST_F(Directions, NothingOpen) {
    EXPECT_EQ(bent(glm::vec4(0), up), up);
    EXPECT_EQ(agreement(glm::vec4(0)), 1.0F);
    EXPECT_EQ(cone(agreement(glm::vec4(0))), 0.0F);
    EXPECT_EQ(bent(glm::vec4(0, 0, 0, 3), up), up);  // open directions that cancel
    EXPECT_EQ(bent(glm::vec4(NAN), up), up);
    const glm::vec4 sum(1, 2, 3, 4);
    EXPECT_EQ(add(sum, glm::vec3(NAN), 1.0F), sum);
    EXPECT_EQ(add(sum, up, NAN), sum);
    EXPECT_EQ(add(sum, up, 0.5F), glm::vec4(1, 2, 3.5F, 4.5F));
}

class Curvature : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    Kernel<float(float, float, float)> occlusion{lab, "gloam/occlusion/curvature.glsl",
                                                 "gloam_occlusion_curvature"};
    Kernel<glm::vec2(glm::vec3, glm::vec3, glm::vec3, glm::vec3)> principal{
        lab, "gloam/geometry/curvature.glsl", "gloam_principal_curvatures"};
};

// The mean over directions as it is defined, in double.
double mean_of_sin_squared(double k_1, double k_2, double radius) {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double phi = std::numbers::pi * (i + 0.5) / steps;
        const double k = k_1 * std::pow(std::cos(phi), 2) + k_2 * std::pow(std::sin(phi), 2);
        const double q = std::max(k, 0.0) * radius / 2;
        sum += q * q / (1 + q * q);
    }
    return sum / steps;
}

TEST_F(Curvature, KnownSurfaces) {
    EXPECT_EQ(occlusion(0.0F, 0.0F, 1.0F), 0.0F);    // plane
    EXPECT_EQ(occlusion(-1.0F, -2.0F, 1.0F), 0.0F);  // ball
    EXPECT_EQ(occlusion(-1.0F, 0.0F, 1.0F), 0.0F);   // ridge
    EXPECT_NEAR(occlusion(2.0F, 2.0F, 1.0F), 0.5, 1e-6);
    EXPECT_NEAR(occlusion(1.0F, 1.0F, 2.0F), 0.5, 1e-6);
    EXPECT_NEAR(occlusion(1.0F, 1.0F, 1.0F), 0.2, 1e-6);  // q = 1/2: q^2 / (1 + q^2)
    EXPECT_EQ(occlusion(infinity, infinity, 1.0F), occlusion(1e30F, 1e30F, 1.0F));
    for (const float bad : {NAN, 0.0F, -1.0F}) EXPECT_EQ(occlusion(1.0F, 1.0F, bad), 0.0F);
    EXPECT_EQ(occlusion(NAN, 1.0F, 1.0F), 0.0F);
    EXPECT_EQ(occlusion(1.0F, NAN, 1.0F), 0.0F);
}

TEST_F(Curvature, ClosedFormIsTheMeanOverDirections) {
    for (const float k_1 : {0.01F, 0.5F, 2.0F, 30.0F}) {
        for (const float k_2 : {-20.0F, -3.0F, -0.5F, -1e-4F, 0.0F, 0.3F, 3.0F, 40.0F}) {
            EXPECT_NEAR(occlusion(k_1, k_2, 1.5F), mean_of_sin_squared(k_1, k_2, 1.5), 2e-6)
                << k_1 << " " << k_2;
            EXPECT_EQ(occlusion(k_1, k_2, 1.5F), occlusion(k_2, k_1, 1.5F)) << k_1 << " " << k_2;
        }
    }
    EXPECT_GT(occlusion(2.0F, -2.0F, 1.0F), 0.0F);
}

TEST_F(Curvature, OfABallACylinderAndAPlaneInAnyDirections) {
    const double r = 4;
    const double step = 0.01;
    const auto near_curvatures = [](glm::vec2 got, double k_1, double k_2) {
        EXPECT_NEAR(got.x, k_1, 1e-4);
        EXPECT_NEAR(got.y, k_2, 1e-4);
    };
    for (const double turn : {0.0, 0.4, 1.1}) {
        for (const double apart :
             {0.6, 1.57, 2.4}) {  // angle between the two axes of the image on the surface
            const glm::dvec3 x(std::cos(turn), std::sin(turn), 0);
            const glm::dvec3 y(std::cos(turn + apart), std::sin(turn + apart), 0);
            const auto curvatures = [&](auto normal_change) {
                return principal(step * x, 1.5 * step * y, normal_change(step * x),
                                 normal_change(1.5 * step * y));
            };
            near_curvatures(curvatures([&](glm::dvec3 p) { return -p / r; }), 1 / r, 1 / r);   // inside
            near_curvatures(curvatures([&](glm::dvec3 p) { return p / r; }), -1 / r, -1 / r);  // outside
            near_curvatures(curvatures([&](glm::dvec3 p) { return glm::dvec3(-p.x / r, 0, 0); }), 1 / r, 0);
            near_curvatures(curvatures([&](glm::dvec3 p) { return glm::dvec3(p.x, -p.y, 0) / r; }), 1 / r,
                            -1 / r);
            near_curvatures(curvatures([](glm::dvec3) { return glm::dvec3(0); }), 0, 0);
        }
    }
}

TEST_F(Curvature, OfNothing) {
    const glm::vec3 x(0.01F, 0, 0);
    const glm::vec3 y(0, 0.01F, 0);
    EXPECT_EQ(principal(glm::vec3(0), y, x, y), glm::vec2(0));
    EXPECT_EQ(principal(x, 2.0F * x, x, y), glm::vec2(0));
    EXPECT_EQ(principal(x, glm::vec3(NAN), x, y), glm::vec2(0));
    EXPECT_EQ(principal(x, y, glm::vec3(NAN), y), glm::vec2(0));
    EXPECT_EQ(principal(x, glm::vec3(infinity, 0, 0), x, y), glm::vec2(0));
}

// More than one depth image, more than one resolution, more than one pass, more than one frame.

class Layers : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

// As in gloam/gather/pair.glsl.
struct PairShare {
    float occluded;
    float whole;
};

// Of the layers tried at a pair of taps one stays that is a surface and does not block less, as a share.
TEST_F(Layers, ATryStaysThatBlocksAtLeastAsMuch) {
    const Kernel<bool(glm::vec2, int, int, PairShare, PairShare)> kernel(lab, "gloam/gather/pair.glsl",
                                                                         "gloam_pair_stays");
    const check::ImageSet unread{
        {"gloam_fetch_depth", check::make_image<float>({1, 1}, [](glm::ivec2) { return 0.0F; })},
        {"gloam_fetch_layers",
         check::make_image<glm::vec3>({1, 1}, [](glm::ivec2) { return glm::vec3(0); })}};
    const auto stays = [&](glm::vec2 depths, int look, int layers, PairShare found, PairShare most) {
        return kernel.with_images(unread, {depths, look, layers, found, most});
    };
    const PairShare half{1, 2};
    const PairShare unusable{0, 0};
    const glm::vec2 both(3, 4);
    EXPECT_TRUE(stays(glm::vec2(0), 0, 2, unusable, half));  // the visible surfaces
    for (const int look : {1, 2}) {
        EXPECT_TRUE(stays(both, look, 2, PairShare{0.75F, 1}, half));
        EXPECT_TRUE(stays(both, look, 2, PairShare{2, 4}, half));
        EXPECT_FALSE(stays(both, look, 2, PairShare{1.9F, 4}, half));
        EXPECT_TRUE(stays(both, look, 2, PairShare{0, 1}, unusable));
        EXPECT_FALSE(stays(both, look, 2, unusable, unusable));
        // At the first tap, then at the second, there is no such layer.
        EXPECT_EQ(stays(glm::vec2(0, 4), look, 2, PairShare{2, 1}, half), look == 2);
        EXPECT_EQ(stays(glm::vec2(3, 0), look, 2, PairShare{2, 1}, half), look == 1);
    }
}

TEST_F(Layers, DepthRejection) {
    const Kernel<bool(float, float, float)> rejected(lab, "gloam/occlusion/depth_rejection.glsl",
                                                     "gloam_tap_rejected");
    EXPECT_TRUE(rejected(5.0F, 3.5F, 1.0F));
    EXPECT_FALSE(rejected(5.0F, 4.0F, 1.0F));
    EXPECT_FALSE(rejected(5.0F, 3.5F, 2.0F));
    EXPECT_FALSE(rejected(5.0F, 50.0F, 1.0F));
    for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
        EXPECT_FALSE(rejected(5.0F, background, 1.0F));
        EXPECT_FALSE(rejected(background, 3.5F, 1.0F));
    }
    EXPECT_FALSE(rejected(5.0F, 3.5F, NAN));
}

class DualResolution : public Layers {
  protected:
    Kernel<bool(glm::ivec2, glm::ivec2, float)> disagrees{lab, "gloam/filter/dual_resolution.glsl",
                                                          "gloam_dual_resolution_disagrees"};

    // An even image with one other value at (3, 2).
    bool at(glm::ivec2 pixel, float other, float tolerance, glm::ivec2 size = {5, 5}) const {
        const auto value = [&](glm::ivec2 p) { return p == glm::ivec2(3, 2) ? other : 0.25F; };
        return disagrees.with_images({{"gloam_fetch_occlusion", check::make_image<float>(size, value)}},
                                     {pixel, size, tolerance});
    }
};

TEST_F(DualResolution, LooksAtThreeByThree) {
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.1F));
    EXPECT_TRUE(at({4, 3}, 0.5F, 0.1F));
    EXPECT_FALSE(at({1, 2}, 0.5F, 0.1F));
    EXPECT_FALSE(at({3, 4}, 0.5F, 0.1F));
    EXPECT_FALSE(at({2, 2}, 0.5F, 0.25F));
    EXPECT_TRUE(at({2, 2}, 0.5F, 0.24F));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.1F, {1, 1}));
    EXPECT_FALSE(at({0, 0}, 0.5F, 0.0F, {3, 1}));
    EXPECT_TRUE(at({2, 2}, NAN, 0.5F));
    EXPECT_TRUE(at({0, 0}, 0.25F, NAN));
}

TEST_F(Layers, SeparableForms) {
    const std::string file = "gloam/occlusion/separable.glsl";
    const Kernel<float(float, float)> mean(lab, file, "gloam_separable_mean");
    EXPECT_EQ(mean(0.5F, 0.0F), 0.25F);  // a wall along v
    EXPECT_EQ(mean(0.0F, 0.5F), 0.25F);  // turned by 90 degrees
    EXPECT_EQ(mean(1.0F, 1.0F), 1.0F);
    EXPECT_EQ(mean(NAN, 1.0F), 0.5F);
    const Kernel<float(glm::vec3, glm::vec3, float, float)> weight(lab, file, "gloam_separable_weight");
    EXPECT_EQ(weight(glm::vec3(0), up, 1.0F, 0.1F), 1.0F);
    EXPECT_NEAR(weight(glm::vec3(1, 0, 0), up, 1.0F, 0.1F), std::exp(-0.5), 1e-6);
    EXPECT_NEAR(weight(glm::vec3(1, 0, 0), up, 2.0F, 0.1F), std::exp(-0.125), 1e-6);
    EXPECT_EQ(weight(glm::vec3(1, 0, 0.2F), up, 1.0F, 0.1F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(1, 0, -0.2F), up, 1.0F, 0.1F), 0.0F);
    EXPECT_GT(weight(glm::vec3(1, 0, 0.2F), up, 1.0F, 0.3F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(NAN), up, 1.0F, 0.1F), 0.0F);
    EXPECT_EQ(weight(glm::vec3(infinity, 0, 0), up, 1.0F, infinity), 0.0F);
}

// m frames of x after y leave x + (y - x) (1 - rate)^m.
TEST_F(Layers, ExponentialMeanOverFrames) {
    const Kernel<float(float, bool, float, float)> smooth(lab, "gloam/temporal/smoothing.glsl",
                                                          "gloam_temporal_smooth");
    float value = 0.9F;
    for (int m = 1; m <= 12; ++m) {
        value = smooth(value, true, 0.2F, 0.25F);
        EXPECT_NEAR(value, 0.2 + 0.7 * std::pow(0.75, m), 1e-6);
    }
    EXPECT_EQ(smooth(0.9F, false, 0.2F, 0.25F), 0.2F);
    EXPECT_EQ(smooth(NAN, true, 0.2F, 0.25F), 0.2F);
    EXPECT_EQ(smooth(0.9F, true, NAN, 0.25F), 0.9F);
    EXPECT_EQ(smooth(0.9F, false, NAN, 0.25F), 0.0F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, 0.0F), 0.9F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, 1.0F), 0.2F);
    EXPECT_EQ(smooth(0.9F, true, 0.2F, NAN), 0.2F);
}

}  // namespace gloam::directions_test
