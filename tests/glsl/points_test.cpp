// SPDX-License-Identifier: MIT
// Methods that count single points: Alchemy, ISSAO, Crytek, Filion and McNaughton.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/lab.hpp"

namespace gloam::points_test {

using check::Kernel;
using glm::vec2;
using glm::vec3;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr double pi = std::numbers::pi;

class Points : public testing::Test {
  protected:
    using AlchemySignature = float(vec3, vec3, float, float, float);
    using IssaoSignature = float(vec3, vec3, float, float, float, float);

    check::Lab lab = test::make_lab(FIXTURES);

    template <class Function>
    Kernel<Function> occlusion(const std::string& file, const std::string& function) const {
        return {lab, "gloam/occlusion/" + file + ".glsl", "gloam_" + function};
    }
    Kernel<AlchemySignature> alchemy() const {
        return occlusion<AlchemySignature>("alchemy", "contribution_alchemy");
    }
    Kernel<IssaoSignature> issao() const { return occlusion<IssaoSignature>("issao", "contribution_issao"); }

    // Mean over 2^17 taps, summed in double.
    template <class Function, class... Arguments>
    double mean(const std::string& function, const Arguments&... arguments) const {
        constexpr unsigned batches = 512;
        constexpr unsigned batch = 256;
        const Kernel<Function> kernel(lab, "groove.glsl", function);
        std::vector<typename Kernel<Function>::Inputs> inputs;
        for (unsigned b = 0; b < batches; ++b) inputs.emplace_back(arguments..., b * batch, batch);
        double sum = 0.0;
        for (const vec2 part : kernel(inputs)) sum += static_cast<double>(part.x);
        return sum / (double{batches} * batch);
    }
};

// Planes through p at any tilt to the view: taps in the tangent plane.
std::vector<std::pair<vec3, vec3>> tangent_taps() {
    std::vector<std::pair<vec3, vec3>> taps;
    for (const double tilt : {0.0, 0.3, 0.9, 1.3, 1.55}) {
        for (const double azimuth : {0.0, 1.0, 2.5, 4.0}) {
            const vec3 n(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth),
                         std::cos(tilt));
            const vec3 t(std::cos(tilt) * std::cos(azimuth), std::cos(tilt) * std::sin(azimuth),
                         -std::sin(tilt));
            taps.emplace_back(0.7F * t, n);
            taps.emplace_back(-0.2F * t + 0.3F * glm::cross(n, t), n);
        }
    }
    return taps;
}

TEST_F(Points, BarePlaneAtAnyTiltIsOpen) {
    const auto a = alchemy();
    const auto i = issao();
    for (const auto& [offset, normal] : tangent_taps()) {
        EXPECT_EQ(a(offset, normal, 1e-5F, 1e-5F, 1.0F), 0.0F);
        EXPECT_LT(a(offset, normal, 0.0F, 1e-5F, 1.0F), 1e-6F);  // rounding of the offset alone
        EXPECT_EQ(i(offset, normal, 1.75F, 0.4F, 0.022F, 0.00016F), 0.0F);
    }
}

TEST_F(Points, AlchemyOfOnePoint) {
    const auto c = alchemy();
    const vec3 n(0, 0, 1);
    EXPECT_EQ(c(vec3(0, 0, 2), n, 0.0F, 0.0F, 1.0F), 0.5F);   // 1 / |v|
    EXPECT_EQ(c(vec3(0, 0, 2), n, 0.0F, 0.0F, 3.0F), 1.5F);   // 2 sigma
    EXPECT_EQ(c(vec3(0, 0, 2), n, 1.0F, 0.0F, 1.0F), 0.25F);  // the bias is taken off the height
    EXPECT_EQ(c(vec3(0, 0, 2), n, 0.0F, 4.0F, 1.0F), 0.25F);  // epsilon
    EXPECT_EQ(c(vec3(1, 0, 1), n, 0.0F, 0.0F, 1.0F), 0.5F);   // cos 45 / sqrt 2
    EXPECT_EQ(c(vec3(0, 0, -2), n, 0.0F, 0.0F, 1.0F), 0.0F);  // below
    EXPECT_EQ(c(vec3(0), n, 0.0F, 1e-5F, 1.0F), 0.0F);        // v = 0
    EXPECT_EQ(c(vec3(0), n, 0.0F, 0.0F, 1.0F), 0.0F);         // 0 / 0
    EXPECT_EQ(c(vec3(0, 0, 1e30F), n, 0.0F, 0.0F, 1.0F), 0.0F);
    EXPECT_EQ(c(vec3(NAN), n, 0.0F, 0.0F, 1.0F), 0.0F);
    EXPECT_EQ(c(vec3(0, 0, 1), vec3(NAN), 0.0F, 0.0F, 1.0F), 0.0F);
    EXPECT_EQ(c(vec3(0, 0, 1), n, NAN, 0.0F, 1.0F), 0.0F);
}

