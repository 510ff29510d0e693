// SPDX-License-Identifier: MIT
// Scalable ambient obscurance, multi-resolution ambient occlusion, and how many samples a pixel takes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/lab.hpp"

namespace gloam::scalable_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();
const glm::vec3 up(0, 0, 1);

class Scalable : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    const Kernel<float(glm::vec3, glm::vec3, float, float, float, float)> sao{lab, "gloam/occlusion/sao.glsl",
                                                                              "gloam_contribution_sao"};
};

// A published port takes the distance in texture coordinates, and so always reads the full image.
TEST_F(Scalable, LevelOfAPixelRadius) {
    const Kernel<int(float, float, int)> level(lab, "gloam/sampling/depth_mip.glsl", "gloam_depth_mip_level");
    const std::vector<std::pair<float, int>> known{
        {0.0F, 0},   {8.0F, 0},   {15.99F, 0}, {16.0F, 1},   {31.99F, 1},   {32.0F, 2}, {64.0F, 3},
        {128.0F, 4}, {255.9F, 4}, {256.0F, 5}, {4096.0F, 5}, {infinity, 5}, {NAN, 0}};
    for (const auto& [pixels, want] : known) EXPECT_EQ(level(pixels, 16.0F, 5), want) << pixels;
    EXPECT_EQ(level(256.0F, 8.0F, 9), 6);
    EXPECT_EQ(level(256.0F, 16.0F, 3), 3);
    EXPECT_EQ(level(256.0F, 0.0F, 5), 0);
    EXPECT_EQ(level(256.0F, NAN, 5), 0);
}

TEST_F(Scalable, ChainOfAnyImageSizeStaysInsideIt) {
    const std::string file = "gloam/sampling/depth_mip.glsl";
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2, int)> pixel(lab, file, "gloam_depth_mip_pixel");
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2, int)> source(lab, file, "gloam_depth_mip_source");
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2)> grid(lab, file, "gloam_rotated_grid");
    EXPECT_EQ(grid(glm::ivec2(3, 2), glm::ivec2(16)), glm::ivec2(6, 5));
    EXPECT_EQ(grid(glm::ivec2(2, 3), glm::ivec2(16)), glm::ivec2(5, 6));
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(7, 5), glm::ivec2(8, 1), glm::ivec2(1920, 1081)}) {
        for (const int level : {0, 1, 2, 5}) {
            const glm::ivec2 last = pixel(size - 1, size, level);
            const glm::ivec2 from = source(last, size, level);
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(from, glm::ivec2(0))) &&
                        glm::all(glm::lessThan(from, size)))
                << size.x << "x" << size.y << " level " << level;
        }
    }
    // No half-texel drift: a level's pixel lies over the pixel that it came from.
    for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(13, 21), glm::ivec2(31, 17)}) {
        for (const int level : {1, 2, 5}) {
            EXPECT_EQ(source(at, glm::ivec2(2048), level) >> level, at) << level;
        }
    }
    EXPECT_EQ(source(glm::ivec2(13, 21), glm::ivec2(64), 0), glm::ivec2(13, 21));
}

