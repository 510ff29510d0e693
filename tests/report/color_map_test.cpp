// SPDX-License-Identifier: MIT
#include "report/color_map.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "report/image.hpp"

namespace gloam::report {
namespace color_map_test {

// Relative luminance of an sRGB colour.
double luminance(const Color& color) {
    const auto linear = [](std::uint8_t byte) {
        const double x = byte / 255.0;
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color[0]) + 0.7152 * linear(color[1]) + 0.0722 * linear(color[2]);
}

TEST(ColorMap, GetsLighterAllTheWay) {
    double before = -1.0;
    for (int i = 0; i <= 64; ++i) {
        const double now = luminance(heat_color(i / 64.0));
        EXPECT_GT(now, before) << i;
        before = now;
    }
    EXPECT_LT(luminance(heat_color(0.0)), 0.01);
    EXPECT_GT(luminance(heat_color(1.0)), 0.8);
}

TEST(ColorMap, EndsAtItsEnds) {
    EXPECT_EQ(heat_color(-3.0), heat_color(0.0));
    EXPECT_EQ(heat_color(7.0), heat_color(1.0));
    EXPECT_EQ(heat_color(std::numeric_limits<double>::quiet_NaN()), heat_color(0.0));
}

TEST(HeatMap, IsAPictureOfErrors) {
    const std::vector<float> errors{0.0F, -0.25F, 0.1F, std::numeric_limits<float>::quiet_NaN()};
    EXPECT_THAT(to_heat_png(errors, 2, 2, 0.25), testing::StartsWith("\x89PNG"));
    // Only the magnitude counts, up to the end of the scale.
    EXPECT_EQ(to_heat_png(std::vector<float>{0.3F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{-9.0F}, 1, 1, 0.25));
    EXPECT_NE(to_heat_png(std::vector<float>{0.1F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{0.2F}, 1, 1, 0.25));
    EXPECT_NE(to_heat_png(std::vector<float>{0.0F}, 1, 1, 0.25),
              to_heat_png(std::vector<float>{errors[3]}, 1, 1, 0.25));
    EXPECT_THROW((void)to_heat_png(errors, 2, 3, 0.25), std::invalid_argument);
    EXPECT_THROW((void)to_heat_png(errors, 2, 2, 0.0), std::invalid_argument);
    EXPECT_THROW((void)to_rgb_png(std::vector<std::uint8_t>(5), 1, 2), std::invalid_argument);
}

}  // namespace color_map_test
}  // namespace gloam::report