// E[occ] = (4 sigma / (pi r)) cos(beta) artanh(sin(beta)) for taps uniform on a disc: T12. As printed,
// without the factor 2 sigma, it would be half of that at sigma = 1.
TEST_F(Points, AlchemyOfAGroove) {
    for (const double degrees : {30.0, 45.0, 60.0}) {
        const double beta = degrees * pi / 180.0;
        for (const double radius : {1.0, 2.0}) {
            const double m = mean<vec2(float, float, unsigned, unsigned)>(
                "alchemy_groove", static_cast<float>(std::tan(beta)), static_cast<float>(radius));
            const double exact = 4.0 / (pi * radius) * std::cos(beta) * std::atanh(std::sin(beta));
            EXPECT_NEAR(2.0 * m, exact, 4e-3 * exact) << degrees << " " << radius;
        }
    }
    EXPECT_NEAR(4.0 / pi * std::cos(pi / 4) * std::atanh(std::sin(pi / 4)), 0.793515, 1e-6);
}

TEST_F(Points, IssaoOfOneTap) {
    const auto c = issao();
    const vec3 n(0, 0, 1);
    // T25, the constants of figure 3; the gain of 1.06 is a factor of phi.
    EXPECT_NEAR(c(vec3(0, 0, 1), n, 1.75F, 1.06F * 0.4F, 0.022F, 0.00016F), 0.414606, 1e-6);
    EXPECT_EQ(c(vec3(0, 0, 1), n, 1.0F, 0.4F, 0.022F, 0.00016F), 0.0F);  // |v| >= R
    EXPECT_EQ(c(vec3(0, 0, 0.02F), n, 1.75F, 0.4F, 0.022F, 0.00016F), 0.0F);
    EXPECT_EQ(c(vec3(0), n, 1.75F, 0.4F, 0.0F, 0.0F), 0.0F);
    EXPECT_EQ(c(vec3(NAN), n, 1.75F, 0.4F, 0.0F, 0.0F), 0.0F);
    EXPECT_EQ(c(vec3(0, 0, 1), vec3(NAN), 1.75F, 0.4F, 0.0F, 0.0F), 0.0F);
}

TEST_F(Points, EveryParameterOfIssaoCounts) {
    const auto c = issao();
    const vec3 v(0.5F, 0, 0.5F);
    const vec3 n(0, 0, 1);
    const float base = c(v, n, 1.0F, 0.4F, 0.02F, 0.01F);
    EXPECT_EQ(c(v, n, 0.7F, 0.4F, 0.02F, 0.01F), 0.0F);
    EXPECT_NEAR(c(v, n, 1.0F, 0.8F, 0.02F, 0.01F), 2 * base, 1e-6);
    EXPECT_LT(c(v, n, 1.0F, 0.4F, 0.04F, 0.01F), 0.99F * base);
    EXPECT_LT(c(v, n, 1.0F, 0.4F, 0.02F, 0.02F), 0.99F * base);
}

// Constants of figure 3 in a groove of 45 degrees; area-uniform offsets give half of the polar ones.
TEST_F(Points, IssaoOfAGroove) {
    using Groove = vec2(float, float, float, float, float, bool, unsigned, unsigned);
    const double polar = mean<Groove>("issao_groove", 1.0F, 1.75F, 0.4F, 0.022F, 0.00016F, true);
    const double uniform = mean<Groove>("issao_groove", 1.0F, 1.75F, 0.4F, 0.022F, 0.00016F, false);
    EXPECT_NEAR(1.06 * polar, 0.1330, 5e-4);
    EXPECT_NEAR(1.06 * uniform, 0.0677, 5e-4);
}

