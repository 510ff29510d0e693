// SPDX-License-Identifier: MIT
// Balls and discs in the place of the scene, Poisson discs, marched rays, directional occlusion, depth
// darkening.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/lab.hpp"

namespace gloam::proxies_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
const glm::vec3 up(0, 0, 1);

class Proxies : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    using Ball = float(glm::vec3, glm::vec3, float);
    Kernel<Ball> ball(const std::string& name) const {
        return {lab, "gloam/occlusion/sphere_proxy.glsl", "gloam_contribution_sphere" + name};
    }
};

TEST_F(Proxies, BallAboveThePoint) {
    const auto solid = ball("");
    const auto cosine = ball("_cosine");
    const glm::vec3 v = 2.0F * glm::vec3(0.5F, 0, std::sqrt(3.0F) / 2);  // 30 degrees from the normal
    EXPECT_NEAR(cosine(v, up, 1.0F), 0.216506, 1e-6);
    EXPECT_NEAR(solid(v, up, 1.0F), (1 - std::sqrt(0.75)) * std::sqrt(0.75), 1e-6);
    EXPECT_NEAR(cosine(2.0F * v, up, 1.0F), 0.0541266, 1e-6);
    EXPECT_NEAR(cosine(100.0F * v, up, 100.0F), 0.216506, 1e-6);
    for (const auto* f : {&solid, &cosine}) {
        EXPECT_EQ((*f)(v, up, 2.5F), 1.0F);             // inside the ball
        EXPECT_EQ((*f)(glm::vec3(0), up, 0.5F), 1.0F);  // at its centre
        EXPECT_EQ((*f)(-v, up, 1.0F), 0.0F);            // below the plane
        EXPECT_EQ((*f)(glm::vec3(1, 0, 0), up, 0.5F), 0.0F);
        EXPECT_EQ((*f)(v, up, 0.0F), 0.0F);
        EXPECT_EQ((*f)(v, up, NAN), 0.0F);
        EXPECT_EQ((*f)(glm::vec3(NAN), up, 1.0F), 0.0F);
        EXPECT_EQ((*f)(glm::vec3(infinity, 0, 0), up, 1.0F), 0.0F);
        EXPECT_EQ((*f)(v, glm::vec3(NAN), 1.0F), 0.0F);
    }
}

// The solid angle of a ball over that of the half space, by counting directions.
TEST_F(Proxies, SolidAngleOfABall) {
    const Kernel<float(float, float)> fraction(lab, "gloam/occlusion/sphere_proxy.glsl",
                                               "gloam_sphere_fraction");
    for (const double sine : {0.1, 0.5, 0.9, 0.999999}) {
        constexpr int steps = 1000000;
        int hits = 0;
        for (int i = 0; i < steps; ++i) {
            const double cosine = (i + 0.5) / steps;  // uniform on the half sphere around the axis
            if (1 - cosine * cosine < sine * sine) ++hits;
        }
        EXPECT_NEAR(fraction(static_cast<float>(sine), 1.0F), static_cast<double>(hits) / steps, 3e-5)
            << sine;
    }
    EXPECT_EQ(fraction(2.0F, 1.0F), 1.0F);
    EXPECT_EQ(fraction(1.0F, 1.0F), 1.0F);
    EXPECT_EQ(fraction(-1.0F, 1.0F), 0.0F);
    EXPECT_NEAR(fraction(1e-4F, 1.0F), 5e-9, 1e-14);
}

