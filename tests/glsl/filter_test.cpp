// SPDX-License-Identifier: MIT
// The filters on synthetic rows and images: the convergence-aware one, the bilateral filter of ISSAO and the
// study's geometry-aware blur, and those of half the resolution. Of the references: tests/catalogue compares
// each function of the library with its reference.
#include "reference/filter.hpp"
#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::reference::filter_test {

using glm::ivec2;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double c_adaptive = 0.2;
constexpr double sigma = 0.0125;  // 1.25 pixels

double noise(ivec2 p) {
    return ((p.x * 37 + p.y * 61 + p.x * p.y * 13) % 100) / 100.0;
}

// An image of (occlusion, convergence) and depth, seen head-on: neighbouring pixels lie 0.01 apart.
struct Pixels {
    ivec2 size;
    Fetch<dvec2> value;
    Fetch<double> depth = [](ivec2) { return 5.0; };

    double at(ivec2 pixel, int half_width = 2, ivec2 axis = {1, 0}) const {
        const auto position = [this](ivec2 p) {
            return std::isfinite(depth(p)) ? dvec3(0.01 * dvec2(p), -depth(p)) : dvec3(0);
        };
        return gloam_convergence_filter(pixel, axis, size, half_width, c_adaptive, sigma, value, position);
    }

    // Every pixel along each axis.
    std::vector<double> all() const {
        std::vector<double> filtered;
        for (const ivec2 axis : {ivec2(1, 0), ivec2(0, 1)})
            for (int i = 0; i < size.x * size.y; ++i)
                filtered.push_back(at({i % size.x, i / size.x}, 2, axis));
        return filtered;
    }
};

TEST(Filter, NothingConvergedLeavesThePixel) {
    const Pixels pixels{.size = {9, 1}, .value = [](ivec2 p) { return dvec2(noise(p), 0); }};
    for (int x = 0; x < 9; ++x) EXPECT_EQ(pixels.at({x, 0}), noise({x, 0}));
}

TEST(Filter, ConstantStaysConstant) {
    for (const double value : {0.0, 0.1, 0.7, 1.0}) {
        const Pixels pixels{.size = {7, 5}, .value = [&](ivec2 p) { return dvec2(value, 0.3 * noise(p)); }};
        EXPECT_THAT(pixels.all(), Each(value));
    }
}

TEST(Filter, LoneConvergedNeighbourGivesItsOwnValue) {
    for (const int neighbour : {2, 3, 5, 6}) {
        const auto value = [&](ivec2 p) { return dvec2(noise(p), p.x == neighbour ? 0.37 : 0.0); };
        EXPECT_EQ((Pixels{{9, 1}, value}.at({4, 0})), noise({neighbour, 0})) << neighbour;
    }
}

// The weighted mean of the equation, term by term.
TEST(Filter, RowIsTheSumOfTheEquation) {
    const auto convergence = [](int x) { return x == 4 ? 0.05 : 0.02 * (x + 1); };
    const Pixels pixels{.size = {9, 1}, .value = [&](ivec2 p) { return dvec2(noise(p), convergence(p.x)); }};
    const double reach = 2 * (0.2 - 0.05) / 0.2;  // 1.5 pixels: half of the outer pixels counts
    double sum = 0.0;
    double weights = 0.0;
    for (int x = 2; x <= 6; ++x) {
        const double distance = 0.01 * std::abs(x - 4);
        const double weight = std::clamp(reach + 1 - std::abs(x - 4), 0.0, 1.0) * convergence(x) *
                              std::exp(-distance * distance / (2 * sigma * sigma));
        sum += weight * noise({x, 0});
        weights += weight;
    }
    EXPECT_NEAR(pixels.at({4, 0}), sum / weights, 1e-9);
}

TEST(Filter, ChangesSmoothlyAsThePixelConverges) {
    double before = nothing;
    for (int i = 0; i <= 400; ++i) {
        const double own = 0.0005 * i + 0.001;
        const auto value = [&](ivec2 p) { return p.x == 4 ? dvec2(0, own) : dvec2(1, 0.1); };
        const double now = Pixels{{9, 1}, value}.at({4, 0});
        EXPECT_FALSE(std::abs(now - before) >= 0.02) << own;
        before = now;
    }
    EXPECT_EQ(before, 0.0);
}