// A bare plane, seen at a tilt through the depth chain. Placed where it was aimed (as published), a tap has
// the depth of another pixel, and the plane blocks itself; placed where its depth is from, it does not.
TEST_F(Scalable, TapsPlacedWhereTheirDepthIsFromKeepAPlaneOpen) {
    const std::string file = "gloam/sampling/depth_mip.glsl";
    const Kernel<int(float, float, int)> level(lab, file, "gloam_depth_mip_level");
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2, int)> pixel(lab, file, "gloam_depth_mip_pixel");
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2, int)> source(lab, file, "gloam_depth_mip_source");
    const glm::ivec2 size(501, 333);
    const auto ray = [&](glm::ivec2 at) {
        return glm::dvec3((glm::dvec2(at) + 0.5 - glm::dvec2(size) / 2.0) / 300.0, -1.0);
    };
    for (const double tilt : {0.0, 0.5, 1.0}) {
        const glm::dvec3 n(std::sin(tilt), 0, std::cos(tilt));
        const auto depth = [&](glm::ivec2 at) { return -5 * n.z / glm::dot(n, ray(at)); };
        const glm::ivec2 center(250, 166);
        const glm::dvec3 p = depth(center) * ray(center);
        float aimed = 0;
        for (int x = -160; x <= 160; x += 7) {
            const glm::ivec2 tap = center + glm::ivec2(x, x / 3);
            const int l = level(glm::length(glm::vec2(tap - center)), 16.0F, 5);
            const glm::ivec2 from = source(pixel(tap, size, l), size, l);
            const auto at = [&](glm::ivec2 place) {
                return sao(depth(from) * ray(place) - p, n, 8.0F, 1e-5F, 0.01F, 1.0F);
            };
            EXPECT_EQ(at(from), 0.0F) << "tilt " << tilt << " tap " << x;
            aimed += at(tap);
        }
        EXPECT_TRUE(tilt == 0 || aimed > 0.05F) << tilt << " " << aimed;
    }
}

TEST_F(Scalable, SamplesByDistance) {
    const Kernel<int(float, float, int, int)> count(lab, "gloam/sampling/count_by_distance.glsl",
                                                    "gloam_count_by_distance");
    EXPECT_EQ(count(0.0F, 100.0F, 64, 4), 64);
    EXPECT_EQ(count(100.0F, 100.0F, 64, 4), 4);
    EXPECT_EQ(count(100.0F / 64.0F, 100.0F, 64, 4), 32);
    EXPECT_EQ(count(50.0F, 100.0F, 0, 4), 4);
    for (const float bad : {infinity, NAN, -1.0F}) EXPECT_EQ(count(bad, 100.0F, 64, 4), 4);
    int before = 65;
    for (float d = 0; d <= 120; d += 0.75F) {
        const int now = count(d, 100.0F, 64, 2);
        EXPECT_LE(now, before);
        before = now;
    }
}

TEST_F(Scalable, RadiusCapKeepsTheShape) {
    const Kernel<glm::vec2(glm::vec2, float)> cap(lab, "gloam/geometry/radius_cap.glsl", "gloam_radius_cap");
    EXPECT_EQ(cap(glm::vec2(40, 20), 64.0F), glm::vec2(40, 20));
    EXPECT_EQ(cap(glm::vec2(128, 64), 64.0F), glm::vec2(64, 32));
    EXPECT_EQ(cap(glm::vec2(NAN, 64), 32.0F), glm::vec2(0, 32));
    EXPECT_EQ(cap(glm::vec2(128, 64), NAN), glm::vec2(0));
}

TEST_F(Scalable, ContributionOfAPointStraightAbove) {
    const glm::vec3 v = 0.5F * up;
    // v^2 = 1/4, v . n = 1/2.
    EXPECT_NEAR(sao(v, up, 1.0F, 0.01F, 0.01F, 1.0F), std::pow(0.75, 3) * 0.49 / 0.26, 1e-6);
    // A number: the scene twice as large changes nothing.
    EXPECT_NEAR(sao(2.0F * v, up, 2.0F, 0.02F, 0.04F, 2.0F), sao(v, up, 1.0F, 0.01F, 0.01F, 1.0F), 1e-6);
}

TEST_F(Scalable, EveryParameterChangesTheContribution) {
    const glm::vec3 v(0.3F, 0.1F, 0.4F);
    const float base = sao(v, up, 1.0F, 0.01F, 0.01F, 1.0F);
    EXPECT_NE(sao(v, up, 1.5F, 0.01F, 0.01F, 1.0F), base);
    EXPECT_NE(sao(v, up, 1.0F, 0.05F, 0.01F, 1.0F), base);
    EXPECT_NE(sao(v, up, 1.0F, 0.01F, 0.10F, 1.0F), base);
    EXPECT_NE(sao(v, glm::vec3(1, 0, 0), 1.0F, 0.01F, 0.01F, 1.0F), base);
    EXPECT_NEAR(sao(v, up, 1.0F, 0.01F, 0.01F, 2.0F), 2.0F * base, 1e-6);
}

