// SPDX-License-Identifier: MIT
// Where Vulkan's rules end: the last float inside an error, what a division by zero gives, what is exact.
#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"
#include "support/test.hpp"

namespace gloam::numeric::interval_rules_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<float>::max();
constexpr double smallest = std::numeric_limits<float>::min();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Interval at(double x) {
    return Interval::input(static_cast<float>(x));
}

// All bounds of an expression that has several outcomes.
template <class F>
std::vector<Bounds> each_of(const F& expression) {
    std::vector<Bounds> all;
    Paths::explore(float32, 16, [&] { all.push_back(expression().bounds()); });
    return all;
}

TEST(IntervalRules, ANumberByZeroIsAnInfinityAndNothingBetween) {
    for (const double x : {1.0, -3.0, largest, 0x1p-126})
        EXPECT_THAT(each_of([=] { return at(x) / at(0.0); }),
                    testing::UnorderedElementsAre(Bounds::point(infinity), Bounds::point(-infinity)))
            << "the sign of the zero may be lost";
    EXPECT_TRUE(each_of([] { return at(smallest / 2) / at(0.0); })[0].is_anything()) << "perhaps 0 / 0";
    EXPECT_TRUE(each_of([] { return mod(at(3.0), at(0.0)); })[0].is_anything()) << "its formula has NaN";
}

// The last float whose distance is at most the bound.
TEST(IntervalRules, AnErrorInUlpEndsInside) {
    const double root = 1.0 / std::sqrt(2.0);
    EXPECT_EQ(inversesqrt(at(2.0)).bounds().high, std::floor((root + 2 * 0x1p-24) * 0x1p24) * 0x1p-24);
    EXPECT_EQ(inversesqrt(at(2.0)).bounds().low, std::ceil((root - 2 * 0x1p-24) * 0x1p24) * 0x1p-24);
    EXPECT_EQ(exp2(at(0.0)).bounds(), (Bounds{1.0 - 3 * 0x1p-24, 1.0 + 0x1p-23, false}))
        << "3 of the smaller gaps";
    const Bounds seventh = (at(3.0) / at(7.0)).bounds();
    EXPECT_LE(seventh.high - 3.0 / 7.0, 2.5 * 0x1p-25);
    EXPECT_LE(3.0 / 7.0 - seventh.low, 2.5 * 0x1p-25);
    EXPECT_EQ(exp(at(89.0)).bounds(), (Bounds{largest, infinity, false})) << "beyond the largest number";
}

TEST(IntervalRules, AnErrorBelowABoundDoesNotReachIt) {
    for (const Bounds& one : {log2(at(1.0)).bounds(), log(at(1.0)).bounds()}) {
        EXPECT_EQ(one.high, 0x1p-21 - 0x1p-45);
        EXPECT_EQ(one.low, -one.high);
    }
    EXPECT_LT(log2(at(2.0)).bounds().high, 1.0 + 0x1p-21);
    EXPECT_GT(log2(at(0.5)).bounds().low, -1.0 - 0x1p-21);
}

TEST(IntervalRules, AConstantOfAFormulaIsEitherNeighbour) {
    EXPECT_EQ(degrees(at(1.0)).bounds(), (Bounds{57.29577637F, 57.2957801818F, false}));
    EXPECT_TRUE(degrees(at(-2.0)).bounds().contains(-114.59155F)) << "by the lower constant";
    EXPECT_TRUE(degrees(at(-2.0)).bounds().contains(-114.591559F));
    const Bounds quarter = radians(at(45.0)).bounds();
    EXPECT_TRUE(quarter.contains(0.785398185F) && quarter.contains(0.785398126F));
    Bounds even = Bounds::anything();
    (void)Paths::explore(
        float32, 1, [&] { even = degrees(at(1.0)).bounds(); }, Paths::Gaps::open, Paths::Rounding::to_even);
    EXPECT_EQ(even, Bounds::point(57.2957801818F)) << "RoundingModeRTE";
}

// x and y, or t, stand twice in the formula.
TEST(IntervalRules, AMixLiesBetweenItsCorners) {
    const Interval unit = Interval::within(0.0, 1.0);
    for (const Interval& t : {at(0.25), at(0.7), unit}) {
        const Bounds mixed = mix(unit, unit, t).bounds();
        EXPECT_GT(mixed.low, -1e-5);
        EXPECT_LT(mixed.high, 1.0 + 1e-5);
        EXPECT_LE(mixed.low, 0.0);
        EXPECT_GE(mixed.high, 1.0);
        const Bounds twice = mix(mix(unit, unit, t), mix(unit, unit, t), t).bounds();
        EXPECT_LT(twice.high - twice.low, 1.0 + 1e-4);
    }
    const Bounds outside = mix(Interval::within(1.0, 2.0), at(10.0), Interval::within(-1.0, 2.0)).bounds();
    EXPECT_NEAR(outside.low, -8.0, 1e-4);
    EXPECT_NEAR(outside.high, 19.0, 1e-4);
    const Bounds smooth = smoothstep(at(0.0), at(1.0), Interval::within(0.25, 1.5)).bounds();
    EXPECT_NEAR(smooth.low, 0.15625, 1e-5);
    EXPECT_NEAR(smooth.high, 1.0, 1e-5);
}

TEST(IntervalRules, NotKeptSpecialsLeaveAComparisonOpen) {
    const auto answers = [](Paths::Specials specials, double x) {
        std::vector<bool> all;
        Paths::explore(
            float32, 4, [&] { all.push_back(at(x) >= at(0.0)); }, Paths::Gaps::open, Paths::Rounding::either,
            specials);
        return all;
    };
    for (const double special : {static_cast<double>(nan), infinity, -infinity}) {
        EXPECT_THAT(answers(Paths::Specials::listed, special), testing::UnorderedElementsAre(true, false));
        EXPECT_EQ(answers(Paths::Specials::kept, special).size(), 1U);
    }
    EXPECT_THAT(answers(Paths::Specials::dropped, 3.0), testing::ElementsAre(true));
}

}  // namespace gloam::numeric::interval_rules_test