TEST_F(Points, IssaoAttenuation) {
    const auto q = occlusion<float(float, float, float)>("issao", "issao_attenuation");
    EXPECT_EQ(q(2.0F, 0.5F, 1.0F), 0.25F);  // phi / |v|
    EXPECT_EQ(q(0.5F, 0.5F, 1.0F), 0.25F);  // phi |v| / mu^2
    EXPECT_EQ(q(1.0F, 0.5F, 1.0F), 0.5F);
    EXPECT_EQ(q(0.0F, 0.5F, 1.0F), 0.0F);
    EXPECT_EQ(q(1.0F, 0.5F, 0.0F), 0.0F);
    EXPECT_EQ(q(NAN, 0.5F, 1.0F), 0.0F);
    EXPECT_EQ(q(infinity, 0.5F, 1.0F), 0.0F);
    using Signature = float(vec3, vec3, float, float, float);
    const auto c = occlusion<Signature>("issao", "contribution_issao_attenuated");
    const vec3 v(0.3F, 0, 0.4F);
    EXPECT_NEAR(c(v, vec3(0, 0, 1), 1.0F, 0.4F, 0.1F), 0.4 / 0.5 * 0.8, 1e-6);
    EXPECT_EQ(c(v, vec3(0, 0, 1), 0.5F, 0.4F, 0.1F), 0.0F);
    EXPECT_EQ(c(vec3(0), vec3(0, 0, 1), 1.0F, 0.4F, 0.1F), 0.0F);
    EXPECT_EQ(c(vec3(NAN), vec3(0, 0, 1), 1.0F, 0.4F, 0.1F), 0.0F);
}

TEST_F(Points, IssaoOffsets) {
    const std::string file = "gloam/sampling/issao_offset.glsl";
    const Kernel<vec2(vec2, float)> polar(lab, file, "gloam_issao_offset_polar");
    const Kernel<vec2(vec2, float)> printed(lab, file, "gloam_issao_offset_printed");
    EXPECT_EQ(polar(vec2(0.5F, 0.25F), 2.0F), vec2(1.0F, 0.0F));
    EXPECT_EQ(printed(vec2(0.5F, 0.25F), 2.0F), vec2(1.0F, -0.5F));
    EXPECT_EQ(polar(vec2(0.0F, 0.3F), 2.0F), vec2(0.0F));
    EXPECT_EQ(polar(vec2(NAN, 0.3F), 2.0F), vec2(0.0F));
    double longest = 0.0;
    double sum = 0.0;
    int moved = 0;
    constexpr int steps = 100;
    for (int i = 0; i < steps; ++i) {
        std::vector<std::tuple<vec2, float>> inputs;
        for (int j = 0; j < steps; ++j)
            inputs.emplace_back(
                vec2((static_cast<float>(i) + 0.5F) / steps, (static_cast<float>(j) + 0.5F) / steps), 1.0F);
        for (const vec2 p : printed(inputs)) {
            longest = std::max(longest, static_cast<double>(glm::length(p)));
            moved += glm::length(p) > 0.99999F ? 1 : 0;
        }
        for (const vec2 p : polar(inputs)) {
            longest = std::max(longest, static_cast<double>(glm::length(p)));
            sum += static_cast<double>(glm::length(p));
        }
    }
    EXPECT_LE(longest, 1.000001);
    EXPECT_NEAR(sum / (steps * steps), 0.5, 1e-4);
    EXPECT_NEAR(moved / double{steps * steps}, 0.031, 0.003);  // what leaves the disc as printed
}

TEST_F(Points, ProjectedDiscOfIssao) {
    const std::string file = "gloam/geometry/covering_radius.glsl";
    const Kernel<float(vec3, float, float)> parallel(lab, file, "gloam_covering_radius_parallel");
    const Kernel<float(vec3, float, float)> across(lab, file, "gloam_covering_radius_perpendicular");
    const double theta = 35 * pi / 180;
    const vec3 p(5 * std::sin(theta), 0, -5 * std::cos(theta));
    EXPECT_NEAR(across(p, 1.0F, 100.0F), 0.346596, 1e-6);  // T26
    EXPECT_NEAR(parallel(p, 1.0F, 100.0F), 1 / (5 * std::cos(theta)), 1e-6);
    EXPECT_EQ(across(vec3(0, 0, -5), 1.0F, 100.0F), 0.2F);
    EXPECT_EQ(parallel(vec3(0, 0, -5), 1.0F, 0.1F), 0.1F);
    EXPECT_EQ(across(p, 10.0F, 3.0F), 3.0F);  // reaches the plane of the eye
    for (const vec3 nowhere : {vec3(0), vec3(0, 0, 5), vec3(NAN), vec3(0, 0, -infinity)}) {
        EXPECT_EQ(across(nowhere, 1.0F, 3.0F), 0.0F);
        EXPECT_EQ(parallel(nowhere, 1.0F, 3.0F), 0.0F);
    }
}

