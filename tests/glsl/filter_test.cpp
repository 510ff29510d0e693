// SPDX-License-Identifier: MIT
// The filters on synthetic rows and images: the convergence-aware one, the bilateral filter of ISSAO and the
// study's geometry-aware blur, and those of half the resolution.
#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::filter_test {

using check::Function;

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
    Function<float(glm::ivec2, glm::ivec2, glm::ivec2, int, float, float)> filter{
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

TEST_F(Filter, ScaleOfTheGaussianStandsForItsWidth) {
    const Function<float(float)> scale(lab, "gloam/filter/gaussian.glsl", "gloam_gaussian_scale");
    const Function<float(float, float)> g(lab, "gloam/filter/gaussian.glsl", "gloam_gaussian_scaled");
    EXPECT_EQ(scale(0.5F), 2.0F * scale(1.0F));
    EXPECT_EQ(scale(0x1p100F), 0x1p-100F * scale(1.0F));
    for (const float none : {0.0F, -1.0F, -infinity, 1e-40F}) EXPECT_EQ(scale(none), scale(0x1p-126F));
    EXPECT_EQ(g(0.0F, scale(0.0F)), 1.0F);
    EXPECT_EQ(g(0x1p-126F, scale(0.0F)), 0.0F);
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

// What the filters read.
struct Surface {
    glm::ivec2 size{7, 5};
    std::function<float(glm::ivec2)> occlusion = [](glm::ivec2) { return 0.25F; };
    std::function<float(glm::ivec2)> depth = [](glm::ivec2) { return 5.0F; };
    std::function<glm::vec3(glm::ivec2)> normal = [](glm::ivec2) { return glm::vec3(0, 0, 1); };

    check::ImageSet images(bool with_normals) const {
        check::ImageSet set{{"gloam_fetch_occlusion", check::make_image<float>(size, occlusion)},
                            {"gloam_fetch_depth", check::make_image<float>(size, depth)}};
        if (with_normals) set.emplace("gloam_fetch_normal", check::make_image<glm::vec3>(size, normal));
        return set;
    }
};

class EdgeAware : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    Function<float(glm::ivec2, glm::ivec2, glm::ivec2, float, float)> bilateral_filter{
        lab, "gloam/filter/bilateral.glsl", "gloam_bilateral_filter"};
    Function<float(glm::ivec2, glm::ivec2, glm::ivec2, int, glm::vec2)> geometry_blur{
        lab, "gloam/filter/geometry_blur.glsl", "gloam_geometry_blur"};

    float bilateral(const Surface& s, glm::ivec2 pixel, glm::ivec2 half_width = glm::ivec2(2),
                    float sigma_d = 2.0F, float sigma_r = 0.1F) const {
        return bilateral_filter.with_images(s.images(false), {pixel, half_width, s.size, sigma_d, sigma_r});
    }
    float blur(const Surface& s, glm::ivec2 pixel, glm::ivec2 axis = {1, 0}, int half_width = 2) const {
        return geometry_blur.with_images(s.images(true),
                                         {pixel, axis, s.size, half_width, glm::vec2(10, 0.5F)});
    }
};

TEST_F(EdgeAware, BilateralFilter) {
    Surface s;
    EXPECT_EQ(bilateral(s, glm::ivec2(3, 2)), 0.25F);  // constant stays constant
    EXPECT_EQ(bilateral(s, glm::ivec2(0, 0)), 0.25F);
    s.occlusion = [](glm::ivec2 p) { return p == glm::ivec2(3, 2) ? 1.0F : 0.0F; };
    double sum = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) sum += std::exp(-(x * x + y * y) / 8.0);
    EXPECT_NEAR(bilateral(s, glm::ivec2(3, 2)), 1 / sum, 1e-6);
    EXPECT_NEAR(bilateral(s, glm::ivec2(2, 2)), std::exp(-1 / 8.0) / sum, 0.03);  // one column is outside
    EXPECT_EQ(bilateral(s, glm::ivec2(0, 2)), 0.0F);
    EXPECT_EQ(bilateral(s, glm::ivec2(3, 2), glm::ivec2(0)), 1.0F);
    EXPECT_GT(bilateral(s, glm::ivec2(3, 2), glm::ivec2(2, 0)), bilateral(s, glm::ivec2(3, 2)));
    EXPECT_GT(bilateral(s, glm::ivec2(3, 2), glm::ivec2(2), 1.0F), bilateral(s, glm::ivec2(3, 2)));
    s.size = glm::ivec2(1, 1);
    s.occlusion = [](glm::ivec2) { return 0.5F; };
    EXPECT_EQ(bilateral(s, glm::ivec2(0, 0), glm::ivec2(2147483647, -3)), 0.5F);
}

