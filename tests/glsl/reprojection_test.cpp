// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/lab.hpp"

namespace gloam::reprojection_test {

using check::Function;
using check::ImageSet;
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
    const Function<bool(glm::vec4, Out<glm::vec2>)> uv_of{lab, file, "gloam_uv_from_clip"};
    const Function<bool(glm::vec4, glm::mat4, Out<glm::vec2>)> reproject{lab, file, "gloam_reproject_clip"};
    const Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)> previous_static{
        lab, file, "gloam_previous_clip_static"};
    const Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)>
        previous_moving{lab, file, "gloam_previous_clip_moving"};
    const Function<float(glm::vec3, glm::mat4)> previous_depth{lab, file, "gloam_previous_depth"};

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

// x / w alone would put this point, behind the previous camera, in the middle of the image.
TEST_F(Reprojection, NothingIsFoundBehindTheCamera) {
    const auto [inside, uv] = uv_of(clip(glm::dvec3(0, 0, -7), glm::dvec3(0, 0, -6)));
    EXPECT_FALSE(inside);
    EXPECT_EQ(uv, glm::vec2(0.0F));
}

constexpr float infinity = std::numeric_limits<float>::infinity();
const glm::vec2 scale(1.2F, -1.6F);

// A plane through `through` with the given normal, seen from the eye.
struct Plane {
    glm::dvec3 normal;
    glm::dvec3 through{0, 0, -4};

    double depth(glm::ivec2 pixel, glm::ivec2 size) const {
        const glm::dvec2 ndc = (2.0 * glm::dvec2(pixel) + 1.0 - glm::dvec2(size)) / glm::dvec2(size);
        const glm::dvec3 ray(ndc.x / scale.x, ndc.y / scale.y, -1.0);
        return glm::dot(through, normal) / glm::dot(ray, normal);
    }
};

class Normal : public testing::Test {
  protected:
    check::Lab lab = test::make_lab();
    const Function<glm::vec3(glm::ivec2, glm::ivec2, glm::vec2)> from_depth{
        lab, "gloam/geometry/normal_from_depth.glsl", "gloam_normal_from_depth"};

    template <class Depth>
    static ImageSet image(glm::ivec2 size, Depth depth) {
        return {{"gloam_fetch_depth", check::make_image<float>(size, depth)}};
    }

    // The normals of all pixels of a depth image, row by row.
    std::vector<glm::vec3> normals(glm::ivec2 size, const ImageSet& images) const {
        std::vector<std::tuple<glm::ivec2, glm::ivec2, glm::vec2>> inputs;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) inputs.emplace_back(glm::ivec2(x, y), size, scale);
        }
        return from_depth(inputs, images);
    }
};

TEST_F(Normal, OfAPlaneIsItsNormalAtEveryPixelAndSize) {
    for (const glm::dvec3 direction :
         {glm::dvec3(0, 0, 1), glm::dvec3(0.5, 0.3, 1), glm::dvec3(-0.2, 0.8, 0.7)}) {
        const Plane plane{.normal = glm::normalize(direction)};
        for (const glm::ivec2 size :
             {glm::ivec2(2, 2), glm::ivec2(3, 3), glm::ivec2(9, 5), glm::ivec2(31, 17)}) {
            const ImageSet images = image(size, [&](glm::ivec2 pixel) { return plane.depth(pixel, size); });
            for (const glm::vec3 normal : normals(size, images)) {
                EXPECT_LT(glm::distance(normal, glm::vec3(plane.normal)), 1e-5F) << size.x << " x " << size.y;
            }
        }
    }
}

TEST_F(Normal, FacesTheViewerWhereNothingElseIsKnown) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(1, 5), glm::ivec2(5, 1)}) {
        const ImageSet images = image(size, [](glm::ivec2 pixel) { return 2.0 + 0.1 * pixel.x; });
        for (const glm::vec3 normal : normals(size, images)) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
    }
}

TEST_F(Normal, OfBackgroundIsZero) {
    const glm::ivec2 size(5, 3);
    for (const float background : {infinity, 0.0F, -1.0F, NAN}) {
        const ImageSet images = image(size, [background](glm::ivec2) { return background; });
        for (const glm::vec3 normal : normals(size, images)) EXPECT_EQ(normal, glm::vec3(0.0F));
    }
}

// Beside background and at a step of depth, each side keeps the normal of its own surface.
TEST_F(Normal, DoesNotReachAcrossSilhouettes) {
    const glm::ivec2 size(9, 6);
    const Plane near{.normal = glm::normalize(glm::dvec3(0.3, 0.2, 1)), .through = {0, 0, -2}};
    const Plane far{.normal = glm::normalize(glm::dvec3(-0.4, 0.1, 1)), .through = {0, 0, -9}};
    const ImageSet images = image(size, [&](glm::ivec2 pixel) {
        if (pixel.x == 8) return static_cast<double>(infinity);
        return (pixel.x < 4 ? near : far).depth(pixel, size);
    });
    const std::vector<glm::vec3> all = normals(size, images);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto x = static_cast<int>(i) % size.x;
        if (x == 8) continue;
        EXPECT_LT(glm::distance(all[i], glm::vec3((x < 4 ? near : far).normal)), 1e-5F) << "column " << x;
    }
}

TEST_F(Normal, TurnsToTheEyeInPerspectiveAndAgainstTheViewInOrthographic) {
    using Neighbors = Function<glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, glm::vec3)>;
    const Neighbors perspective(lab, "gloam/geometry/normal.glsl", "gloam_normal_from_neighbors");
    const Neighbors orthographic(lab, "gloam/geometry/normal.glsl",
                                 "gloam_normal_from_neighbors_orthographic");
    // A wall to the right that leans away a little: its normal has z < 0, yet the eye sees that side.
    const glm::vec3 normal = glm::normalize(glm::vec3(-1.0F, 0.0F, -0.1F));
    const glm::vec3 center(3.0F, 0.0F, -3.0F);
    const glm::vec3 along = glm::normalize(glm::vec3(0.1F, 0.0F, -1.0F)) * 0.01F;
    const glm::vec3 up(0.0F, 0.01F, 0.0F);
    const auto of = [&](const Neighbors& kernel) {
        return kernel(center, center + along, center - along, center + up, center - up);
    };
    EXPECT_LT(glm::distance(of(perspective), normal), 1e-4F);
    EXPECT_LT(glm::distance(of(orthographic), -normal), 1e-4F);
}

}  // namespace gloam::reprojection_test