TEST_F(Scalable, NothingBlocksOnABarePlaneOrAtTheEdges) {
    for (const float tilt : {0.0F, 0.5F, 1.0F, 1.5F}) {
        const glm::vec3 n(std::sin(tilt), 0, std::cos(tilt));
        const glm::vec3 along(std::cos(tilt), 0, -std::sin(tilt));
        for (const float t : {-0.9F, -0.1F, 0.2F, 0.7F})
            EXPECT_EQ(sao(t * along + glm::vec3(0, 0.3F, 0), n, 1.0F, 0.01F, 0.01F, 1.0F), 0.0F) << tilt;
    }
    EXPECT_EQ(sao(glm::vec3(0), up, 1.0F, 0.0F, 0.0F, 1.0F), 0.0F);   // 0 / 0
    EXPECT_EQ(sao(glm::vec3(0), up, 1.0F, 0.0F, 0.01F, 1.0F), 0.0F);  // at the point
    EXPECT_EQ(sao(up, up, 1.0F, 0.01F, 0.01F, 1.0F), 0.0F);           // at the radius
    for (const glm::vec3 nowhere : {glm::vec3(0, 0, -1e30F), glm::vec3(0, 0, -infinity), glm::vec3(NAN)})
        EXPECT_EQ(sao(nowhere, up, 1.0F, 0.01F, 0.01F, 1.0F), 0.0F);
    EXPECT_EQ(sao(0.5F * up, glm::vec3(NAN), 1.0F, 0.01F, 0.01F, 1.0F), 0.0F);
    EXPECT_EQ(sao(0.5F * up, up, NAN, 0.01F, 0.01F, 1.0F), 0.0F);
    EXPECT_EQ(sao(0.5F * up, up, 1.0F, NAN, 0.01F, 1.0F), 0.0F);
}

// The mean of the contributions over an infinite wall beside the point, against a quadrature in double.
TEST_F(Scalable, WallConvergesToItsOwnIntegral) {
    const double a = 0.25;
    std::vector<std::tuple<glm::vec3, glm::vec3, float, float, float, float>> inputs;
    double want = 0;
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const glm::dvec3 v(a, (i - 31.5) / 32, (j + 0.5) / 64);
            inputs.emplace_back(glm::vec3(v), up, 1.0F, 0.01F, 0.01F, 1.0F);
            const double vv = glm::dot(v, v);
            want += std::pow(std::max(1 - vv, 0.0), 3) * std::max(v.z - 0.01, 0.0) / (vv + 0.01);
        }
    }
    double got = 0;
    for (const float c : sao(inputs)) got += static_cast<double>(c);
    EXPECT_NEAR(got / want, 1.0, 1e-6);
}

TEST_F(Scalable, ContributionAndCombinationOfLevels) {
    const std::string file = "gloam/occlusion/mssao.glsl";
    const Kernel<float(glm::vec3, glm::vec3, float)> c(lab, file, "gloam_contribution_mssao");
    EXPECT_NEAR(c(up, up, 2.0F), 0.75, 1e-6);
    EXPECT_NEAR(c(glm::vec3(0.6F, 0, 0.8F), up, 2.0F), 0.75 * 0.8, 1e-6);
    EXPECT_EQ(c(2.0F * up, up, 2.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(0), up, 2.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(1, 0, 0), up, 2.0F), 0.0F);
    EXPECT_EQ(c(glm::vec3(NAN), up, 2.0F), 0.0F);
    const Kernel<float(float, float)> combine(lab, file, "gloam_mssao_combine");
    EXPECT_EQ(combine(0.0F, 0.0F), 0.0F);
    EXPECT_EQ(combine(1.0F, 0.2F), 1.0F);
    for (const float x : {0.1F, 0.25F, 0.5F, 0.9F}) {
        EXPECT_NEAR(combine(x, x), 1 - (1 - x) * (1 - x), 1e-6);  // one level
        for (const float mean : {0.0F, x / 3, x}) {
            EXPECT_GE(combine(x, mean), x);
            EXPECT_GE(combine(x, x), combine(x, mean));
        }
    }
    EXPECT_EQ(combine(NAN, 0.5F), 0.5F);
}