TEST_F(EdgeAware, BilateralFilterKeepsToItsSurface) {
    Surface s;
    s.depth = [](glm::ivec2 p) { return p.x < 4 ? 5.0F : 6.0F; };
    s.occlusion = [](glm::ivec2 p) { return p.x < 4 ? 0.25F : 0.75F; };
    EXPECT_NEAR(bilateral(s, glm::ivec2(3, 2)), 0.25, 1e-6);
    EXPECT_NEAR(bilateral(s, glm::ivec2(4, 2)), 0.75, 1e-6);
    EXPECT_GT(bilateral(s, glm::ivec2(3, 2), glm::ivec2(2), 2.0F, 10.0F), 0.3F);
    s.depth = [](glm::ivec2 p) { return p.x < 4 ? 5.0F : infinity; };  // background
    EXPECT_EQ(bilateral(s, glm::ivec2(3, 2)), 0.25F);
    EXPECT_EQ(bilateral(s, glm::ivec2(5, 2)), 0.75F);
    s.depth = [](glm::ivec2) { return 5.0F; };
    s.occlusion = [](glm::ivec2 p) { return p.x == 2 ? NAN : 0.25F; };
    EXPECT_EQ(bilateral(s, glm::ivec2(3, 2)), 0.25F);
    EXPECT_EQ(bilateral(s, glm::ivec2(2, 2)), 0.25F);
}

TEST_F(EdgeAware, GeometryBlur) {
    Surface s;
    EXPECT_EQ(blur(s, glm::ivec2(3, 2)), 0.25F);
    s.occlusion = [](glm::ivec2 p) { return p.x == 3 ? 1.0F : 0.0F; };
    EXPECT_NEAR(blur(s, glm::ivec2(3, 2)), 0.2, 1e-6);             // a box: no weight by distance
    EXPECT_EQ(blur(s, glm::ivec2(3, 2), glm::ivec2(0, 1)), 1.0F);  // along the other axis
    EXPECT_EQ(blur(s, glm::ivec2(3, 2), glm::ivec2(1, 0), 0), 1.0F);
    EXPECT_NEAR(blur(s, glm::ivec2(0, 2), glm::ivec2(1, 0), 3), 0.25,
                1e-6);  // neighbours outside are left out
    s.normal = [](glm::ivec2 p) { return p.x == 3 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1); };
    EXPECT_NEAR(blur(s, glm::ivec2(2, 2)), std::pow(2.0, -10) / (4 + std::pow(2.0, -10)), 1e-6);
    s.normal = [](glm::ivec2) { return glm::vec3(0, 0, 1); };
    s.depth = [](glm::ivec2 p) { return p.x == 3 ? 8.0F : 5.0F; };
    EXPECT_NEAR(blur(s, glm::ivec2(2, 2)), 0.5 / 4.5, 1e-6);
    s.depth = [](glm::ivec2 p) { return p.x == 3 ? infinity : 5.0F; };
    EXPECT_EQ(blur(s, glm::ivec2(2, 2)), 0.0F);
    EXPECT_EQ(blur(s, glm::ivec2(3, 2)), 1.0F);
    s.depth = [](glm::ivec2) { return 5.0F; };
    s.occlusion = [](glm::ivec2 p) { return p.x == 3 ? NAN : 0.25F; };
    EXPECT_EQ(blur(s, glm::ivec2(2, 2)), 0.25F);
    EXPECT_EQ(blur(s, glm::ivec2(3, 2)), 0.25F);
}

// Half the resolution and back: what holds of any depths.

constexpr const char* file = "gloam/filter/upsample.glsl";

class Upsample : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const Function<float(float, glm::vec4, glm::vec4, bool)> upsample{lab, file, "gloam_upsample"};
    const Function<bool(float, float, float, bool)> continues{lab, file, "gloam_upsample_continues"};
};

// Through any three pixels in a row of a plane, however steep.
TEST_F(Upsample, PlanesContinue) {
    for (const float slope : {0.0F, 0.01F, 0.3F, 0.9F}) {
        const auto depth = [&](float x) { return 1.0F / (1.0F + slope * x); };  // perspective
        EXPECT_TRUE(continues(depth(0), depth(-1), depth(1), false)) << slope;
        EXPECT_TRUE(continues(1.0F, 1.0F - slope, 1.0F + slope, true)) << slope;
    }
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
