// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace gloam::numeric {
namespace spread_test {

TEST(Spread, IsMedianAndQuartiles) {
    const Spread spread = spread_of(std::array{5.0, 1.0, 4.0, 2.0, 3.0});
    EXPECT_EQ(spread.median, 3.0);
    EXPECT_EQ(spread.low, 2.0);
    EXPECT_EQ(spread.high, 4.0);
    const Spread two = spread_of(std::array{1.0, 2.0});
    EXPECT_EQ(two.median, 1.5);
    EXPECT_EQ(two.low, 1.25);
    EXPECT_EQ(two.high, 1.75);
    EXPECT_EQ(spread_of(std::array{7.0}).high, 7.0);
}

TEST(Spread, LeavesOutWhatIsNotFinite) {
    EXPECT_EQ(spread_of(std::array{1.0, std::nan(""), HUGE_VAL}).median, 1.0);
    EXPECT_TRUE(std::isnan(spread_of({}).median));
    EXPECT_TRUE(std::isnan(spread_of(std::array{std::nan("")}).low));
}

TEST(Exponent, FitsTheExponent) {
    std::vector<std::pair<double, double>> points;
    for (const double x : {1.0, 2.0, 5.0, 30.0}) points.emplace_back(x, 3.0 * std::pow(x, 1.7));
    EXPECT_NEAR(exponent_of(points), 1.7, 1e-12);
    points = {{1, 2}, {10, 2}, {100, 2}};
    EXPECT_NEAR(exponent_of(points), 0.0, 1e-12);
    points = {{1, 1}, {1, 4}, {4, 2}, {4, 8}};  // least squares: between the two
    EXPECT_NEAR(exponent_of(points), 0.5, 1e-12);
}

TEST(Exponent, LeavesOutWhatHasNoLogarithm) {
    const std::vector<std::pair<double, double>> points{{0, 5},    {1, 1}, {-1, 2}, {3, std::nan("")},
                                                        {10, 100}, {5, 0}};
    EXPECT_NEAR(exponent_of(points), 2.0, 1e-12);
    EXPECT_TRUE(std::isnan(exponent_of({})));
    const std::vector<std::pair<double, double>> same{{2, 1}, {2, 3}};
    EXPECT_TRUE(std::isnan(exponent_of(same)));
}

}  // namespace spread_test
}  // namespace gloam::numeric
