// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "effect/errors.hpp"
#include "numeric/random.hpp"
#include "support/matchers.hpp"

namespace gloam::effect::metrics_test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
using Image = std::vector<float>;

Image noise(std::size_t pixels, std::uint64_t seed) {
    numeric::Random random(seed);
    Image image(pixels);
    for (float& value : image) value = static_cast<float>(random.unit());
    return image;
}

TEST(Similarity, OfConstantsByHand) {
    // No variance: only the means count. Visibilities 0.5 and 0.75.
    const double expected = (2.0 * 0.5 * 0.75 + 1e-4) / (0.25 + 0.5625 + 1e-4);
    EXPECT_NEAR(structural_similarity(Image(300, 0.5F), Image(300, 0.25F), {20, 15}), expected, 1e-9);
}

TEST(Similarity, OfASinglePixelIsThatOfItsMeans) {
    const double expected = (2.0 * 1.0 * 0.5 + 1e-4) / (1.0 + 0.25 + 1e-4);
    EXPECT_NEAR(structural_similarity(Image{0.0F}, Image{0.5F}, {1, 1}), expected, 1e-9);
}

// Two pixels, 0 and 1 against 1 and 0: seen from either, the weights of both are 1 and g = exp(-1 / 4.5).
TEST(Similarity, OfTwoPixelsByHand) {
    const double g = std::exp(-0.5 / (1.5 * 1.5));
    const double near = 1.0 / (1.0 + g);
    const double x = near;        // the mean of one image about the pixel where it is 1
    const double y = 1.0 - near;  // and of the other
    const double variance = x - x * x;
    const double covariance = -x * y;
    const double expected =
        (2 * x * y + 1e-4) * (2 * covariance + 9e-4) / ((x * x + y * y + 1e-4) * (2 * variance + 9e-4));
    EXPECT_NEAR(structural_similarity(Image{0, 1}, Image{1, 0}, {2, 1}), expected, 1e-9);
}

TEST(Similarity, OfEqualAndOfUnrelatedImages) {
    const Image a = noise(1600, 1);
    EXPECT_NEAR(structural_similarity(a, a, {40, 40}), 1.0, 1e-12);
    EXPECT_LT(std::abs(structural_similarity(a, noise(1600, 2), {40, 40})), 0.2);
    EXPECT_EQ(structural_similarity(a, Image(1600, nan), {40, 40}), 1.0);
    EXPECT_THROW((void)structural_similarity(a, a, {40, 39}), std::invalid_argument);
}

TEST(Similarity, LeavesOutWhatIsNotKnown) {
    Image truth = noise(900, 3);
    Image image = truth;
    for (std::size_t i = 0; i < 900; i += 2) {
        truth[i] = nan;
        image[i] = 0.123F;  // anything
    }
    EXPECT_NEAR(structural_similarity(image, truth, {30, 30}), 1.0, 1e-12);
}

TEST(Remap, ByHand) {
    EXPECT_EQ((Remap{0.5, 1, 2}(0.5)), 1.0);
    EXPECT_DOUBLE_EQ((Remap{0.5, 1, 2}(0.25)), 0.5625);
    EXPECT_EQ((Remap{}(0.3)), 0.3);
    EXPECT_EQ((Remap{-0.5, 1, 2}(0.3)), 0.0);
    EXPECT_EQ((Remap{-0.5, 1, 0}(0.3)), 1.0);
}

// Images made by a remap of the truth are brought back to it.
TEST(Remap, IsFound) {
    const Image occlusion = noise(5000, 4);
    for (const Remap& remap : {Remap{0.1, 0.8, 1.7}, Remap{-0.2, 1.2, 1.0}, Remap{0, 0.9, 0.5}, Remap{}}) {
        const Image truth = remapped(occlusion, remap);
        const double before = errors_of(occlusion, truth).rmse;
        const double after = errors_of(remapped(occlusion, best_remap(occlusion, truth)), truth).rmse;
        EXPECT_LT(after, 2e-3) << remap.a << " " << remap.b << " " << remap.c;
        EXPECT_LE(after, before);
    }
}

TEST(Remap, IsNeverWorseThanNoneAndAlwaysTheSame) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Image occlusion = noise(500, seed);
        const Image truth = noise(500, seed + 100);
        const Remap fit = best_remap(occlusion, truth);
        EXPECT_LE(errors_of(remapped(occlusion, fit), truth).rmse, errors_of(occlusion, truth).rmse);
        const Remap again = best_remap(occlusion, truth);
        EXPECT_EQ(fit.a, again.a);
        EXPECT_EQ(fit.b, again.b);
        EXPECT_EQ(fit.c, again.c);
    }
    EXPECT_EQ(best_remap(Image{0.5F}, Image{nan}).b, 1.0);
    EXPECT_THROW((void)best_remap(Image(2), Image(3)), std::invalid_argument);
}

TEST(Metrics, PutTheirPartsTogether) {
    const Image truth = noise(400, 7);
    const Image image = remapped(truth, {0.05, 0.9, 1.1});
    const Metrics metrics = metrics_of(image, truth, {20, 20});
    EXPECT_EQ(metrics.raw.rmse, errors_of(image, truth).rmse);
    EXPECT_EQ(metrics.similarity, structural_similarity(image, truth, {20, 20}));
    EXPECT_LT(metrics.after_remap.rmse, 0.2 * metrics.raw.rmse);
    EXPECT_GT(metrics.similarity_after_remap, metrics.similarity);
}

TEST(Metrics, OfAMask) {
    const Truth truth = masked(Image{0.1F, 0.2F, nan}, Mask{0, 1, 1});
    EXPECT_TRUE(std::isnan(truth[0]));
    EXPECT_EQ(truth[1], 0.2F);
    EXPECT_EQ(errors_of(Image{0, 0.7F, 0}, truth).compared, 1U);
    EXPECT_THROW((void)masked(Image(2), Mask(3)), std::invalid_argument);
}

}  // namespace gloam::effect::metrics_test