TEST(Filter, NothingLeaksOverADepthEdge) {
    const Pixels pixels{.size = {8, 1},
                        .value = [](ivec2 p) { return p.x < 4 ? dvec2(0, 0.01) : dvec2(1, 1); },
                        .depth = [](ivec2 p) { return p.x < 4 ? 5.0 : 6.0; }};
    for (int x = 0; x < 4; ++x) EXPECT_LT(pixels.at({x, 0}), 1e-6) << x;
}

TEST(Filter, BackgroundAndPoisonHaveNoWeight) {
    for (const double bad : {nothing, infinity, -0.5, 1.5}) {
        const auto value = [&](ivec2 p) { return p.x == 1 ? dvec2(bad, 1) : dvec2(p.x == 3 ? 0.5 : 0.0); };
        EXPECT_EQ((Pixels{{5, 1}, value}.at({2, 0})), 0.5) << bad;
    }
    const auto lone = [](ivec2 p) { return p.x == 2 ? dvec2(0.25, 0.01) : dvec2(1, 1); };
    EXPECT_EQ((Pixels{{5, 1}, lone, [](ivec2 p) { return p.x == 2 ? 5.0 : infinity; }}.at({2, 0})), 0.25);
    const auto rough = [](ivec2 p) { return dvec2(noise(p), 0.1); };
    EXPECT_EQ((Pixels{{3, 3}, rough, [](ivec2) { return infinity; }}.at({1, 1})), noise({1, 1}));
    EXPECT_EQ((Pixels{{1, 1}, [](ivec2) { return dvec2(nothing); }}.at({0, 0})), 0.0);
}

TEST(Filter, SmallImages) {
    for (const ivec2 size : {ivec2(1, 1), ivec2(3, 1), ivec2(1, 3), ivec2(3, 3)}) {
        const Pixels pixels{.size = size, .value = [](ivec2 p) { return dvec2(noise(p), 0.1); }};
        EXPECT_THAT(pixels.all(), Each(AllOf(testing::Ge(0.0), testing::Le(1.0))));
    }
    const Pixels one{.size = {1, 1}, .value = [](ivec2) { return dvec2(0.3, 0.1); }};
    for (const int half_width : {1000000, -1}) EXPECT_EQ(one.at({0, 0}, half_width), 0.3);
}

// The image is smaller than the size passed to the shader, so reading a neighbour is a fault. A pixel that
// passes has read none.
TEST(Filter, ConvergedPixelReadsNoNeighbour) {
    const check::Lab lab = test::make_lab();
    const check::Function<float(ivec2, ivec2, ivec2, int, float, float)> filter{
        lab, "gloam/filter/convergence_filter.glsl", "gloam_convergence_filter"};
    const auto run = [&](float convergence) {
        const auto value = [&](ivec2) { return glm::vec2(0.3F, convergence); };
        const check::ImageSet images{
            {"gloam_fetch_occlusion_convergence", check::make_image<glm::vec2>({1, 1}, value)},
            {"gloam_fetch_position",
             check::make_image<glm::vec3>({1, 1}, [](ivec2) { return glm::vec3(0, 0, -5); })}};
        return filter.with_images(images, {ivec2(0), ivec2(1, 0), ivec2(5), 2, 0.2F, 0.0125F});
    };
    EXPECT_EQ(run(0.2F), 0.3F);
    EXPECT_EQ(run(1.0F), 0.3F);
    EXPECT_THROW((void)run(0.1F), std::runtime_error);
}

// What the filters read.
struct Surface {
    ivec2 size{7, 5};
    Fetch<double> occlusion = [](ivec2) { return 0.25; };
    Fetch<double> depth = [](ivec2) { return 5.0; };
    Fetch<dvec3> normal = [](ivec2) { return dvec3(0, 0, 1); };

    double bilateral(ivec2 pixel, ivec2 half_width = ivec2(2), double sigma_d = 2.0,
                     double sigma_r = 0.1) const {
        return gloam_bilateral_filter(pixel, half_width, size, sigma_d, sigma_r, occlusion, depth);
    }
    double blur(ivec2 pixel, ivec2 axis = {1, 0}, int half_width = 2) const {
        return gloam_geometry_blur(pixel, axis, size, half_width, {10, 0.5}, occlusion, depth, normal);
    }
};