TEST_F(Proxies, OnlyAboveTheHorizon) {
    const Kernel<float(glm::vec3, float)> above(lab, "gloam/occlusion/sphere_proxy.glsl",
                                                "gloam_above_horizon");
    EXPECT_EQ(above(glm::vec3(3, 4, 6), 1.0F), 1.0F);
    EXPECT_EQ(above(glm::vec3(3, 4, 4), 1.0F), 0.0F);
    EXPECT_EQ(above(glm::vec3(3, 4, -4), -1.0F), 1.0F);
    EXPECT_EQ(above(glm::vec3(3, 4, 0), 0.0F), 0.0F);
    EXPECT_EQ(above(glm::vec3(0, 0, 1), 1e30F), 1.0F);
    EXPECT_EQ(above(glm::vec3(0, 0, -1), -1e30F), 0.0F);
    EXPECT_EQ(above(glm::vec3(NAN), 0.0F), 0.0F);
    EXPECT_EQ(above(glm::vec3(3, 4, 6), NAN), 0.0F);
}

TEST_F(Proxies, DiscAlongItsAxis) {
    const Kernel<float(glm::vec3, glm::vec3, glm::vec3, float, float)> disc(
        lab, "gloam/occlusion/disc_proxy.glsl", "gloam_contribution_disc_proxy_cosine");
    const float pi = std::numbers::pi_v<float>;
    for (const float radius : {0.1F, 1.0F, 10.0F}) {
        // Parallel disc, centred: r^2 / (r^2 + h^2).
        EXPECT_NEAR(disc(2.0F * up, up, -up, pi * radius * radius, 1.0F),
                    radius * radius / (4.0F + radius * radius), 1e-6);
    }
    EXPECT_NEAR(disc(2.0F * up, up, -up, pi, 0.25F), disc(2.0F * up, up, -up, pi, 1.0F) / 4, 1e-6);
    EXPECT_EQ(disc(2.0F * up, up, up, pi, 1.0F), 0.0F);  // faces away
    EXPECT_EQ(disc(-2.0F * up, up, up, pi, 1.0F), 0.0F);
    EXPECT_EQ(disc(glm::vec3(0), up, -up, pi, 1.0F), 0.0F);
    EXPECT_EQ(disc(2.0F * up, up, -up, 0.0F, 1.0F), 0.0F);
    EXPECT_EQ(disc(2.0F * up, up, -up, NAN, 1.0F), 0.0F);
    EXPECT_EQ(disc(glm::vec3(NAN), up, -up, pi, 1.0F), 0.0F);
    EXPECT_EQ(disc(2.0F * up, up, -up, pi, NAN), 0.0F);
    const glm::vec3 slant(std::sqrt(15.0F) / 4, 0, 0.25F);
    EXPECT_NEAR(disc(slant, up, -slant, pi, 1.0F), 0.5 * 0.25, 1e-6);
}

// In print the points behind the tangent plane occlude.
TEST_F(Proxies, PointsInFrontOfThePlaneOcclude) {
    const std::string file = "gloam/occlusion/aksoy_phaneuf.glsl";
    const Kernel<float(glm::vec3, glm::vec3, float, float)> c(lab, file, "gloam_contribution_aksoy_phaneuf");
    const glm::vec3 v(0.6F, 0, 0.8F);
    EXPECT_NEAR(c(v, up, 2.0F, 0.0F), 0.5, 1e-6);
    EXPECT_NEAR(c(v, up, 4.0F, 0.0F), 0.75, 1e-6);
    EXPECT_EQ(c(-v, up, 2.0F, 0.0F), 0.0F);
    EXPECT_EQ(c(v, up, 2.0F, 0.9F), 0.0F);
    EXPECT_NEAR(c(v, up, 1.0F, 0.0F), 0.0, 1e-6);
    EXPECT_LT(c(v, up, 0.9F, 0.0F), 0.0F);  // beyond the radius
    EXPECT_EQ(c(glm::vec3(0), up, 2.0F, 0.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(1, 0, 0), up, 2.0F, 0.0F), 0.0F);  // on the plane
    EXPECT_EQ(c(v, up, 2.0F, NAN), 0.0F);
    const Kernel<float(float, float)> sum(lab, file, "gloam_two_radii_sum");
    EXPECT_EQ(sum(0.25F, 0.5F), 0.75F);
    EXPECT_EQ(sum(0.75F, 0.5F), 1.0F);
    EXPECT_EQ(sum(NAN, 0.5F), 0.5F);
}

