// SPDX-License-Identifier: MIT
// The convergence-aware filter on synthetic rows and images.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::filter_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();

// An image of (occlusion, convergence) and depth, seen head-on: neighbouring pixels lie `spacing` apart.
struct Pixels {
    glm::ivec2 size;
    std::function<glm::vec2(glm::ivec2)> value;
    std::function<float(glm::ivec2)> depth = [](glm::ivec2) { return 5.0F; };
    float spacing = 0.01F;

    check::ImageSet images() const {
        const auto position = [this](glm::ivec2 p) {
            const float d = depth(p);
            return std::isfinite(d)
                       ? glm::vec3(spacing * static_cast<float>(p.x), spacing * static_cast<float>(p.y), -d)
                       : glm::vec3(0);
        };
        return {{"gloam_fetch_occlusion_convergence", check::make_image<glm::vec2>(size, value)},
                {"gloam_fetch_position", check::make_image<glm::vec3>(size, position)}};
    }
};

class Filter : public testing::Test {
  protected:
    static constexpr float c_adaptive = 0.2F;
    static constexpr float sigma = 0.0125F;  // 1.25 pixels

    check::Lab lab = test::make_lab();
    Kernel<float(glm::ivec2, glm::ivec2, glm::ivec2, int, float, float)> filter{
        lab, "gloam/filter/convergence_filter.glsl", "gloam_convergence_filter"};

    float at(const Pixels& pixels, glm::ivec2 pixel, int half_width = 2, glm::ivec2 axis = {1, 0}) const {
        return filter.with_images(pixels.images(), {pixel, axis, pixels.size, half_width, c_adaptive, sigma});
    }
    // Every pixel along the axis.
    std::vector<float> all(const Pixels& pixels, glm::ivec2 axis) const {
        std::vector<std::tuple<glm::ivec2, glm::ivec2, glm::ivec2, int, float, float>> inputs;
        for (int y = 0; y < pixels.size.y; ++y) {
            for (int x = 0; x < pixels.size.x; ++x) {
                inputs.emplace_back(glm::ivec2(x, y), axis, pixels.size, 2, c_adaptive, sigma);
            }
        }
        return filter(inputs, pixels.images());
    }
};

float noise(glm::ivec2 p) {
    return static_cast<float>((p.x * 37 + p.y * 61 + p.x * p.y * 13) % 100) / 100.0F;
}

TEST_F(Filter, ShrinkIsLinearUpToTheThreshold) {
    const Kernel<float(float, float)> shrink(lab, "gloam/filter/shrink.glsl", "gloam_shrink");
    EXPECT_EQ(shrink(0.0F, 0.2F), 1.0F);
    EXPECT_EQ(shrink(0.1F, 0.2F), 0.5F);
    EXPECT_EQ(shrink(0.2F, 0.2F), 0.0F);
    EXPECT_EQ(shrink(0.3F, 0.2F), 0.0F);
    EXPECT_EQ(shrink(-1.0F, 0.2F), 1.0F);
    EXPECT_EQ(shrink(NAN, 0.2F), 1.0F);
    for (const float none : {0.0F, -1.0F, NAN}) {
        EXPECT_EQ(shrink(0.0F, none), 0.0F);
        EXPECT_EQ(shrink(NAN, none), 0.0F);
    }
}

TEST_F(Filter, GaussianOfDistance) {
    const Kernel<float(float, float)> g(lab, "gloam/filter/gaussian.glsl", "gloam_gaussian");
    EXPECT_EQ(g(0.0F, 1.0F), 1.0F);
    EXPECT_NEAR(g(4.0F, 2.0F), std::exp(-0.5), 2e-7);
    EXPECT_NEAR(g(1e-36F, 1e-18F), std::exp(-0.5), 2e-7);
    EXPECT_NEAR(g(1e36F, 1e18F), std::exp(-0.5), 2e-7);
    EXPECT_EQ(g(1e10F, 1.0F), 0.0F);
    EXPECT_EQ(g(0.0F, 0.0F), 1.0F);
    EXPECT_EQ(g(1.0F, 0.0F), 0.0F);
    EXPECT_EQ(g(1.0F, infinity), 1.0F);
    EXPECT_EQ(g(infinity, 1.0F), 0.0F);
    EXPECT_EQ(g(NAN, 1.0F), 0.0F);
    EXPECT_EQ(g(0.0F, NAN), 0.0F);
    EXPECT_EQ(g(1.0F, NAN), 0.0F);
    EXPECT_EQ(g(1e38F, infinity), 1.0F);
    EXPECT_EQ(g(infinity, infinity), 0.0F);
    EXPECT_EQ(g(-infinity, 1.0F), 0.0F);  // the sign does not count
    EXPECT_EQ(g(1.2e-38F, 1.2e-38F), 0.0F);
    EXPECT_EQ(g(1.2e-38F, -1.0F), 0.0F);
}

