// SPDX-License-Identifier: MIT
#include "effect/errors.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace gloam::effect {
namespace errors_test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Errors, OfKnownNumbers) {
    const Errors errors =
        errors_of(std::vector<float>{0.5F, 0.25F, 1.0F, 0.9F}, std::vector<float>{0.25F, 0.75F, nan, 0.9F});
    EXPECT_EQ(errors.compared, 3U);
    EXPECT_DOUBLE_EQ(errors.rmse, std::sqrt((0.0625 + 0.25) / 3.0));
    EXPECT_DOUBLE_EQ(errors.mean, 0.25);
    EXPECT_DOUBLE_EQ(errors.bias, -0.25 / 3.0);
    EXPECT_DOUBLE_EQ(errors.max, 0.5);
}

TEST(Errors, NinetyNineOfAHundred) {
    std::vector<float> image(100);
    std::iota(image.begin(), image.end(), 1.0F);
    EXPECT_EQ(errors_of(image, std::vector<float>(100, 0.0F)).percentile_99, 99.0);
}

TEST(Errors, NothingToCompareOrSizesThatDisagree) {
    EXPECT_EQ(errors_of(std::vector<float>{1.0F}, std::vector<float>{nan}).compared, 0U);
    EXPECT_THROW((void)errors_of(std::vector<float>(2), std::vector<float>(3)), std::invalid_argument);
}

// A ball of radius 1 at depth 4, under a right angle of view: its silhouette reaches atan(1 / sqrt(15)) from
// its centre.
TEST(Truth, IsNotKnownNearTheBorder) {
    scene::GBuffer view{.extent = {400, 400}};
    view.depth.assign(160'000, 4.0F);
    view.camera = scene::make_frame({.fovy_rad = std::acos(-1.0) / 2}, 1.0);
    const Truth truth = truth_of(view, 1.0, [](const glm::dvec3&, double) { return 0.5; });
    const double pixel = 4.0 * 2.0 / 400.0;
    int first = 0;
    while (!std::isfinite(truth[static_cast<std::size_t>(200 * 400 + first)])) ++first;
    const double x = -4.0 + (first + 0.5) * pixel;  // world units from the axis
    const double edge = std::tan(std::atan(-x / 4.0) + std::asin(1.0 / std::hypot(x, 4.0)));
    EXPECT_NEAR(edge, 1.0 - 2.0 / 400.0, 0.02);
    EXPECT_LT(edge, 1.0);
    EXPECT_EQ(truth[200 * 400 + 200], 0.5F);
}

}  // namespace errors_test
}  // namespace gloam::effect