TEST_F(Proxies, MarchedRayEndsAtTheRadius) {
    const Kernel<glm::vec3(glm::vec3, glm::vec3, float, unsigned, unsigned, float)> march(
        lab, "gloam/sampling/eye_march.glsl", "gloam_eye_march");
    const glm::vec3 p(1, 2, -5);
    const glm::vec3 w(0.6F, 0.8F, 0);
    EXPECT_EQ(march(p, w, 2.0F, 3, 4, 1.0F), p + 2.0F * w);
    EXPECT_NEAR(march(p, w, 2.0F, 0, 4, 1.0F).x, 1.3, 1e-6);
    EXPECT_EQ(march(p, w, 2.0F, 0, 4, 0.0F), p);
    EXPECT_NEAR(march(p, w, 2.0F, 1, 4, 0.5F).y, 2 + 0.8 * 0.75, 1e-6);
}

class DirectionalOcclusion : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    static constexpr const char* file = "gloam/shading/directional_occlusion.glsl";
    Kernel<glm::vec3(glm::vec3, glm::vec3, glm::vec3, float)> direct{lab, file, "gloam_ssdo_direct"};
    Kernel<glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, float, float, float)> bounce{
        lab, file, "gloam_ssdo_bounce"};
    Kernel<glm::vec3(glm::vec3, float, glm::vec3)> light{lab, file, "gloam_ssdo_light"};
};

// Under light that is the same from everywhere a point sends on albedo times visibility, the cosine-weighted
// one.
TEST_F(DirectionalOcclusion, UniformLightGivesAlbedoTimesVisibility) {
    const glm::vec3 radiance(1, 0.5F, 0.25F);
    const glm::vec3 albedo(1, 0.8F, 0.6F);
    for (const float horizon : {0.0F, 0.5F, 1.0F}) {  // all around, as a sine
        std::vector<std::tuple<glm::vec3, glm::vec3, glm::vec3, float>> inputs;
        constexpr int count = 4000;
        for (int i = 0; i < count; ++i) {
            const float z = (static_cast<float>(i) + 0.5F) / count;
            const float angle = 2.399963F * static_cast<float>(i);
            const float r = std::sqrt(1 - z * z);
            inputs.emplace_back(glm::vec3(r * std::cos(angle), r * std::sin(angle), z), up, radiance,
                                z > horizon ? 1.0F : 0.0F);
        }
        glm::dvec3 sum(0);
        for (const glm::vec3 term : direct(inputs)) sum += term;
        const glm::vec3 got = light(sum, float{count}, albedo);
        const double visible = 1 - static_cast<double>(horizon * horizon);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], albedo[c] * radiance[c] * visible, 1e-3) << horizon;
    }
}

TEST_F(DirectionalOcclusion, NothingFromBelowNorFromWhatIsNotFinite) {
    const glm::vec3 white(1);
    EXPECT_EQ(direct(-up, up, white, 1.0F), glm::vec3(0));
    EXPECT_EQ(direct(up, up, white, 1.0F), glm::vec3(2));
    EXPECT_EQ(direct(3.0F * up, up, white, 0.5F), white);
    EXPECT_EQ(direct(glm::vec3(0), up, white, 1.0F), glm::vec3(0));
    EXPECT_EQ(direct(up, up, glm::vec3(NAN, -1, infinity), 1.0F), glm::vec3(0, 0, 131008));
    EXPECT_EQ(direct(up, up, white, NAN), glm::vec3(0));
    EXPECT_EQ(light(white, 0.0F, white), glm::vec3(0));
    EXPECT_EQ(light(glm::vec3(NAN, 4, 8), 4.0F, white), glm::vec3(0, 1, 2));
}