TEST_F(Filter, ScaleOfTheGaussianStandsForItsWidth) {
    const Kernel<float(float)> scale(lab, "gloam/filter/gaussian.glsl", "gloam_gaussian_scale");
    const Kernel<float(float, float)> g(lab, "gloam/filter/gaussian.glsl", "gloam_gaussian_scaled");
    EXPECT_NEAR(scale(1.0F), std::sqrt(0.5 / std::log(2.0)), 1e-7);
    EXPECT_EQ(scale(0.5F), 2.0F * scale(1.0F));
    EXPECT_NEAR(g(4.0F, scale(2.0F)), std::exp(-0.5), 2e-7);
    for (const float none : {0.0F, -1.0F, -infinity, 1e-40F}) EXPECT_EQ(scale(none), scale(0x1p-126F));
    for (const float all : {0x1p101F, infinity}) EXPECT_EQ(scale(all), 0.0F);
    EXPECT_EQ(scale(0x1p100F), 0x1p-100F * scale(1.0F));
    EXPECT_EQ(scale(NAN), infinity);
    for (const float distance : {0.0F, 1.0F, infinity, NAN}) {
        EXPECT_EQ(g(distance, infinity), 0.0F);
        EXPECT_EQ(g(distance, NAN), 0.0F);
    }
    EXPECT_EQ(g(0.0F, scale(0.0F)), 1.0F);
    EXPECT_EQ(g(0x1p-126F, scale(0.0F)), 0.0F);
    EXPECT_EQ(g(0x1.fffffep127F, scale(infinity)), 1.0F);
    EXPECT_EQ(g(infinity, scale(infinity)), 0.0F);
    EXPECT_EQ(g(NAN, 1.0F), 0.0F);
    EXPECT_EQ(g(-1.0F, 1.0F), g(1.0F, 1.0F));
    EXPECT_EQ(g(100.0F, 1.0F), 0.0F);
}

TEST_F(Filter, WidthIsSoManyPixelsInTheWorld) {
    const Kernel<float(float, float, float, float)> width(lab, "gloam/filter/gaussian.glsl",
                                                          "gloam_filter_sigma");
    EXPECT_NEAR(width(10.0F, 0.5F, 1000.0F, 1.25F), 0.0125, 1e-8);
    for (const float none : {0.0F, -1.0F, NAN}) {
        EXPECT_EQ(width(none, 0.5F, 1000.0F, 1.25F), 0.0F);
        EXPECT_EQ(width(10.0F, none, 1000.0F, 1.25F), 0.0F);
        EXPECT_EQ(width(10.0F, 0.5F, none, 1.25F), 0.0F);
        EXPECT_EQ(width(10.0F, 0.5F, 1000.0F, none), 0.0F);
    }
    EXPECT_EQ(width(infinity, 0.5F, 1000.0F, 1.25F), 0.0F);
}

TEST_F(Filter, NothingConvergedLeavesThePixel) {
    const Pixels pixels{.size = {9, 1}, .value = [](glm::ivec2 p) { return glm::vec2(noise(p), 0); }};
    for (int x = 0; x < 9; ++x) EXPECT_EQ(at(pixels, {x, 0}), noise({x, 0}));
}

TEST_F(Filter, ConstantStaysConstant) {
    for (const float value : {0.0F, 0.1F, 0.7F, 1.0F}) {
        const Pixels pixels{.size = {7, 5},
                            .value = [&](glm::ivec2 p) { return glm::vec2(value, 0.3F * noise(p)); }};
        for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            for (const float filtered : all(pixels, axis)) EXPECT_EQ(filtered, value);
        }
    }
}

TEST_F(Filter, LoneConvergedNeighbourGivesItsOwnValue) {
    for (const int neighbour : {2, 3, 5, 6}) {
        const Pixels pixels{.size = {9, 1}, .value = [&](glm::ivec2 p) {
                                return glm::vec2(noise(p), p.x == neighbour ? 0.37F : 0.0F);
                            }};
        EXPECT_EQ(at(pixels, {4, 0}), noise({neighbour, 0})) << neighbour;
    }
}