TEST_F(Points, CountsAndBias) {
    const Kernel<int(float, float, int, int)> count(lab, "gloam/sampling/count_by_radius.glsl",
                                                    "gloam_count_by_radius");
    EXPECT_EQ(count(64.0F, 64.0F, 2, 12), 12);
    EXPECT_EQ(count(32.0F, 64.0F, 2, 12), 6);
    EXPECT_EQ(count(1.0F, 64.0F, 2, 12), 2);
    EXPECT_EQ(count(NAN, 64.0F, 2, 12), 2);
    EXPECT_EQ(count(infinity, 64.0F, 2, 12), 12);
    int last = 0;
    for (int r = 0; r <= 64; ++r) {
        const int n = count(static_cast<float>(r), 64.0F, 2, 12);
        EXPECT_GE(n, last);
        last = n;
    }
    const auto bias = occlusion<float(float, float, float)>("bias", "depth_bias");
    EXPECT_EQ(bias(0.25F, 8.0F, 2.0F), 1.0F);
    EXPECT_EQ(bias(0.25F, infinity, 2.0F), 0.0F);
    EXPECT_EQ(bias(NAN, 8.0F, 2.0F), 0.0F);
    // The reference depths that count, and what is beyond the largest float.
    constexpr float least = 1.175494351e-38F;
    constexpr float most = 8.507059173e37F;
    constexpr float largest = std::numeric_limits<float>::max();
    EXPECT_NEAR(bias(0.25F, least, least), 0.25, 1e-6);
    EXPECT_NEAR(bias(0.25F, most, most), 0.25, 1e-6);
    EXPECT_EQ(bias(0.25F, most, std::nextafter(most, infinity)), 0.0F);
    EXPECT_EQ(bias(0.25F, 1.0F, 0.0F), 0.0F);
    EXPECT_EQ(bias(-0.25F, 8.0F, 2.0F), 0.0F);
    EXPECT_EQ(bias(1e38F, 100.0F, 1.0F), largest);
    EXPECT_EQ(bias(infinity, 1.0F, 1.0F), largest);
    EXPECT_EQ(bias(infinity, 1e-30F, most), 0.0F);  // the quotient is 0
    const Kernel<vec3(vec3, float)> light(lab, "gloam/shading/ambient_light.glsl", "gloam_ambient_light");
    EXPECT_EQ(light(vec3(4, 2, 1), 0.25F), vec3(3, 1.5F, 0.75F));
    EXPECT_EQ(light(vec3(4, 2, 1), NAN), vec3(4, 2, 1));
}

TEST_F(Points, CrytekAgainstTheDepthBuffer) {
    const auto c = occlusion<float(float, float)>("crytek", "contribution_crytek");
    EXPECT_EQ(c(5.0F, 5.5F), 0.0F);
    EXPECT_EQ(c(5.0F, 4.0F), 1.0F);
    EXPECT_EQ(c(5.0F, 5.0F), 1.0F);  // equality is occluded
    for (const float background : {0.0F, -1.0F, infinity, NAN}) {
        EXPECT_EQ(c(5.0F, background), 0.0F);
    }
}

// T6: a plane is half occluded at any tilt, an inner corner of 90 degrees three quarters, a convex edge one
// quarter.
TEST_F(Points, CrytekBeforeTheRemap) {
    using Ball = vec2(int, float, unsigned, unsigned);
    for (const float slope : {0.0F, 0.7F, 3.0F, 20.0F})
        EXPECT_NEAR(mean<Ball>("crytek_ball", 0, slope), 0.5, 1e-3) << slope;
    EXPECT_NEAR(mean<Ball>("crytek_ball", 1, 0.0F), 0.75, 1e-3);
    EXPECT_NEAR(mean<Ball>("crytek_ball", 2, 0.0F), 0.25, 1e-3);
}

TEST_F(Points, FilionLeavesAPlaneOpen) {
    for (const float slope : {0.0F, 0.7F, 3.0F, 20.0F}) {
        const double m = mean<vec2(float, float, unsigned, unsigned)>("filion_half_ball", slope, 1.0F);
        EXPECT_LT(m, 1e-4) << slope;  // points within rounding of the plane
    }
}

TEST_F(Points, FilionOfOnePoint) {
    const auto c = occlusion<float(float, float, float)>("filion", "contribution_filion");
    const float r = 2.0F;
    const auto in_front = [&](float delta) { return c(16.0F, 16.0F - delta, r); };
    EXPECT_EQ(in_front(-1.0F), 0.0F);  // T29, as occlusion
    EXPECT_EQ(in_front(0.0F), 0.0F);
    EXPECT_EQ(in_front(1.0F), 1.0F);
    EXPECT_EQ(in_front(2.0F), 1.0F);
    EXPECT_EQ(in_front(4.0F), 0.5F);
    EXPECT_EQ(in_front(8.0F), 0.25F);
    for (const float background : {0.0F, -1.0F, infinity, NAN}) {
        EXPECT_EQ(c(5.0F, background, r), 0.0F);
    }
    EXPECT_EQ(c(NAN, 5.0F, r), 0.0F);
}

}  // namespace gloam::points_test