TEST_F(DirectionalOcclusion, BounceBetweenTwoFacingSurfaces) {
    const glm::vec3 red(1, 0, 0);
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, 1.0F, 0.5F, 0.0F), 0.25F * red);  // (R / d)^2
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, 2.0F, 0.5F, 0.0F), red);
    EXPECT_EQ(bounce(0.25F * up, up, -up, red, 1.0F, 1.0F, 0.0F), red);  // held at the least distance
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, 1.0F, 0.5F, 1.0F), glm::vec3(0));
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, 1.0F, 0.5F, 0.5F), 0.125F * red);
    EXPECT_EQ(bounce(2.0F * up, up, up, red, 1.0F, 0.5F, 0.0F), glm::vec3(0));  // its back
    EXPECT_EQ(bounce(-2.0F * up, up, up, red, 1.0F, 0.5F, 0.0F), glm::vec3(0));
    EXPECT_EQ(bounce(glm::vec3(0), up, -up, red, 1.0F, 0.5F, 0.0F), glm::vec3(0));
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, NAN, 0.5F, 0.0F), glm::vec3(0));
    EXPECT_EQ(bounce(2.0F * up, up, -up, red, 1.0F, 0.0F, 0.0F), glm::vec3(0));
    const float slant = bounce(glm::vec3(1, 0, 1), up, -up, red, 1.0F, 0.5F, 0.0F).x;
    EXPECT_NEAR(slant, 0.5 * 0.5, 1e-6);  // cos 45 twice, d^2 = 2
}

TEST_F(Proxies, DepthDarkeningBehindAnOutline) {
    const Kernel<float(float, float, float)> darken(lab, "gloam/shading/depth_darkening.glsl",
                                                    "gloam_depth_darkening");
    EXPECT_EQ(darken(0.75F, 0.5F, 2.0F), -0.5F);
    EXPECT_EQ(darken(0.75F, 0.5F, 1.0F), -0.25F);
    EXPECT_EQ(darken(0.5F, 0.75F, 2.0F), 0.0F);  // the nearer side
    EXPECT_EQ(darken(0.5F, 0.5F, 2.0F), 0.0F);
    for (const float background : {infinity, NAN, 0.0F}) {
        EXPECT_EQ(darken(background, 0.5F, 2.0F), 0.0F);
        EXPECT_EQ(darken(0.75F, background, 2.0F), 0.0F);
    }
    EXPECT_EQ(darken(0.75F, 0.5F, NAN), 0.0F);
    EXPECT_EQ(darken(0.75F, 0.5F, -1.0F), 0.0F);
}

TEST_F(Proxies, UpsamplingWeights) {
    const Kernel<float(float, float, float, float, float)> w(lab, "gloam/filter/mssao_upsample.glsl",
                                                             "gloam_mssao_upsample_weight");
    EXPECT_EQ(w(0.5F, 0.0F, 1.0F, 0.5F, 10.0F), 0.5F);
    EXPECT_NEAR(w(1.0F, -3.0F, 1.0F, 0.5F, 10.0F), 0.5, 1e-6);
    EXPECT_NEAR(w(1.0F, 0.0F, 0.0F, 0.5F, 10.0F), std::pow(0.5, 10), 1e-6);
    EXPECT_NEAR(w(1.0F, 3.0F, 0.0F, 1.0F, 1.0F), 0.125, 1e-6);
    EXPECT_EQ(w(1.0F, 0.0F, -1.0F, 0.5F, 10.0F), 0.0F);
    EXPECT_EQ(w(1.0F, 0.0F, -1.0F, 0.5F, 0.0F), 1.0F);
    for (int i = 0; i < 5; ++i) {
        float x[] = {1.0F, 0.5F, 0.5F, 1.0F, 1.0F};
        x[i] = NAN;
        EXPECT_EQ(w(x[0], x[1], x[2], x[3], x[4]), 0.0F) << i;
    }
    EXPECT_EQ(w(1.0F, infinity, 1.0F, 0.5F, 10.0F), 0.0F);
}

}  // namespace gloam::proxies_test
