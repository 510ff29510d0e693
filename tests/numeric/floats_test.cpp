// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::numeric::floats_test {

constexpr float inf = infinity;
constexpr float largest = std::numeric_limits<float>::max();
constexpr float denorm_min = std::numeric_limits<float>::denorm_min();

TEST(Ulp, FollowsHarrison) {
    const std::pair<double, double> rows[] = {{1.0, 0x1p-24},  // at a power of two the smaller gap
                                              {-1.5, 0x1p-23},      {2.0, 0x1p-23},       {0.0, 0x1p-149},
                                              {0x1p-126, 0x1p-149}, {0x1p-130, 0x1p-149}, {largest, 0x1p104}};
    for (const auto& [x, ulp] : rows) EXPECT_EQ(float32.ulp(x), ulp) << x;
}

// A result, the exact one, and their distance. Special values have none: not even the largest number and
// infinity, which are both right beyond it. Subnormal results may be flushed.
TEST(UlpError, CountsFromTheExactResult) {
    const std::array<double, 3> rows[] = {{1.0, 1.0, 0.0},           {std::nextafter(1.5F, 2.0F), 1.5, 1.0},
                                          {1.5, 1.5 + 0x1p-24, 0.5}, {nan, nan, 0.0},
                                          {nan, 1.0, infinity},      {1.0, nan, infinity},
                                          {inf, inf, 0.0},           {-inf, inf, infinity},
                                          {inf, largest, infinity},  {largest, inf, infinity},
                                          {inf, 1e39, 0.0},          {largest, 1e39, 0.0},
                                          {-inf, 1e39, infinity},    {1e38, 1e39, infinity},
                                          {0.0, 1e-40, 0.0},         {denorm_min, -denorm_min, 2.0},
                                          {0.0, 0x1p-126, 0x1p23}};
    for (const auto& [got, want, error] : rows) EXPECT_EQ(ulp_error(got, want), error) << got << " " << want;
}

TEST(Step, MovesThroughAllFloats) {
    EXPECT_EQ(step(1.0F, 1), std::nextafter(1.0F, 2.0F));
    EXPECT_EQ(step(-1.0F, -1), std::nextafter(-1.0F, -2.0F));
    EXPECT_EQ(step(denorm_min, -2), -denorm_min) << "+0 and -0 are one value";
    EXPECT_EQ(step(largest, 1), inf);
    EXPECT_EQ(step(inf, 1), inf);
    EXPECT_TRUE(std::isnan(step(nan, 1)));
}

TEST(FloatClass, EveryClassHasItsValues) {
    EXPECT_EQ(classify(0.0F), FloatClass::zero);
    EXPECT_EQ(classify(-0.0F), FloatClass::zero);
    EXPECT_EQ(classify(0x1p-149F), FloatClass::subnormal);
    EXPECT_EQ(classify(-0x1.fffffcp-127F), FloatClass::subnormal);
    EXPECT_EQ(classify(0x1p-126F), FloatClass::ordinary);
    EXPECT_EQ(classify(0x1.fffffep63F), FloatClass::ordinary);
    EXPECT_EQ(classify(-0x1p64F), FloatClass::huge);
    EXPECT_EQ(classify(std::numeric_limits<float>::infinity()), FloatClass::infinite);
    EXPECT_EQ(classify(std::numeric_limits<float>::quiet_NaN()), FloatClass::nan);
}

TEST(Text, ShowsDecimalAndBits) {
    EXPECT_EQ(to_text(0.1F), "0.1 (0x3dcccccd)");
    EXPECT_EQ(to_text(-0.0F), "-0 (0x80000000)");
    EXPECT_EQ(to_text(0.1), "0.1 (0x1.999999999999ap-4)");
    EXPECT_EQ(to_text(0.0), "0 (0x0p+0)");
    EXPECT_EQ(to_text(-0.0), "-0 (-0x0p+0)");
    EXPECT_EQ(to_short_text(0.678), "0.68");
    EXPECT_EQ(to_short_text(1.5e41), "1.5e+41");  // once 44 digits
    EXPECT_EQ(to_short_text(-1.0 / 0.0), "-inf");
}

TEST(Random, IsTheSameOnEveryMachine) {
    static_assert(std::uniform_random_bit_generator<Random>);
    Random random(1);
    EXPECT_EQ(random(), 2469588189546311528U) << "the first number of mt19937_64 from seed 1";
    Random unit(2);
    for (int i = 0; i < 10'000; ++i) {
        const double x = unit.unit();
        ASSERT_GE(x, 0.0);
        ASSERT_LT(x, 1.0);
    }
}

// All finite values of float16 in rising order, zero once.
std::vector<double> halves() {
    std::vector<double> all;
    for (const double sign : {-1.0, 1.0})
        for (int exponent = 0; exponent < 31; ++exponent)
            for (int fraction = 0; fraction < 1024; ++fraction) {
                const double value = exponent == 0 ? fraction : std::ldexp(1024.0 + fraction, exponent - 1);
                if (value != 0.0 || sign > 0.0) all.push_back(sign * 0x1p-24 * value);
            }
    std::ranges::sort(all);
    return all;
}

TEST(FloatFormat, EveryHalfIsItsOwnNeighbourAndNumbersBetweenTwoGoToBoth) {
    const std::vector<double> all = halves();
    for (std::size_t i = 0; i + 1 < all.size(); ++i) {
        ASSERT_EQ(float16.round_down(all[i]), all[i]);
        ASSERT_EQ(float16.round_up(all[i]), all[i]);
        const double gap = all[i + 1] - all[i];
        ASSERT_EQ(float16.ulp(all[i] < 0.0 ? all[i] : all[i + 1]), gap) << all[i];
        for (const double part : {0x1p-30, 0.5, 1.0 - 0x1p-30}) {
            const double between = all[i] + part * gap;
            ASSERT_EQ(float16.round_down(between), all[i]) << between;
            ASSERT_EQ(float16.round_up(between), all[i + 1]) << between;
        }
    }
}

TEST(FloatFormat, BeyondTheLargestValueLieItAndInfinity) {
    for (const FloatFormat& format : {float32, float16}) {
        const double beyond = std::nextafter(format.largest(), HUGE_VAL);
        EXPECT_EQ(format.round_down(beyond), format.largest());
        EXPECT_EQ(format.round_up(beyond), infinity);
        EXPECT_EQ(format.round_down(-beyond), -infinity);
        EXPECT_EQ(format.round_up(-beyond), -format.largest());
        EXPECT_EQ(format.round_down(infinity), infinity);
        EXPECT_EQ(format.round_up(-infinity), -infinity);
    }
}

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

}  // namespace gloam::numeric::floats_test