// The weighted mean of the equation, term by term.
TEST_F(Filter, RowIsTheSumOfTheEquation) {
    const auto convergence = [](int x) { return x == 4 ? 0.05F : 0.02F * static_cast<float>(x + 1); };
    const Pixels pixels{.size = {9, 1},
                        .value = [&](glm::ivec2 p) { return glm::vec2(noise(p), convergence(p.x)); }};
    const double reach = 2 * (0.2 - 0.05) / 0.2;  // 1.5 pixels: half of the outer pixels counts
    double sum = 0.0;
    double weights = 0.0;
    for (int x = 2; x <= 6; ++x) {
        const int offset = std::abs(x - 4);
        const double distance = 0.01 * offset;
        const double weight = std::clamp(reach + 1 - offset, 0.0, 1.0) * static_cast<double>(convergence(x)) *
                              std::exp(-distance * distance / (2 * 0.0125 * 0.0125));
        sum += weight * static_cast<double>(noise({x, 0}));
        weights += weight;
    }
    EXPECT_NEAR(at(pixels, {4, 0}), sum / weights, 1e-6);
}

TEST_F(Filter, ChangesSmoothlyAsThePixelConverges) {
    float before = -1.0F;
    for (int i = 0; i <= 400; ++i) {
        const float own = 0.0005F * static_cast<float>(i) + 0.001F;
        const Pixels pixels{.size = {9, 1}, .value = [&](glm::ivec2 p) {
                                return p.x == 4 ? glm::vec2(0, own) : glm::vec2(1, 0.1F);
                            }};
        const float now = at(pixels, {4, 0});
        if (before >= 0.0F) {
            EXPECT_LT(std::abs(now - before), 0.02F) << own;
        }
        before = now;
    }
    EXPECT_EQ(before, 0.0F);
}

TEST_F(Filter, NothingLeaksOverADepthEdge) {
    const Pixels pixels{.size = {8, 1},
                        .value = [](glm::ivec2 p) { return p.x < 4 ? glm::vec2(0, 0.01F) : glm::vec2(1, 1); },
                        .depth = [](glm::ivec2 p) { return p.x < 4 ? 5.0F : 6.0F; }};
    for (int x = 0; x < 4; ++x) EXPECT_LT(at(pixels, {x, 0}), 1e-6F) << x;
}

TEST_F(Filter, BackgroundAndPoisonHaveNoWeight) {
    for (const float bad : {NAN, infinity, -0.5F, 1.5F}) {
        const Pixels pixels{.size = {5, 1}, .value = [&](glm::ivec2 p) {
                                return p.x == 1 ? glm::vec2(bad, 1)
                                                : glm::vec2(p.x == 3 ? 0.5F : 0.0F, p.x == 3 ? 0.5F : 0.0F);
                            }};
        EXPECT_EQ(at(pixels, {2, 0}), 0.5F) << bad;
    }
    const Pixels sky{
        .size = {5, 1},
        .value = [](glm::ivec2 p) { return p.x == 2 ? glm::vec2(0.25F, 0.01F) : glm::vec2(1, 1); },
        .depth = [](glm::ivec2 p) { return p.x == 2 ? 5.0F : infinity; }};
    EXPECT_EQ(at(sky, {2, 0}), 0.25F);
    const Pixels all_sky{.size = {3, 3},
                         .value = [](glm::ivec2 p) { return glm::vec2(noise(p), 0.1F); },
                         .depth = [](glm::ivec2) { return infinity; }};
    EXPECT_EQ(at(all_sky, {1, 1}), noise({1, 1}));
    const Pixels poisoned{.size = {1, 1}, .value = [](glm::ivec2) { return glm::vec2(NAN, NAN); }};
    EXPECT_EQ(at(poisoned, {0, 0}), 0.0F);
}

TEST_F(Filter, SmallImages) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 1), glm::ivec2(1, 3), glm::ivec2(3, 3)}) {
        const Pixels pixels{.size = size, .value = [](glm::ivec2 p) { return glm::vec2(noise(p), 0.1F); }};
        for (const glm::ivec2 axis : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
            for (const float filtered : all(pixels, axis)) {
                EXPECT_GE(filtered, 0.0F);
                EXPECT_LE(filtered, 1.0F);
            }
        }
    }
    const Pixels one{.size = {1, 1}, .value = [](glm::ivec2) { return glm::vec2(0.3F, 0.1F); }};
    EXPECT_EQ(at(one, {0, 0}, 1000000), 0.3F);
    EXPECT_EQ(at(one, {0, 0}, -1), 0.3F);
}

