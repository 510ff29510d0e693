// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/lab.hpp"

namespace gloam {
namespace reprojection_test {

using check::Kernel;
using check::Out;

// 90 degrees, aspect 1, y down, reversed depth range with the far plane at infinity (near 0.1).
glm::dmat4 projection() {
    glm::dmat4 p(0.0);
    p[0][0] = 1.0;
    p[1][1] = -1.0;
    p[2][3] = -1.0;
    p[3][2] = 0.1;
    return p;
}

// The view of an eye that looks along -z of the world.
glm::dmat4 view_from(const glm::dvec3& eye) {
    glm::dmat4 view(1.0);
    view[3] = glm::dvec4(-eye, 1.0);
    return view;
}

glm::dmat4 moved_by(const glm::dvec3& offset) {
    return view_from(-offset);
}

class Reprojection : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const std::string file = "gloam/geometry/reprojection.glsl";
    const Kernel<bool(glm::vec4, Out<glm::vec2>)> uv_of{lab, file, "gloam_uv_from_clip"};
    const Kernel<bool(glm::vec4, glm::mat4, Out<glm::vec2>)> reproject{lab, file, "gloam_reproject_clip"};
    const Kernel<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)> previous_static{
        lab, file, "gloam_previous_clip_static"};
    const Kernel<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)>
        previous_moving{lab, file, "gloam_previous_clip_moving"};
    const Kernel<float(glm::vec3, glm::mat4)> previous_depth{lab, file, "gloam_previous_depth"};

    const glm::dmat4 p = projection();

    // Clip-space point of a world position, not divided.
    glm::vec4 clip(const glm::dvec3& eye, const glm::dvec3& x) const {
        return glm::vec4(p * view_from(eye) * glm::dvec4(x, 1.0));
    }

    // Previous texture coordinates by the chain of matrices, and by the one matrix of the host.
    void expect_uv(const glm::dvec3& eye, const glm::dvec3& previous_eye, const glm::dvec3& x,
                   glm::vec2 uv) const {
        const glm::vec4 now = clip(eye, x);
        const glm::vec4 chain =
            previous_static(now, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                            glm::mat4(view_from(previous_eye)), glm::mat4(p));
        const glm::mat4 matrix(p * view_from(previous_eye) * glm::inverse(view_from(eye)) * glm::inverse(p));
        for (const auto& [inside, got] : {uv_of(chain), reproject(now, matrix)}) {
            EXPECT_TRUE(inside);
            EXPECT_NEAR(got.x, uv.x, 1e-6);
            EXPECT_NEAR(got.y, uv.y, 1e-6);
        }
    }
};

TEST_F(Reprojection, SameCameraGivesTheSamePlace) {
    const glm::dvec3 eye(2, -1, 3);
    for (const glm::dvec3 x : {glm::dvec3(2, -1, -2), glm::dvec3(0, 1, -4), glm::dvec3(5, -3, -3)}) {
        const auto [inside, now] = uv_of(clip(eye, x));
        EXPECT_TRUE(inside);
        expect_uv(eye, eye, x, now);
    }
}

TEST_F(Reprojection, CameraThatWasToTheLeftSawThePointToTheRight) {
    expect_uv(glm::dvec3(0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -5), glm::vec2(0.6F, 0.5F));
    expect_uv(glm::dvec3(0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -5), glm::vec2(0.5F, 0.4F));  // y down
}

TEST_F(Reprojection, DollyForwardExpectsTheDepthOfThePreviousCamera) {
    // The point is 5 ahead now and was 6 ahead; its depth of today would be rejected by any test of a few per
    // cent.
    EXPECT_FLOAT_EQ(previous_depth(glm::vec3(0, 0, -6), glm::mat4(view_from(glm::dvec3(0)))), 6.0F);
    expect_uv(glm::dvec3(0, 0, -1), glm::dvec3(0), glm::dvec3(1.2, 0, -6), glm::vec2(0.6F, 0.5F));
    EXPECT_FLOAT_EQ(previous_depth(glm::vec3(0, 0, 4), glm::mat4(view_from(glm::dvec3(0)))), -4.0F);
    EXPECT_EQ(previous_depth(glm::vec3(NAN), glm::mat4(1.0F)), 0.0F);
}

