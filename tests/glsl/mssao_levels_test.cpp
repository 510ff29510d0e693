// SPDX-License-Identifier: MIT
// What MSSAO's finest resolution makes of the coarser ones, in closed form.
#include <gtest/gtest.h>

#include "gathers.hpp"
#include "support/lab.hpp"

namespace gloam {
namespace {

using glm::ivec2;
using glm::vec3;
using glm::vec4;
using test::Camera;
using test::Gather;
using test::Method;
using test::Samples;

constexpr int side = 64;  // of the image, pixels
constexpr int half = 32;  // of level 1
constexpr float floor_depth = 5.0F;
constexpr float near_depth = 0.5F;

// (largest occlusion, its mean, levels in it) at a place of level 1, linear in it.
vec3 found_at(double x, double y) {
    return {0.2 + 0.01 * x, 0.1 + 0.005 * y, 1.5 + 0.01 * x};
}

// Level 1 of a bare floor: positions, normals and results in the quarters that mssao.glsl names.
vec4 level_one(ivec2 at) {
    if (at.x < half && at.y < half) return {0, 0, -floor_depth, 0};
    if (at.y < half) return {0, 0, 1, 0};
    return at.x < half ? vec4(found_at(at.x, at.y - half), 0) : vec4(0);
}

class MssaoLevels : public testing::Test {
  protected:
    test::MethodFunctions functions;
    check::Lab lab = functions.lab();
    check::Kernel<Gather> gather{lab, functions.file("mssao"), effect::method_function};

    // At a pixel of a bare floor, over three levels.
    [[nodiscard]] double occlusion_at(ivec2 pixel, float depth, vec4 (*prepared)(ivec2)) const {
        check::ImageSet images = test::view_of(ivec2(side), [depth](ivec2) { return depth; });
        images.insert_or_assign("gloam_fetch_prepared", check::make_image<vec4>(ivec2(side), prepared));
        const Camera camera{glm::vec2(0.5F, -0.5F), ivec2(side), true};
        const Samples samples{.radius = 1.0F, .bias = 0.01F, .angle = 0.0F, .first = 0, .count = 8};
        const glm::dvec2 ndc = 2.0 * (glm::dvec2(pixel) + 0.5) / double{side} - 1.0;
        const vec3 position(2.0 * ndc.x, -2.0 * ndc.y, -depth);
        const glm::vec2 sum =
            gather.with_images(images, {position, vec3(0, 0, 1), camera, samples, Method{.steps = 3}});
        EXPECT_EQ(sum.y, 8.0F);
        return double{sum.x} / double{sum.y};
    }
};

// The floor's own level is open.
double combined(const glm::dvec3& known) {
    const double mean = known.z * known.y / (1.0 + known.z);
    return 1.0 - (1.0 - known.x) * (1.0 - mean);
}

TEST_F(MssaoLevels, CoarserOnesAreInterpolatedAndTheirMeanCountsByTheirNumber) {
    for (const ivec2 pixel : {ivec2(20, 12), ivec2(21, 12), ivec2(33, 40), ivec2(8, 51)}) {
        const glm::dvec2 at = (glm::dvec2(pixel) + 0.5) / 2.0 - 0.5;
        EXPECT_NEAR(occlusion_at(pixel, floor_depth, level_one), combined(found_at(at.x, at.y)), 2e-5)
            << pixel.x << ", " << pixel.y;
    }
}

// Every other texel of level 1 is background, whatever else stands there.
vec4 with_holes(ivec2 at) {
    const bool hole = (at.x + at.y) % 2 == 1;
    if (at.x < half && at.y < half) return hole ? vec4(0) : vec4(0, 0, -near_depth, 0);
    if (at.y < half) return {0, 0, 1, 0};
    return hole ? vec4(1, 1, 2, 0) : vec4(0.3F, 0.2F, 1.5F, 0);
}

TEST_F(MssaoLevels, TexelsOfTheBackgroundTellNothing) {
    EXPECT_NEAR(occlusion_at(ivec2(20, 12), near_depth, with_holes), combined({0.3, 0.2, 1.5}), 2e-5);
}

}  // namespace
}  // namespace gloam
