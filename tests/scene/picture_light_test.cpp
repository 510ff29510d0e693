// SPDX-License-Identifier: MIT
// The light of pictures at several samples of a pixel: which pixel a sample shows, and the mean of the
// samples.
#include "scene/picture_light.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace gloam::test::picture_light_test {

using scene::GBuffer;
using scene::PictureLight;

constexpr float background = std::numeric_limits<float>::infinity();

// A view of walls that face the eye, with these depths.
GBuffer walls(gpu::Extent extent, const std::vector<float>& depth) {
    GBuffer view{.extent = extent, .depth = depth, .camera = scene::make_frame({}, 1.0)};
    view.normal.assign(depth.size(), glm::vec3(0, 0, 1));
    return view;
}

// 2 x 2 pixels of 2 x 2 samples: a near wall on the left ends in the middle of the second column of samples.
PictureLight edge() {
    const GBuffer view = walls({2, 2}, {1, 4, 1, 4});
    const GBuffer fine = walls({4, 4}, {1, 4, 4, 4, 1, 4, 4, 4, 1, 1, 4, background, 1, 1, 4, 4});
    return scene::picture_light(view, fine, 2, nullptr);
}

TEST(PictureLight, ASampleShowsThePixelWhosePlaneItLiesOn) {
    EXPECT_EQ(edge().pixel, (std::vector<std::uint32_t>{0, 1, 1, 1, 0, 1, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
    EXPECT_EQ(edge().spread({0.1F, 0.2F, 0.3F, 0.4F}),
              (std::vector<float>{0.1F, 0.2F, 0.2F, 0.2F, 0.1F, 0.2F, 0.2F, 0.2F, 0.3F, 0.3F, 0.4F, 0.4F,
                                  0.3F, 0.3F, 0.4F, 0.4F}));
}

TEST(PictureLight, ATiltedPlaneIsOnePixelsOwn) {
    // The plane z = -4 + 2 x: depths of samples differ by far more than the tolerance, and each lies on it.
    GBuffer view = walls({2, 2}, std::vector<float>(4));
    GBuffer fine = walls({4, 4}, std::vector<float>(16));
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-2, 0, 1));
    for (GBuffer* one : {&view, &fine}) {
        one->normal.assign(one->depth.size(), glm::vec3(normal));
        const scene::PixelPositions positions(*one);
        for (std::size_t i = 0; i < one->depth.size(); ++i) {
            const glm::dvec3 ray = positions.at(i, 1.0);
            one->depth[i] = static_cast<float>(4.0 / (1.0 + 2.0 * ray.x));
        }
    }
    EXPECT_EQ(scene::picture_light(view, fine, 2, nullptr).pixel,
              (std::vector<std::uint32_t>{0, 0, 1, 1, 0, 0, 1, 1, 2, 2, 3, 3, 2, 2, 3, 3}));
}

TEST(PictureLight, ThePictureIsTheMeanOfItsSamples) {
    std::vector<glm::vec3> samples;
    for (int i = 0; i < 16; ++i) samples.emplace_back(static_cast<float>(i));
    const std::vector<glm::vec3> means = edge().mean(samples);
    ASSERT_EQ(means.size(), 4U);
    const float expected[] = {2.5F, 4.5F, 10.5F, 12.5F};
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(means[i], glm::vec3(expected[i]));
}

TEST(PictureLight, OneSampleIsThePixelItself) {
    const GBuffer view = walls({2, 1}, {1, 4});
    const PictureLight one = scene::picture_light(view, view, 1, nullptr);
    EXPECT_EQ(one.pixel, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(one.light.direct, scene::light_of(view, nullptr).direct);
}

TEST(PictureLight, OtherSizesAreRefused) {
    const GBuffer view = walls({2, 1}, {1, 4});
    EXPECT_THROW((void)scene::picture_light(view, view, 2, nullptr), std::invalid_argument);
    EXPECT_THROW((void)edge().spread({0.0F}), std::invalid_argument);
    EXPECT_THROW((void)edge().mean({glm::vec3(0)}), std::invalid_argument);
}

}  // namespace gloam::test::picture_light_test
