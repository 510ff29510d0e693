// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "numeric/random.hpp"
#include "support/lab.hpp"

namespace gloam::geometry_test {

using check::Function;

class Geometry : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
};

TEST_F(Geometry, PositionsProjectBackOntoTheirPixels) {
    const std::string file = "gloam/geometry/position.glsl";
    const Function<glm::vec2(glm::ivec2, glm::ivec2)> ndc_of(lab, file, "gloam_ndc_from_pixel");
    const Function<glm::vec3(glm::vec2, float, glm::vec2)> position(lab, file,
                                                                    "gloam_view_position_perspective");
    const Function<glm::vec2(glm::vec3, glm::vec2)> project(lab, file, "gloam_ndc_perspective");
    const glm::ivec2 size(33, 7);
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
}

TEST_F(Geometry, ProjectedRadiusIsThatOfAProjectedPoint) {
    const Function<glm::vec2(float, float, glm::vec2)> uv(lab, "gloam/geometry/projected_radius.glsl",
                                                          "gloam_projected_radius_uv");
    const Function<glm::vec2(glm::vec3, glm::vec2)> project(lab, "gloam/geometry/position.glsl",
                                                            "gloam_ndc_perspective");
    const glm::vec2 scale(0.8F, -1.3F);
    const glm::vec2 there = project(glm::vec3(0.6F, 0.6F, -3.0F), scale) * 0.5F;
    const glm::vec2 radius = uv(0.6F, 3.0F, scale);
    EXPECT_NEAR(radius.x, std::abs(there.x), 1e-6);
    EXPECT_NEAR(radius.y, std::abs(there.y), 1e-6);
}

TEST_F(Geometry, PixelCentresAreTheirOwnCentres) {
    const Function<glm::vec2(glm::vec2, glm::ivec2)> center(lab, "gloam/geometry/pixel_center.glsl",
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
    const Function<glm::vec3(glm::vec3, glm::vec3)> previous(lab, "gloam/geometry/camera_centered.glsl",
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

// Changes that do not span a plane have no curvature, and lengths are those of their vectors in any
// direction.
TEST_F(Geometry, OfVectorsInAnyDirection) {
    const Function<glm::vec2(glm::vec3, glm::vec3, glm::vec3, glm::vec3)> curvatures(
        lab, "gloam/geometry/curvature.glsl", "gloam_principal_curvatures");
    const Function<float(glm::vec3)> length(lab, "gloam/geometry/length.glsl", "gloam_length");
    const glm::vec3 turn(0.01F, 0.002F, 0.0F);
    std::vector<std::tuple<glm::vec3, glm::vec3, glm::vec3, glm::vec3>> parallel;
    std::vector<std::tuple<glm::vec3>> vectors;
    for (int i = 0; i < 500; ++i) {
        const float a = 0.7F * static_cast<float>(i);
        const glm::vec3 direction =
            glm::normalize(glm::vec3(std::cos(a), std::sin(1.3F * a), std::sin(2.1F * a)));
        vectors.emplace_back(3.0F * direction);
        for (const float factor : {1.0F, -1.0F, 0.5F, 3.0F, 0.0F}) {
            parallel.emplace_back(0.01F * direction, factor * 0.01F * direction, turn, -turn);
            parallel.emplace_back(factor * 0.01F * direction, 0.01F * direction, turn, turn);
        }
    }
    EXPECT_THAT(curvatures(parallel), testing::Each(glm::vec2(0)));
    EXPECT_THAT(length(vectors), testing::Each(testing::FloatNear(3.0F, 2e-6F)));
}

// Whatever the bits of a NaN are.
TEST_F(Geometry, NoNaNIsFinite) {
    const Function<bool(float)> finite(lab, "gloam/geometry/finite.glsl", "gloam_is_finite");
    const Function<bool(glm::vec2)> finite2(lab, "gloam/geometry/finite.glsl", "gloam_is_finite2");
    const Function<bool(glm::vec3)> finite3(lab, "gloam/geometry/finite.glsl", "gloam_is_finite3");
    const Function<bool(glm::vec4)> finite4(lab, "gloam/geometry/finite.glsl", "gloam_is_finite4");
    for (const std::uint32_t bits : {0x7F800000U, 0x7FC00001U, 0xFFFFFFFFU, 0x7FD5AAAAU}) {
        const float none = std::bit_cast<float>(bits);
        EXPECT_FALSE(finite(none) || finite2(glm::vec2(0, none)) || finite3(glm::vec3(0, none, 0)) ||
                     finite4(glm::vec4(none, 0, 0, 0)))
            << bits;
    }
}

class Borders : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/borders.glsl";
    const Function<glm::ivec2(glm::ivec2, float)> border{lab, file, "gloam_guard_band_border"};
    const Function<glm::vec2(glm::ivec2, float)> rendered_guard{lab, file, "gloam_guard_band_guard"};
    const Function<float(float, float)> tangent{lab, file, "gloam_guard_band_tan_half_fov"};
};

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
