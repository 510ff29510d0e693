// SPDX-License-Identifier: MIT
#include "report/image.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

namespace gloam::report {
namespace image_test {

float float_at(const std::string& bytes, std::size_t offset) {
    float value = 0.0F;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(Pfm, RowsBottomFirstAndEveryBitKept) {
    constexpr float inf = std::numeric_limits<float>::infinity();
    const std::string file = to_pfm(std::vector<float>{1.0F, 2.0F, inf, -0.0F}, 2, 2, 1);
    const std::string header = "Pf\n2 2\n-1.0\n";
    ASSERT_EQ(file.size(), header.size() + 16);
    EXPECT_EQ(file.substr(0, header.size()), header);
    EXPECT_EQ(float_at(file, header.size()), inf);
    EXPECT_TRUE(std::signbit(float_at(file, header.size() + 4)));
    EXPECT_EQ(float_at(file, header.size() + 8), 1.0F);
    EXPECT_EQ(float_at(file, header.size() + 12), 2.0F);
}

TEST(Pfm, ThreeChannelsAreCalledPF) {
    EXPECT_EQ(to_pfm(std::vector<float>(3), 1, 1, 3).substr(0, 7), "PF\n1 1\n");
}

TEST(Pfm, WrongCountsAreRefused) {
    EXPECT_THROW((void)to_pfm(std::vector<float>(3), 2, 2, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(), 0, 0, 1), std::invalid_argument);
    EXPECT_THROW((void)to_pfm(std::vector<float>(8), 2, 2, 2), std::invalid_argument);
}

TEST(Png, IsOneWithTheSizeAskedFor) {
    const std::string file = to_png(std::vector<std::uint8_t>(15, 7), 5, 3);
    EXPECT_EQ(file.substr(0, 8), std::string("\x89PNG\r\n\x1a\n", 8));
    EXPECT_EQ(file[19], 5);
    EXPECT_EQ(file[23], 3);
    EXPECT_EQ(file[24], 8);  // bits
    EXPECT_EQ(file[25], 0);  // grey
}

TEST(Png, ShowsVisibility) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    const std::string got = to_visibility_png(std::vector<float>{0.0F, 1.0F, 0.5F, -3.0F, 9.0F, nan}, 6, 1);
    EXPECT_EQ(got, to_png(std::vector<std::uint8_t>{255, 0, 128, 255, 0, 255}, 6, 1));
    EXPECT_NE(got, to_png(std::vector<std::uint8_t>{0, 255, 128, 255, 0, 255}, 6, 1));
}

}  // namespace image_test
}  // namespace gloam::report