// The chain printed without frame indices is the identity: it would find the point where it is now.
TEST_F(Reprojection, MovingObjectIsFoundWhereItWas) {
    const glm::dvec3 eye(0.5, 0, 1);
    const glm::dvec3 point(0.25, 0.5, -4);  // of the object
    const glm::dvec3 now_at(1.0, -0.5, 0.25);
    const glm::dvec3 was_at(0.25, -0.25, -0.5);
    const glm::mat4 inverse_model(glm::inverse(moved_by(now_at)));
    const glm::mat4 previous_model(moved_by(was_at));
    const glm::vec4 now = clip(eye, point + now_at);
    const glm::vec4 previous =
        previous_moving(now, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                        inverse_model, previous_model, glm::mat4(view_from(eye)), glm::mat4(p));
    const auto [inside, uv] = uv_of(previous);
    const auto [expected_inside, expected] = uv_of(clip(eye, point + was_at));
    EXPECT_TRUE(inside && expected_inside);
    EXPECT_LT(glm::distance(uv, expected), 1e-6F);
    EXPECT_GT(glm::distance(uv, std::get<1>(uv_of(now))), 0.05F);
    const Kernel<glm::vec3(glm::vec3, glm::mat4, glm::mat4)> previous_world(lab, file,
                                                                            "gloam_previous_world");
    const glm::vec3 world = previous_world(glm::vec3(point + now_at), inverse_model, previous_model);
    EXPECT_LT(glm::distance(world, glm::vec3(point + was_at)), 1e-6F);
}

TEST_F(Reprojection, PointsAtInfinityMoveWithTheDirectionOnly) {
    // Depth 0 of the reversed range is at infinity: a step of the camera does not change where it is seen.
    const glm::dvec3 eye(3, 2, 1);
    const glm::vec4 sky(0.25F, -0.5F, 0.0F, 1.0F);
    const glm::vec4 previous =
        previous_static(sky, glm::mat4(glm::inverse(p)), glm::mat4(glm::inverse(view_from(eye))),
                        glm::mat4(view_from(glm::dvec3(-5, 0, 2))), glm::mat4(p));
    const auto [inside, uv] = uv_of(previous);
    EXPECT_TRUE(inside);
    EXPECT_LT(glm::distance(uv, glm::vec2(0.625F, 0.25F)), 1e-6F);
}

TEST_F(Reprojection, NothingIsFoundBehindTheCameraOrOutside) {
    const auto rejected = [this](glm::vec4 point) {
        const auto [inside, uv] = uv_of(point);
        return !inside && uv == glm::vec2(0.0F);
    };
    EXPECT_TRUE(rejected(glm::vec4(0, 0, 0, -1)));
    EXPECT_TRUE(rejected(glm::vec4(0, 0, 0, 0)));
    EXPECT_TRUE(rejected(glm::vec4(1.0001F, 0, 0, 1)));
    EXPECT_TRUE(rejected(glm::vec4(-1.0001F, 0, 0, 1)));
    EXPECT_TRUE(rejected(glm::vec4(0, 1.0001F, 0, 1)));
    EXPECT_TRUE(rejected(glm::vec4(0, -1.0001F, 0, 1)));
    EXPECT_TRUE(rejected(glm::vec4(NAN, 0, 0, 1)));
    EXPECT_TRUE(rejected(glm::vec4(0, 0, 0, NAN)));
    EXPECT_FALSE(rejected(glm::vec4(-1, 1, 0, 1)));  // the corner is inside
    // x / w alone would put this point, behind the previous camera, in the middle of the image.
    EXPECT_TRUE(rejected(clip(glm::dvec3(0, 0, -7), glm::dvec3(0, 0, -6))));
}

}  // namespace reprojection_test
}  // namespace gloam
