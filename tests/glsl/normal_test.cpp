// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/lab.hpp"

namespace gloam {
namespace normal_test {

using check::ImageSet;
using check::Kernel;

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
    const Kernel<glm::vec3(glm::ivec2, glm::ivec2, glm::vec2)> from_depth{
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

// The ends of what counts as two directions: an angle of 1e-5, a cross product of length 2.
TEST_F(Normal, OfDirectionsAtTheEndsOfTheirRange) {
    const Kernel<glm::vec3(glm::vec3, glm::vec3, glm::vec3)> facing(lab, "gloam/geometry/normal.glsl",
                                                                    "gloam_facing_normal");
    const glm::vec3 y(0, 1, 0);
    const glm::vec3 z(0, 0, 1);
    const glm::vec3 x(1, 0, 0);
    EXPECT_EQ(facing(2.0F * y, z, x), x);
    EXPECT_EQ(facing(2.0F * y, z, -x), -x);
    EXPECT_EQ(facing(2.0001F * y, z, x), z);
    EXPECT_EQ(facing(y, y + 1.001e-5F * z, x), x);
    EXPECT_EQ(facing(y, y + 0.999e-5F * z, x), z);
}

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
    using Neighbors = Kernel<glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, glm::vec3)>;
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

TEST_F(Normal, SafeNormalizeKeepsEveryDirection) {
    const Kernel<glm::vec3(glm::vec3, glm::vec3)> normalize(lab, "gloam/geometry/safe_normalize.glsl",
                                                            "gloam_safe_normalize");
    const glm::vec3 fallback(0, 1, 0);
    const glm::vec3 expected(0.6F, 0.0F, -0.8F);
    // normalize() gives NaN or zero where the square under- or overflows.
    for (const float length : {1e-37F, 1e-22F, 1.0F, 1e22F, 3e38F}) {
        EXPECT_LT(glm::distance(normalize(expected * length, fallback), expected), 1e-6F) << length;
    }
    for (const glm::vec3 none : {glm::vec3(0.0F), glm::vec3(NAN, 1, 1), glm::vec3(0, infinity, 0)}) {
        EXPECT_EQ(normalize(none, fallback), fallback);
    }
}

}  // namespace normal_test
}  // namespace gloam
