// SPDX-License-Identifier: MIT
// Filters that look at depth and normals: the bilateral filter of ISSAO and the study's geometry-aware blur.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/lab.hpp"

namespace gloam::edge_aware_test {

using check::Kernel;
using glm::ivec2;
using glm::vec2;
using glm::vec3;

constexpr float infinity = std::numeric_limits<float>::infinity();

// What the filters read.
struct Surface {
    ivec2 size{7, 5};
    std::function<float(ivec2)> occlusion = [](ivec2) { return 0.25F; };
    std::function<float(ivec2)> depth = [](ivec2) { return 5.0F; };
    std::function<vec3(ivec2)> normal = [](ivec2) { return vec3(0, 0, 1); };

    check::ImageSet images(bool with_normals) const {
        check::ImageSet set{{"gloam_fetch_occlusion", check::make_image<float>(size, occlusion)},
                            {"gloam_fetch_depth", check::make_image<float>(size, depth)}};
        if (with_normals) set.emplace("gloam_fetch_normal", check::make_image<vec3>(size, normal));
        return set;
    }
};

class EdgeAware : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    Kernel<float(vec2, float, float, float)> bilateral_weight{lab, "gloam/filter/bilateral_weight.glsl",
                                                              "gloam_bilateral_weight"};
    Kernel<float(ivec2, ivec2, ivec2, float, float)> bilateral_filter{lab, "gloam/filter/bilateral.glsl",
                                                                      "gloam_bilateral_filter"};
    Kernel<float(vec3, vec3, float, float, float)> geometry_weight{lab, "gloam/filter/geometry_weight.glsl",
                                                                   "gloam_geometry_weight"};
    Kernel<float(ivec2, ivec2, ivec2, int, vec2)> geometry_blur{lab, "gloam/filter/geometry_blur.glsl",
                                                                "gloam_geometry_blur"};

    float bilateral(const Surface& s, ivec2 pixel, ivec2 half_width = ivec2(2), float sigma_d = 2.0F,
                    float sigma_r = 0.1F) const {
        return bilateral_filter.with_images(s.images(false), {pixel, half_width, s.size, sigma_d, sigma_r});
    }
    float blur(const Surface& s, ivec2 pixel, ivec2 axis = {1, 0}, int half_width = 2) const {
        return geometry_blur.with_images(s.images(true), {pixel, axis, s.size, half_width, vec2(10, 0.5F)});
    }
};

TEST_F(EdgeAware, BilateralWeight) {
    EXPECT_EQ(bilateral_weight(vec2(0), 0.0F, 2.0F, 0.1F), 1.0F);
    EXPECT_NEAR(bilateral_weight(vec2(0, 2), 0.0F, 2.0F, 0.1F), 0.606531, 1e-6);  // T27
    EXPECT_NEAR(bilateral_weight(vec2(0), 0.1F, 2.0F, 0.1F), 0.606531, 1e-6);
    EXPECT_NEAR(bilateral_weight(vec2(0), 0.5F, 2.0F, 0.1F), 3.7e-6, 1e-7);
    EXPECT_NEAR(bilateral_weight(vec2(2, 0), -0.1F, 2.0F, 0.1F), 0.367879, 1e-6);
    EXPECT_EQ(bilateral_weight(vec2(1, 0), 0.0F, 0.0F, 0.1F), 0.0F);  // the identity
    EXPECT_EQ(bilateral_weight(vec2(0), 0.1F, 2.0F, 0.0F), 0.0F);
    EXPECT_EQ(bilateral_weight(vec2(0), 0.0F, 0.0F, 0.0F), 1.0F);
    EXPECT_EQ(bilateral_weight(vec2(0), NAN, 2.0F, 0.1F), 0.0F);
    EXPECT_EQ(bilateral_weight(vec2(0), infinity, 2.0F, 0.1F), 0.0F);
}

TEST_F(EdgeAware, BilateralFilter) {
    Surface s;
    EXPECT_EQ(bilateral(s, ivec2(3, 2)), 0.25F);  // constant stays constant
    EXPECT_EQ(bilateral(s, ivec2(0, 0)), 0.25F);
    s.occlusion = [](ivec2 p) { return p == ivec2(3, 2) ? 1.0F : 0.0F; };
    double sum = 0.0;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) sum += std::exp(-(x * x + y * y) / 8.0);
    EXPECT_NEAR(bilateral(s, ivec2(3, 2)), 1 / sum, 1e-6);
    EXPECT_NEAR(bilateral(s, ivec2(2, 2)), std::exp(-1 / 8.0) / sum, 0.03);  // one column is outside
    EXPECT_EQ(bilateral(s, ivec2(0, 2)), 0.0F);
    EXPECT_EQ(bilateral(s, ivec2(3, 2), ivec2(0)), 1.0F);
    EXPECT_GT(bilateral(s, ivec2(3, 2), ivec2(2, 0)), bilateral(s, ivec2(3, 2)));
    EXPECT_GT(bilateral(s, ivec2(3, 2), ivec2(2), 1.0F), bilateral(s, ivec2(3, 2)));
    s.size = ivec2(1, 1);
    s.occlusion = [](ivec2) { return 0.5F; };
    EXPECT_EQ(bilateral(s, ivec2(0, 0), ivec2(2147483647, -3)), 0.5F);
}