TEST_F(Scalable, FourPixelsIntoOne) {
    const std::string file = "gloam/filter/mssao_downsample.glsl";
    const Kernel<glm::vec4(glm::vec4, float)> weights(lab, file, "gloam_mssao_weights");
    EXPECT_EQ(weights(glm::vec4(3, 1, 2, 4), 5.0F), glm::vec4(0.5F, 0, 0.5F, 0));
    EXPECT_EQ(weights(glm::vec4(3, 1, 2, 4), 3.0F), glm::vec4(0.5F, 0, 0.5F, 0));
    EXPECT_EQ(weights(glm::vec4(3, 1, 2, 4), 2.5F), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(weights(glm::vec4(2), 0.0F), glm::vec4(0, 0.5F, 0.5F, 0));
    EXPECT_EQ(weights(glm::vec4(infinity, 1, 2, 1.5F), 5.0F), glm::vec4(0, 0, 0, 1));
    EXPECT_EQ(weights(glm::vec4(infinity, 0, 2, NAN), 5.0F), glm::vec4(0, 0, 1, 0));
    EXPECT_EQ(weights(glm::vec4(infinity, 0, -1, NAN), 5.0F), glm::vec4(0));
    EXPECT_EQ(weights(glm::vec4(3, 1, 2, 4), NAN), glm::vec4(0, 0, 1, 0));
    const Kernel<glm::vec3(glm::vec3, glm::vec3)> normal(lab, file, "gloam_mssao_normal");
    EXPECT_EQ(normal(up, -up), up);
    EXPECT_NEAR(normal(up, glm::vec3(1, 0, 0)).x, std::numbers::sqrt2 / 2, 1e-6);
    EXPECT_EQ(normal(up, glm::vec3(NAN)), up);
    EXPECT_EQ(normal(glm::vec3(NAN), up), glm::vec3(0));
}

TEST_F(Scalable, BlurWeights) {
    const Kernel<float(int, float, float)> w(lab, "gloam/filter/sao_blur.glsl", "gloam_sao_blur_weight");
    const double g[] = {0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    EXPECT_NEAR(w(0, 1.0F, 2000.0F), g[0], 1e-7);
    double sum = g[0];
    for (int r = 1; r <= 4; ++r) {
        EXPECT_NEAR(w(r, 0.0F, 2000.0F), 0.3 + g[r], 1e-7);
        EXPECT_EQ(w(r, 0.0F, 2000.0F), w(-r, 0.0F, 2000.0F));
        EXPECT_NEAR(w(r, -0.00025F, 2000.0F), (0.3 + g[r]) / 2, 1e-6);
        EXPECT_EQ(w(r, 0.001F, 2000.0F), 0.0F);
        EXPECT_NEAR(g[r] / g[0], std::exp(-r * r / 18.0),
                    1e-4);  // standard deviation 3, not the 2 that is said
        sum += 2 * g[r];
    }
    EXPECT_NEAR(sum, 1.0, 1e-5);
    EXPECT_EQ(w(5, 0.0F, 2000.0F), 0.0F);
    EXPECT_EQ(w(1, NAN, 2000.0F), 0.0F);
    EXPECT_GT(w(1, 0.0F, infinity), 0.4F);
}

}  // namespace gloam::scalable_test
