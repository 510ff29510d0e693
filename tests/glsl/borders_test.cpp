// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/lab.hpp"

namespace gloam {
namespace borders_test {

using check::Kernel;

class Borders : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/borders.glsl";
    const Kernel<glm::ivec2(glm::ivec2, float)> border{lab, file, "gloam_guard_band_border"};
    const Kernel<glm::ivec2(glm::ivec2, float)> size_with_band{lab, file, "gloam_guard_band_size"};
    const Kernel<glm::vec2(glm::ivec2, float)> rendered_guard{lab, file, "gloam_guard_band_guard"};
    const Kernel<float(float, float)> tangent{lab, file, "gloam_guard_band_tan_half_fov"};
    const Kernel<glm::vec2(glm::vec2, glm::vec2)> inner{lab, file, "gloam_guard_band_inner_uv"};
    const Kernel<glm::vec2(glm::vec2, glm::vec2)> outer{lab, file, "gloam_guard_band_outer_uv"};
};

TEST_F(Borders, ClampToEdge) {
    const Kernel<glm::ivec2(glm::ivec2, glm::ivec2)> clamp(lab, file, "gloam_clamp_to_edge");
    EXPECT_EQ(clamp(glm::ivec2(-3, 7), glm::ivec2(4, 4)), glm::ivec2(0, 3));
    EXPECT_EQ(clamp(glm::ivec2(2, 1), glm::ivec2(4, 4)), glm::ivec2(2, 1));
    EXPECT_EQ(clamp(glm::ivec2(2, -1), glm::ivec2(1, 1)), glm::ivec2(0, 0));
}

TEST_F(Borders, GuardBandOfWholePixelsGivesTheSizeOfTheFormula) {
    EXPECT_EQ(size_with_band(glm::ivec2(640, 360), 0.05F), glm::ivec2(704, 396));
    EXPECT_EQ(size_with_band(glm::ivec2(640, 360), 0.1F), glm::ivec2(768, 432));  // cost 1.44
    EXPECT_EQ(size_with_band(glm::ivec2(640, 360), 0.0F), glm::ivec2(640, 360));
    EXPECT_EQ(size_with_band(glm::ivec2(640, 360), NAN), glm::ivec2(640, 360));
    EXPECT_FLOAT_EQ(tangent(0.5F, 0.1F), 0.6F);
}

// Whatever the rounding, a pixel of the crop is the same pixel of the image with the band: same place, same
// footprint.
TEST_F(Borders, CropIsConsistentAtOddSizes) {
    for (const glm::ivec2 size : {glm::ivec2(33, 17), glm::ivec2(1, 1), glm::ivec2(101, 7)}) {
        const glm::ivec2 band = border(size, 0.07F);
        const glm::vec2 guard = rendered_guard(size, 0.07F);
        const glm::ivec2 with_band = size_with_band(size, 0.07F);
        EXPECT_EQ(with_band, size + 2 * band);
        for (const glm::ivec2 pixel : {glm::ivec2(0), size / 2, size - 1}) {
            const glm::vec2 crop_uv = (glm::vec2(pixel) + 0.5F) / glm::vec2(size);
            const glm::vec2 band_uv = (glm::vec2(pixel + band) + 0.5F) / glm::vec2(with_band);
            EXPECT_LT(glm::distance(inner(band_uv, guard), crop_uv), 1e-6F);
            EXPECT_LT(glm::distance(outer(crop_uv, guard), band_uv), 1e-6F);
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

TEST_F(Borders, InnerAndOuterUndoEachOther) {
    const glm::vec2 guard(0.05F, 0.0703125F);
    for (const glm::vec2 uv : {glm::vec2(0.0F), glm::vec2(0.3F, 0.9F), glm::vec2(1.0F)}) {
        EXPECT_LT(glm::distance(outer(inner(uv, guard), guard), uv), 1e-6F);
    }
    EXPECT_LT(glm::distance(inner(glm::vec2(0.5F), guard), glm::vec2(0.5F)), 1e-6F);
}

}  // namespace borders_test
}  // namespace gloam