// The image is smaller than the size passed to the shader, so reading a neighbour is a fault. A pixel that
// passes has read none.
TEST_F(Filter, ConvergedPixelReadsNoNeighbour) {
    const auto run = [&](float convergence) {
        const Pixels pixels{.size = {1, 1},
                            .value = [&](glm::ivec2) { return glm::vec2(0.3F, convergence); }};
        return filter.with_images(pixels.images(),
                                  {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(5), 2, c_adaptive, sigma});
    };
    EXPECT_EQ(run(0.2F), 0.3F);
    EXPECT_EQ(run(1.0F), 0.3F);
    EXPECT_THROW((void)run(0.1F), std::runtime_error);
}

// Half the resolution and back: what holds of any depths.

constexpr const char* file = "gloam/filter/upsample.glsl";

class Upsample : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const Kernel<float(float, glm::vec4, glm::vec4, bool)> upsample{lab, file, "gloam_upsample"};
    const Kernel<bool(float, float, float, bool)> continues{lab, file, "gloam_upsample_continues"};
};

// Through any three pixels in a row of a plane, however steep, the surface continues; through a step of 1.3 %
// of the depth it does not.
TEST_F(Upsample, PlanesContinueAndStepsDoNot) {
    for (const float slope : {0.0F, 0.01F, 0.3F, 0.9F}) {
        const auto depth = [&](float x) { return 1.0F / (1.0F + slope * x); };  // perspective
        EXPECT_TRUE(continues(depth(0), depth(-1), depth(1), false)) << slope;
        EXPECT_TRUE(continues(1.0F, 1.0F - slope, 1.0F + slope, true)) << slope;
    }
    for (const bool orthographic : {false, true}) {
        EXPECT_FALSE(continues(1.0F, 1.0F, 1.013F, orthographic));
        EXPECT_FALSE(continues(1.0F, 1.0F, 0.987F, orthographic));
        EXPECT_FALSE(continues(1.0F, 1.013F, 1.013F, orthographic));
        EXPECT_FALSE(continues(1.0F, infinity, 1.0F, orthographic));
        EXPECT_FALSE(continues(infinity, infinity, infinity, orthographic));
        EXPECT_FALSE(continues(1.0F, NAN, 1.0F, orthographic));
    }
    EXPECT_FALSE(continues(1.0F, 0.5F, 1.5F, false)) << "not a plane of a perspective camera";
    EXPECT_TRUE(continues(1.0F, 0.5F, 1.5F, true));
}

// What is on the pixel's surface counts, and only that.
TEST_F(Upsample, OnlyTheSurfaceOfThePixelCounts) {
    const glm::vec4 occlusions(0.1F, 0.3F, 0.5F, 0.9F);
    const auto at = [&](glm::vec4 depths) { return upsample(2.0F, depths, occlusions, false); };
    EXPECT_NEAR(at(glm::vec4(2)), 0.45F, 1e-6F);
    EXPECT_NEAR(at(glm::vec4(2, 2, 2, 4)), 0.4F, 1e-6F) << "the pair of y and z";
    EXPECT_NEAR(at(glm::vec4(2, 1, 2, 2)), 0.5F, 1e-6F) << "the pair of x and w";
    EXPECT_EQ(at(glm::vec4(4, 4, 2.1F, 4)), 0.5F) << "the nearest";
    EXPECT_EQ(at(glm::vec4(1.9F, 4, 4, 4)), 0.1F);
    EXPECT_EQ(at(glm::vec4(infinity, 4, 0, NAN)), 0.3F);
    EXPECT_EQ(at(glm::vec4(infinity)), 0.0F);
    EXPECT_EQ(upsample(infinity, glm::vec4(2), occlusions, false), 0.0F);
    EXPECT_EQ(upsample(2.0F, glm::vec4(2), glm::vec4(NAN), false), 0.0F);
    EXPECT_EQ(upsample(2.0F, glm::vec4(2), glm::vec4(5), false), 1.0F);
}

TEST_F(Upsample, AConstantStays) {
    numeric::Random random(7);
    for (int i = 0; i < 200; ++i) {
        const auto value = static_cast<float>(random.uniform(0, 1));
        glm::vec4 depths(0);
        for (int k = 0; k < 4; ++k)
            depths[k] = static_cast<float>(random.uniform(0.99, i % 2 == 0 ? 1.01 : 3.0));
        EXPECT_EQ(upsample(1.0F, depths, glm::vec4(value), i % 3 == 0), value);
    }
}

}  // namespace gloam::filter_test
