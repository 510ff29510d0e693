// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::geometry_test {

using check::Kernel;

constexpr float infinity = std::numeric_limits<float>::infinity();

class Geometry : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();

    using DepthKernel = Kernel<float(float, float, float)>;
    DepthKernel depth(const std::string& kind) const {
        return {lab, "gloam/geometry/linear_depth.glsl", "gloam_linear_depth_" + kind};
    }
};

// d at b = 0, 1/2 and 1 of a projection's elements.
void expect_depths(const Kernel<float(float, float, float)>& depth, double p22, double p32, double d0,
                   double half, double d1) {
    const auto e22 = static_cast<float>(p22);
    const auto e32 = static_cast<float>(p32);
    EXPECT_NEAR(depth(0.0F, e22, e32), d0, 1e-5 * d0);
    EXPECT_NEAR(depth(0.5F, e22, e32), half, 1e-5 * half);
    if (std::isinf(d1)) {
        EXPECT_EQ(depth(1.0F, e22, e32), infinity);
    } else {
        EXPECT_NEAR(depth(1.0F, e22, e32), d1, 3e-5 * d1);
    }
}

constexpr double n = 1.0;
constexpr double f = 101.0;
const double half_depth = 2 * n * f / (n + f);  // where a perspective depth buffer reads 1/2

TEST_F(Geometry, PerspectiveDepthsOfTheRangeOfVulkan) {
    const auto d = depth("perspective_vk");
    expect_depths(d, f / (n - f), f * n / (n - f), n, half_depth, f);
    expect_depths(d, n / (f - n), f * n / (f - n), f, half_depth, n);  // reversed
    expect_depths(d, -1, -n, n, 2 * n, infinity);                      // infinite far plane
    EXPECT_EQ(d(0.0F, 0.0F, 1.0F), infinity);  // reversed with infinite far plane: n / b
    EXPECT_EQ(d(0.5F, 0.0F, 1.0F), 2.0F);
    EXPECT_EQ(d(NAN, 0.0F, 1.0F), infinity);
    EXPECT_EQ(d(2.0F, -1.0F, -1.0F), infinity);  // behind the eye
}

TEST_F(Geometry, PerspectiveDepthsOfTheRangeOfOpenGl) {
    const auto d = depth("perspective_gl");
    expect_depths(d, -(f + n) / (f - n), -2 * f * n / (f - n), n, half_depth, f);
    expect_depths(d, (f + n) / (f - n), 2 * f * n / (f - n), f, half_depth, n);  // reversed
    expect_depths(d, -1, -2 * n, n, 2 * n, infinity);                            // infinite far plane
    // Reversed with infinite far plane, d = n / b: b keeps its digits only if the two ones cancel first.
    EXPECT_FLOAT_EQ(d(1e-9F, 1.0F, 2.0F), 1e9F);
}

TEST_F(Geometry, OrthographicDepths) {
    const double middle = (n + f) / 2;
    expect_depths(depth("orthographic_vk"), 1 / (n - f), n / (n - f), n, middle, f);
    expect_depths(depth("orthographic_vk"), 1 / (f - n), f / (f - n), f, middle, n);
    expect_depths(depth("orthographic_gl"), -2 / (f - n), -(f + n) / (f - n), n, middle, f);
    expect_depths(depth("orthographic_gl"), 2 / (f - n), (f + n) / (f - n), f, middle, n);
    EXPECT_EQ(depth("orthographic_vk")(0.5F, 0.0F, 1.0F), infinity);
}

TEST_F(Geometry, BackgroundIsEveryDepthThatIsNotPositiveAndFinite) {
    const Kernel<bool(float)> background(lab, "gloam/geometry/background.glsl", "gloam_is_background");
    for (const float depth : {0.0F, -0.0F, -1.0F, infinity, -infinity, NAN, 1e-40F}) {
        EXPECT_TRUE(background(depth)) << depth;
    }
    for (const float depth : {1e-30F, 1.0F, 1e30F, std::numeric_limits<float>::max()}) {
        EXPECT_FALSE(background(depth)) << depth;
    }
}

