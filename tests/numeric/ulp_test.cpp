// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <limits>

namespace gloam::numeric {
namespace ulp_test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float largest = std::numeric_limits<float>::max();
constexpr float denorm_min = std::numeric_limits<float>::denorm_min();

TEST(UlpSize, FollowsHarrison) {
    EXPECT_EQ(ulp_size(1.0), 0x1p-24) << "at a power of two the smaller gap";
    EXPECT_EQ(ulp_size(1.5), 0x1p-23);
    EXPECT_EQ(ulp_size(-1.5), 0x1p-23);
    EXPECT_EQ(ulp_size(2.0), 0x1p-23);
    EXPECT_EQ(ulp_size(0.0), 0x1p-149);
    EXPECT_EQ(ulp_size(0x1p-126), 0x1p-149);
    EXPECT_EQ(ulp_size(0x1p-130), 0x1p-149) << "below the smallest normal its gap";
    EXPECT_EQ(ulp_size(largest), 0x1p104);
    EXPECT_TRUE(std::isnan(ulp_size(inf)));
}

TEST(UlpError, CountsFromTheExactResult) {
    EXPECT_EQ(ulp_error(1.0F, 1.0), 0.0);
    EXPECT_EQ(ulp_error(std::nextafter(1.5F, 2.0F), 1.5), 1.0);
    EXPECT_EQ(ulp_error(1.5F, 1.5 + 0x1p-24), 0.5);
}

TEST(UlpError, SpecialValuesHaveNoDistance) {
    EXPECT_EQ(ulp_error(nan, nan), 0.0);
    EXPECT_EQ(ulp_error(nan, 1.0), std::numeric_limits<double>::infinity());
    EXPECT_EQ(ulp_error(1.0F, nan), std::numeric_limits<double>::infinity());
    EXPECT_EQ(ulp_error(inf, inf), 0.0);
    EXPECT_EQ(ulp_error(-inf, inf), std::numeric_limits<double>::infinity());
    EXPECT_EQ(ulp_error(inf, largest), std::numeric_limits<double>::infinity()) << "not one ULP apart";
    EXPECT_EQ(ulp_error(largest, inf), std::numeric_limits<double>::infinity());
}

TEST(UlpError, OverflowAllowsTheLargestValueOrInfinity) {
    EXPECT_EQ(ulp_error(inf, 1e39), 0.0);
    EXPECT_EQ(ulp_error(largest, 1e39), 0.0);
    EXPECT_EQ(ulp_error(-inf, 1e39), std::numeric_limits<double>::infinity());
    EXPECT_EQ(ulp_error(1e38F, 1e39), std::numeric_limits<double>::infinity());
}

TEST(UlpError, SubnormalResultsMayBeFlushed) {
    EXPECT_EQ(ulp_error(0.0F, 1e-40), 0.0);
    EXPECT_EQ(ulp_error(denorm_min, -static_cast<double>(denorm_min)), 2.0)
        << "across zero the distance is 2";
    EXPECT_GT(ulp_error(0.0F, 0x1p-126), 1e6) << "a normal result may not";
}

TEST(Step, MovesThroughAllFloats) {
    EXPECT_EQ(step(1.0F, 1), std::nextafter(1.0F, 2.0F));
    EXPECT_EQ(step(-1.0F, -1), std::nextafter(-1.0F, -2.0F));
    EXPECT_EQ(step(denorm_min, -2), -denorm_min) << "+0 and -0 are one value";
    EXPECT_EQ(step(largest, 1), inf);
    EXPECT_EQ(step(inf, 1), inf);
    EXPECT_TRUE(std::isnan(step(nan, 1)));
}

TEST(UlpError, Properties) {
    const auto any = [](unsigned bits) { return std::bit_cast<float>(bits); };
    EXPECT_TRUE(rc::check("a finite float is 0 from itself", [&](unsigned bits) {
        RC_PRE(std::isfinite(any(bits)));
        RC_ASSERT(ulp_error(any(bits), any(bits)) == 0.0);
    }));
    EXPECT_TRUE(
        rc::check("n steps are at most n ULP, and n or n/2 next to a power of two", [&](unsigned bits) {
            const float x = any(bits);
            const int n = *rc::gen::inRange(1, 1000);
            RC_PRE(std::isfinite(x) && std::isfinite(step(x, n)));
            const double error = ulp_error(x, step(x, n));
            RC_ASSERT(error >= 0.0);
            RC_ASSERT(error <= 2.0 * n);
            RC_ASSERT(error >= 0.25 * n || x == 0.0F ||
                      std::abs(step(x, n)) < std::numeric_limits<float>::min());
        }));
    EXPECT_TRUE(rc::check("steps undo each other", [&](unsigned bits) {
        const float x = any(bits);
        RC_PRE(std::isfinite(x) && std::isfinite(step(x, 77)));
        RC_ASSERT(step(step(x, 77), -77) == x);
    }));
}

}  // namespace ulp_test
}  // namespace gloam::numeric