TEST_F(EdgeAware, BilateralFilterKeepsToItsSurface) {
    Surface s;
    s.depth = [](ivec2 p) { return p.x < 4 ? 5.0F : 6.0F; };
    s.occlusion = [](ivec2 p) { return p.x < 4 ? 0.25F : 0.75F; };
    EXPECT_NEAR(bilateral(s, ivec2(3, 2)), 0.25, 1e-6);
    EXPECT_NEAR(bilateral(s, ivec2(4, 2)), 0.75, 1e-6);
    EXPECT_GT(bilateral(s, ivec2(3, 2), ivec2(2), 2.0F, 10.0F), 0.3F);
    s.depth = [](ivec2 p) { return p.x < 4 ? 5.0F : infinity; };  // background
    EXPECT_EQ(bilateral(s, ivec2(3, 2)), 0.25F);
    EXPECT_EQ(bilateral(s, ivec2(5, 2)), 0.75F);
    s.depth = [](ivec2) { return 5.0F; };
    s.occlusion = [](ivec2 p) { return p.x == 2 ? NAN : 0.25F; };
    EXPECT_EQ(bilateral(s, ivec2(3, 2)), 0.25F);
    EXPECT_EQ(bilateral(s, ivec2(2, 2)), 0.25F);
}

// T32.
TEST_F(EdgeAware, GeometryWeight) {
    const vec3 n(0, 0, 1);
    EXPECT_EQ(geometry_weight(n, n, 0.0F, 10.0F, 0.5F), 1.0F);
    EXPECT_NEAR(geometry_weight(n, vec3(1, 0, 0), 0.0F, 10.0F, 0.5F), std::pow(2.0, -10), 1e-6);
    EXPECT_NEAR(geometry_weight(n, n, 3.0F, 10.0F, 0.5F), 0.5, 1e-6);
    EXPECT_NEAR(geometry_weight(n, n, -3.0F, 10.0F, 1.0F), 0.25, 1e-6);
    EXPECT_NEAR(geometry_weight(n, vec3(0.6F, 0, 0.8F), 0.0F, 2.0F, 0.5F), 0.81, 1e-6);
    EXPECT_EQ(geometry_weight(n, -n, 0.0F, 10.0F, 0.5F), 0.0F);
    EXPECT_NEAR(geometry_weight(n, vec3(0), 0.0F, 10.0F, 0.5F), std::pow(2.0, -10), 1e-6);
    EXPECT_EQ(geometry_weight(n, n, infinity, 10.0F, 0.5F), 0.0F);
    EXPECT_EQ(geometry_weight(n, n, NAN, 10.0F, 0.5F), 0.0F);
    EXPECT_EQ(geometry_weight(n, vec3(NAN), 0.0F, 10.0F, 0.5F), 0.0F);
}

TEST_F(EdgeAware, GeometryBlur) {
    Surface s;
    EXPECT_EQ(blur(s, ivec2(3, 2)), 0.25F);
    s.occlusion = [](ivec2 p) { return p.x == 3 ? 1.0F : 0.0F; };
    EXPECT_NEAR(blur(s, ivec2(3, 2)), 0.2, 1e-6);        // a box: no weight by distance
    EXPECT_EQ(blur(s, ivec2(3, 2), ivec2(0, 1)), 1.0F);  // along the other axis
    EXPECT_EQ(blur(s, ivec2(3, 2), ivec2(1, 0), 0), 1.0F);
    EXPECT_NEAR(blur(s, ivec2(0, 2), ivec2(1, 0), 3), 0.25, 1e-6);  // neighbours outside are left out
    s.normal = [](ivec2 p) { return p.x == 3 ? vec3(1, 0, 0) : vec3(0, 0, 1); };
    EXPECT_NEAR(blur(s, ivec2(2, 2)), std::pow(2.0, -10) / (4 + std::pow(2.0, -10)), 1e-6);
    s.normal = [](ivec2) { return vec3(0, 0, 1); };
    s.depth = [](ivec2 p) { return p.x == 3 ? 8.0F : 5.0F; };
    EXPECT_NEAR(blur(s, ivec2(2, 2)), 0.5 / 4.5, 1e-6);
    s.depth = [](ivec2 p) { return p.x == 3 ? infinity : 5.0F; };
    EXPECT_EQ(blur(s, ivec2(2, 2)), 0.0F);
    EXPECT_EQ(blur(s, ivec2(3, 2)), 1.0F);
    s.depth = [](ivec2) { return 5.0F; };
    s.occlusion = [](ivec2 p) { return p.x == 3 ? NAN : 0.25F; };
    EXPECT_EQ(blur(s, ivec2(2, 2)), 0.25F);
    EXPECT_EQ(blur(s, ivec2(3, 2)), 0.25F);
}

}  // namespace gloam::edge_aware_test