TEST_F(Geometry, PositionsProjectBackOntoTheirPixels) {
    const std::string file = "gloam/geometry/position.glsl";
    const Kernel<glm::vec2(glm::ivec2, glm::ivec2)> ndc_of(lab, file, "gloam_ndc_from_pixel");
    const Kernel<glm::vec3(glm::vec2, float, glm::vec2)> position(lab, file,
                                                                  "gloam_view_position_perspective");
    const Kernel<glm::vec2(glm::vec3, glm::vec2)> project(lab, file, "gloam_ndc_perspective");
    const glm::ivec2 size(33, 7);
    EXPECT_EQ(ndc_of(glm::ivec2(16, 3), size), glm::vec2(0.0F));  // the centre of the middle pixel
    for (const glm::vec2 scale : {glm::vec2(1.5F, -2.0F), glm::vec2(1.5F, 2.0F)}) {
        for (const glm::ivec2 pixel : {glm::ivec2(0, 0), glm::ivec2(32, 6), glm::ivec2(5, 1)}) {
            const glm::vec2 ndc = ndc_of(pixel, size);
            EXPECT_NEAR(ndc.x, (2 * pixel.x + 1) / 33.0 - 1, 1e-7);
            const glm::vec3 p = position(ndc, 4.0F, scale);
            EXPECT_EQ(p.z, -4.0F);
            EXPECT_GT(p.y * ndc.y * scale.y, 0.0F);  // up is where the projection says
            EXPECT_LT(glm::distance(project(p, scale), ndc), 1e-6F);
        }
    }
    EXPECT_EQ(project(glm::vec3(0, 0, 1), glm::vec2(1.0F)), glm::vec2(2.0F));  // behind the eye: outside
}

TEST_F(Geometry, ProjectedRadiusIsThatOfAProjectedPoint) {
    const Kernel<glm::vec2(float, float, glm::vec2)> uv(lab, "gloam/geometry/projected_radius.glsl",
                                                        "gloam_projected_radius_uv");
    // 90 degrees, a length of 1 at depth 2: a quarter of the image. Aspect ratio 2 halves P00.
    EXPECT_EQ(uv(1.0F, 2.0F, glm::vec2(0.5F, -1.0F)), glm::vec2(0.125F, 0.25F));
    const Kernel<glm::vec2(glm::vec3, glm::vec2)> project(lab, "gloam/geometry/position.glsl",
                                                          "gloam_ndc_perspective");
    const glm::vec2 scale(0.8F, -1.3F);
    const glm::vec2 there = project(glm::vec3(0.6F, 0.6F, -3.0F), scale) * 0.5F;
    const glm::vec2 radius = uv(0.6F, 3.0F, scale);
    EXPECT_NEAR(radius.x, std::abs(there.x), 1e-6);
    EXPECT_NEAR(radius.y, std::abs(there.y), 1e-6);
    EXPECT_EQ(uv(1.0F, infinity, scale), glm::vec2(0.0F));
}

TEST_F(Geometry, PixelCentreTakesTheFloor) {
    const Kernel<glm::vec2(glm::vec2, glm::ivec2)> center(lab, "gloam/geometry/pixel_center.glsl",
                                                          "gloam_pixel_center");
    const Kernel<glm::ivec2(glm::vec2, glm::ivec2)> pixel(lab, "gloam/geometry/pixel_center.glsl",
                                                          "gloam_nearest_pixel");
    // As printed, with brackets that take nothing off, it would be 0.501025.
    EXPECT_FLOAT_EQ(center(glm::vec2(0.5004F), glm::ivec2(800)).x, 0.500625F);
    EXPECT_EQ(pixel(glm::vec2(1.0F), glm::ivec2(800, 3)), glm::ivec2(799, 2));
    EXPECT_EQ(pixel(glm::vec2(-0.1F, NAN), glm::ivec2(800, 3)), glm::ivec2(0, 0));
    EXPECT_EQ(pixel(glm::vec2(0.7F), glm::ivec2(1)), glm::ivec2(0));
}

TEST_F(Geometry, TheImageHoldsItsBorders) {
    const Kernel<bool(glm::vec2)> inside(lab, "gloam/geometry/pixel_center.glsl", "gloam_inside_unit");
    for (const float in : {0.0F, 0.5F, 1.0F}) {
        EXPECT_TRUE(inside(glm::vec2(in, 0.5F)) && inside(glm::vec2(0.5F, in)));
    }
    for (const float out : {-1e-6F, 1.000001F, NAN, infinity, -infinity}) {
        EXPECT_FALSE(inside(glm::vec2(out, 0.5F)) || inside(glm::vec2(0.5F, out))) << out;
    }
}

TEST_F(Geometry, PixelCentresAreTheirOwnCentres) {
    const Kernel<glm::vec2(glm::vec2, glm::ivec2)> center(lab, "gloam/geometry/pixel_center.glsl",
                                                          "gloam_pixel_center");
    numeric::Random random(3);
    std::vector<std::tuple<glm::vec2, glm::ivec2>> inputs;
    for (int i = 0; i < 4096; ++i) {
        const glm::ivec2 size(1 + random.below(5000), 1 + random.below(5000));
        inputs.emplace_back(glm::vec2(random.unit(), random.unit()), size);
    }
    const std::vector<glm::vec2> once = center(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) std::get<0>(inputs[i]) = once[i];
    EXPECT_EQ(center(inputs), once);
}