TEST(EdgeAware, BilateralFilter) {
    Surface s;
    EXPECT_EQ(s.bilateral({3, 2}), 0.25);  // constant stays constant
    EXPECT_EQ(s.bilateral({0, 0}), 0.25);
    s.occlusion = [](ivec2 p) { return p == ivec2(3, 2) ? 1.0 : 0.0; };
    double sum = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) sum += std::exp(-(x * x + y * y) / 8.0);
    EXPECT_NEAR(s.bilateral({3, 2}), 1 / sum, 1e-9);
    EXPECT_NEAR(s.bilateral({2, 2}), std::exp(-1 / 8.0) / sum, 0.03);  // one column is outside
    EXPECT_EQ(s.bilateral({0, 2}), 0.0);
    EXPECT_EQ(s.bilateral({3, 2}, ivec2(0)), 1.0);
    EXPECT_GT(s.bilateral({3, 2}, {2, 0}), s.bilateral({3, 2}));
    EXPECT_GT(s.bilateral({3, 2}, ivec2(2), 1.0), s.bilateral({3, 2}));
    s = {.size = {1, 1}, .occlusion = [](ivec2) { return 0.5; }};
    EXPECT_EQ(s.bilateral({0, 0}, {2147483647, -3}), 0.5);
}

TEST(EdgeAware, BilateralFilterKeepsToItsSurface) {
    Surface s{.occlusion = [](ivec2 p) { return p.x < 4 ? 0.25 : 0.75; },
              .depth = [](ivec2 p) { return p.x < 4 ? 5.0 : 6.0; }};
    EXPECT_NEAR(s.bilateral({3, 2}), 0.25, 1e-6);
    EXPECT_NEAR(s.bilateral({4, 2}), 0.75, 1e-6);
    EXPECT_GT(s.bilateral({3, 2}, ivec2(2), 2.0, 10.0), 0.3);
    s.depth = [](ivec2 p) { return p.x < 4 ? 5.0 : infinity; };  // background
    EXPECT_EQ(s.bilateral({3, 2}), 0.25);
    EXPECT_EQ(s.bilateral({5, 2}), 0.75);
    const Surface poisoned{.occlusion = [](ivec2 p) { return p.x == 2 ? nothing : 0.25; }};
    for (const int x : {2, 3}) EXPECT_EQ(poisoned.bilateral({x, 2}), 0.25);
}

TEST(EdgeAware, GeometryBlur) {
    EXPECT_EQ(Surface{}.blur({3, 2}), 0.25);
    Surface s{.occlusion = [](ivec2 p) { return p.x == 3 ? 1.0 : 0.0; }};
    EXPECT_NEAR(s.blur({3, 2}), 0.2, 1e-9);  // a box: no weight by distance
    EXPECT_EQ(s.blur({3, 2}, {0, 1}), 1.0);  // along the other axis
    EXPECT_EQ(s.blur({3, 2}, {1, 0}, 0), 1.0);
    EXPECT_NEAR(s.blur({0, 2}, {1, 0}, 3), 0.25, 1e-9);  // neighbours outside are left out
    Surface edge = s;
    edge.normal = [](ivec2 p) { return p.x == 3 ? dvec3(1, 0, 0) : dvec3(0, 0, 1); };
    EXPECT_NEAR(edge.blur({2, 2}), std::exp2(-10) / (4 + std::exp2(-10)), 1e-9);
    s.depth = [](ivec2 p) { return p.x == 3 ? 8.0 : 5.0; };
    EXPECT_NEAR(s.blur({2, 2}), 0.5 / 4.5, 1e-9);
    s.depth = [](ivec2 p) { return p.x == 3 ? infinity : 5.0; };
    EXPECT_EQ(s.blur({2, 2}), 0.0);
    EXPECT_EQ(s.blur({3, 2}), 1.0);
    const Surface poisoned{.occlusion = [](ivec2 p) { return p.x == 3 ? nothing : 0.25; }};
    for (const int x : {2, 3}) EXPECT_EQ(poisoned.blur({x, 2}), 0.25);
}

}  // namespace gloam::reference::filter_test