TEST_F(Geometry, CameraCentredPositionsDoNotCareWhereTheWorldIs) {
    const Kernel<glm::vec3(glm::vec3, glm::vec3)> previous(lab, "gloam/geometry/camera_centered.glsl",
                                                           "gloam_camera_centered_previous");
    const glm::dvec3 x(3.25, -1.5, 7.125);
    const glm::dvec3 eye(1.0, 0.5, 10.0);
    const glm::dvec3 previous_eye(1.0 + 0x1p-10, 0.5, 10.0 - 0x1p-9);
    const auto at = [&](const glm::dvec3& shift) {
        return previous(glm::vec3((x + shift) - (eye + shift)),
                        glm::vec3((eye + shift) - (previous_eye + shift)));
    };
    const glm::vec3 here = at(glm::dvec3(0));
    EXPECT_EQ(at(glm::dvec3(1e6, 0, 0)), here);
    EXPECT_EQ(glm::dvec3(here), x - previous_eye);  // exactly representable
    // World coordinates in float lose the movement of the eye altogether.
    const float naive = static_cast<float>(x.x + 1e6) - static_cast<float>(previous_eye.x + 1e6);
    EXPECT_GT(std::abs(static_cast<double>(naive) - (x.x - previous_eye.x)), 9e-4);
}

class Borders : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/borders.glsl";
    const Kernel<glm::ivec2(glm::ivec2, float)> border{lab, file, "gloam_guard_band_border"};
    const Kernel<glm::vec2(glm::ivec2, float)> rendered_guard{lab, file, "gloam_guard_band_guard"};
    const Kernel<float(float, float)> tangent{lab, file, "gloam_guard_band_tan_half_fov"};
};

TEST_F(Borders, ClampToEdge) {
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2)> clamp(lab, file, "gloam_clamp_to_edge");
    EXPECT_EQ(clamp(glm::ivec2(-3, 7), glm::ivec2(4, 4)), glm::ivec2(0, 3));
    EXPECT_EQ(clamp(glm::ivec2(2, 1), glm::ivec2(4, 4)), glm::ivec2(2, 1));
    EXPECT_EQ(clamp(glm::ivec2(2, -1), glm::ivec2(1, 1)), glm::ivec2(0, 0));
}

TEST_F(Borders, GuardBandOfWholePixelsGivesTheSizeOfTheFormula) {
    EXPECT_EQ(border(glm::ivec2(640, 360), 0.05F), glm::ivec2(32, 18));
    EXPECT_EQ(border(glm::ivec2(640, 360), 0.1F), glm::ivec2(64, 36));  // cost 1.44
    EXPECT_EQ(border(glm::ivec2(640, 360), 0.0F), glm::ivec2(0));
    EXPECT_EQ(border(glm::ivec2(640, 360), NAN), glm::ivec2(0));
    EXPECT_FLOAT_EQ(tangent(0.5F, 0.1F), 0.6F);
}

// Whatever the rounding, a pixel of the crop is the same pixel of the image with the band: same place, same
// footprint. inner: texture coordinates in the crop of those in the image with the band.
TEST_F(Borders, CropIsConsistentAtOddSizes) {
    const auto inner = [](glm::vec2 uv, glm::vec2 guard) { return uv + guard * (2.0F * uv - 1.0F); };
    for (const glm::ivec2 size : {glm::ivec2(33, 17), glm::ivec2(1, 1), glm::ivec2(101, 7)}) {
        const glm::ivec2 band = border(size, 0.07F);
        const glm::vec2 guard = rendered_guard(size, 0.07F);
        const glm::ivec2 with_band = size + 2 * band;
        for (const glm::ivec2 pixel : {glm::ivec2(0), size / 2, size - 1}) {
            const glm::vec2 crop_uv = (glm::vec2(pixel) + 0.5F) / glm::vec2(size);
            const glm::vec2 band_uv = (glm::vec2(pixel + band) + 0.5F) / glm::vec2(with_band);
            EXPECT_LT(glm::distance(inner(band_uv, guard), crop_uv), 1e-6F);
        }
        for (int axis = 0; axis < 2; ++axis) {
            const auto pixel_with_band = tangent(0.5F, guard[axis]) / static_cast<float>(with_band[axis]);
            EXPECT_NEAR(pixel_with_band, 0.5F / static_cast<float>(size[axis]), 1e-7F);
        }
    }
    // With the guard asked for instead, the first pixel of a 33-pixel row would be off by more than a tenth
    // of a pixel.
    const float naive = inner(glm::vec2((2 + 0.5F) / 37, 0.5F), glm::vec2(0.07F)).x;
    EXPECT_GT(std::abs(naive - 0.5F / 33) * 33, 0.1F);
}

}  // namespace gloam::geometry_test
