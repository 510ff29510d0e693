// SPDX-License-Identifier: MIT
// Intervals in float32: results known in advance, and sums against wider arithmetic.
#include "numeric/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/paths.hpp"
#include "numeric/random.hpp"

namespace gloam::numeric {
namespace interval_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<float>::max();
constexpr double smallest = std::numeric_limits<float>::min();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Interval at(double x) {
    return Interval::input(static_cast<float>(x));
}

TEST(Interval, ExactResultsAreOnePoint) {
    EXPECT_EQ((at(1.5) + at(2.25)).bounds(), Bounds::point(3.75));
    EXPECT_EQ((at(1.5) * at(-2.0)).bounds(), Bounds::point(-3.0));
    EXPECT_EQ((-at(1.5)).bounds(), Bounds::point(-1.5));
    EXPECT_EQ(min(at(1.0), at(2.0)).bounds(), Bounds::point(1.0));
}

TEST(Interval, ASumMayBeRoundedEitherWay) {
    const Bounds bounds = (at(1.0) + at(0x1p-60)).bounds();
    EXPECT_EQ(bounds, (Bounds{1.0, 1.0 + 0x1p-23, false})) << "what double cannot add counts as well";
    EXPECT_EQ((at(1.0) - at(0x1p-60)).bounds(), (Bounds{1.0 - 0x1p-24, 1.0, false}));
}

TEST(Interval, SumsAgreeWithWiderArithmetic) {
    Random random(7);
    for (int i = 0; i < 200'000; ++i) {
        const auto draw = [&] {
            return static_cast<float>(std::ldexp(random.uniform(-2, 2), static_cast<int>(random.below(36))));
        };
        const float a = draw();
        const float b = draw();
        const long double exact = static_cast<long double>(a) + b;  // 64 bits hold it
        const Bounds bounds = (Interval::input(a) + Interval::input(b)).bounds();
        auto down = static_cast<float>(exact);
        if (down > exact) down = std::nextafter(down, -std::numeric_limits<float>::infinity());
        auto up = static_cast<float>(exact);
        if (up < exact) up = std::nextafter(up, std::numeric_limits<float>::infinity());
        ASSERT_EQ(bounds, (Bounds{down, up, false})) << a << " + " << b;
    }
}

TEST(Interval, SubnormalsMayBeFlushedOnTheWayInAndOut) {
    EXPECT_EQ(at(smallest / 4).bounds(), (Bounds{0.0, smallest / 4, false}));
    EXPECT_EQ((at(smallest) * at(-0.5)).bounds(), (Bounds{-smallest / 2, 0.0, false}));
    EXPECT_EQ((at(smallest) - at(smallest * 1.5)).bounds(), (Bounds{-smallest / 2, 0.0, false}));
}

TEST(Interval, OverflowIsTheLargestValueOrInfinity) {
    EXPECT_EQ((at(largest) * at(2.0)).bounds(), (Bounds{largest, infinity, false}));
    EXPECT_EQ((at(-largest) - at(largest)).bounds(), (Bounds{-infinity, -largest, false}));
    EXPECT_EQ((at(infinity) + at(1.0)).bounds(), Bounds::point(infinity)) << "an exact infinity stays one";
}

TEST(Interval, NanIsKeptApart) {
    EXPECT_EQ((at(nan) + at(1.0)).bounds(), Bounds::only_nan());
    EXPECT_EQ((at(infinity) - at(infinity)).bounds(), Bounds::only_nan());
    EXPECT_EQ((at(0.0) * at(infinity)).bounds(), Bounds::only_nan());
    EXPECT_EQ((Interval::within(0.0, 1.0) * at(infinity)).bounds(), (Bounds{0.0, infinity, true}));
    EXPECT_EQ((Interval::within(0.0, 1.0) + Interval::within(Bounds{2.0, 3.0, true})).bounds(),
              (Bounds{2.0, 4.0, true}));
    EXPECT_EQ(min(at(nan), at(1.0)).bounds(), (Bounds{1.0, 1.0, true})) << "either operand";
}

TEST(Interval, DivisionErrsByTwoAndAHalfUlp) {
    // 3 lies between powers of two, with an ULP of 2^-22; 2.5 of them end between two values.
    EXPECT_EQ((at(6.0) / at(2.0)).bounds(), (Bounds{3.0 - 3 * 0x1p-22, 3.0 + 3 * 0x1p-22, false}));
    EXPECT_TRUE((at(1.0) / at(0x1p127)).bounds().is_anything()) << "beyond 2^126 nothing is promised";
    EXPECT_TRUE((at(1.0) / at(smallest / 2)).bounds().is_anything());
    EXPECT_TRUE((at(1.0) / Interval::within(-1.0, 1.0)).bounds().is_anything());
    EXPECT_EQ((at(1.0) / at(0.0)).bounds(), (Bounds{-infinity, infinity, false}));
    EXPECT_TRUE((at(0.0) / at(0.0)).bounds().is_anything());
}

TEST(Interval, WhatIsUndefinedIsAnything) {
    for (const Interval& x : {log(at(-1.0)), log2(at(0.0)), inversesqrt(at(0.0)), sqrt(at(-1.0)),
                              pow(at(-2.0), at(2.0)), sin(at(4.0)), cos(at(-1e6)), atan(at(0.0), at(0.0)),
                              clamp(at(1.0), at(3.0), at(2.0)), smoothstep(at(1.0), at(1.0), at(0.5))}) {
        EXPECT_TRUE(x.bounds().is_anything());
    }
}

// The bounds of an expression where the gaps of Vulkan's rules are closed.
template <class F>
Bounds closed(const F& expression) {
    Bounds bounds = Bounds::anything();
    (void)Paths::explore(float32, 1, [&] { bounds = expression().bounds(); }, Paths::Gaps::closed);
    return bounds;
}

TEST(Interval, ClosedGapsHaveThePrecisionBesideThem) {
    EXPECT_EQ(closed([] { return sqrt(at(0.0)); }), Bounds::point(0.0));
    EXPECT_EQ(closed([] { return pow(at(0.0), at(0.5)); }), Bounds::point(0.0));
    const Bounds root = closed([] { return sqrt(Interval::within(0.0, 4.0)); });
    EXPECT_EQ(root.low, 0.0);
    EXPECT_NEAR(root.high, 2.0, 1e-6);
    const Bounds power = closed([] { return pow(Interval::within(0.0, 4.0), at(0.5)); });
    EXPECT_EQ(power.low, 0.0);
    EXPECT_NEAR(power.high, 2.0, 1e-5);
    const Bounds arc = closed([] { return acos(at(1.0)); });
    EXPECT_LE(arc.low, 0.0);
    EXPECT_LT(arc.high, 1e-6);
    const Bounds sine = closed([] { return sin(at(100.0)); });
    EXPECT_NEAR(sine.low, std::sin(100.0) - 0x1p-11, 1e-7);
    EXPECT_NEAR(sine.high, std::sin(100.0) + 0x1p-11, 1e-7);
    EXPECT_EQ(closed([] { return cos(Interval::within(6.0, 6.5)); }).high, 1.0) << "it turns at two pi";
    EXPECT_EQ(closed([] { return cos(Interval::within(8.0, 12.0)); }), (Bounds{-1.0, 1.0, false}));
    for (const Bounds& still :
         {closed([] { return sqrt(at(-1.0)); }), closed([] { return pow(at(0.0), at(-1.0)); }),
          closed([] { return pow(at(-1.0), at(2.0)); }), closed([] { return log(at(0.0)); }),
          closed([] { return inversesqrt(at(0.0)); }), closed([] { return sin(at(infinity)); })})
        EXPECT_TRUE(still.is_anything()) << "undefined";
}

TEST(Interval, SinesTurnInside) {
    const Bounds sine = sin(Interval::within(1.0, 2.0)).bounds();
    EXPECT_EQ(sine.high, 1.0);
    EXPECT_NEAR(sine.low, std::sin(1.0) - 0x1p-11, 1e-7);
    EXPECT_EQ(cos(Interval::within(-0.5, 0.25)).bounds().high, 1.0);
    EXPECT_EQ(cos(Interval::within(3.0, std::numbers::pi)).bounds().low, -1.0);
}

TEST(Interval, TheAngleAtTheCutIsEitherHalfTurn) {
    std::vector<Bounds> angles;
    Paths::explore(float32, 4, [&] { angles.push_back(atan(at(0.0), at(-1.0)).bounds()); });
    ASSERT_EQ(angles.size(), 2U);
    EXPECT_TRUE(angles[0].contains(std::numbers::pi) && !angles[0].contains(0.0));
    EXPECT_TRUE(angles[1].contains(-std::numbers::pi) && !angles[1].contains(0.0));
}

TEST(Interval, LogarithmsChangeTheirRuleAtAHalfAndTwo) {
    EXPECT_NEAR(log2(at(1.0)).bounds().high, 0x1p-21, 1e-9);
    EXPECT_EQ(log2(at(4.0)).bounds().high - 2.0, 2 * 0x1p-22)
        << "3 of the smaller gaps, rounded up to the larger";
    const Bounds across = log2(Interval::within(0.25, 4.0)).bounds();
    EXPECT_TRUE(across.contains(log2(at(0.25)).bounds()) && across.contains(log2(at(4.0)).bounds()));
}

TEST(Interval, HalvesRoundEitherWay) {
    EXPECT_EQ(round(at(2.5)).bounds(), (Bounds{2.0, 3.0, false}));
    EXPECT_EQ(round(at(-0.75)).bounds(), Bounds::point(-1.0));
    EXPECT_EQ(round_even(at(2.5)).bounds(), Bounds::point(2.0));
    EXPECT_EQ(fract(at(-0x1p-40)).bounds(), (Bounds{1.0 - 0x1p-24, 1.0, false}));
}

TEST(Interval, ConstantsAreWhatACompilerWrites) {
    EXPECT_EQ(Interval(0.1).bounds(), Bounds::point(0.1F));
    EXPECT_EQ(Interval(16777217).bounds(), (Bounds{16777216.0, 16777218.0, false})) << "a conversion rounds";
}

TEST(Interval, QuantizingKeepsBothNeighboursInHalf) {
    EXPECT_EQ(quantize_to_half(at(1.0 + 0x1p-12)).bounds(), (Bounds{1.0, 1.0 + 0x1p-10, false}));
    EXPECT_EQ(quantize_to_half(at(1e6)).bounds(), (Bounds{65504.0, infinity, false}));
    EXPECT_EQ(quantize_to_half(at(0x1p-20)).bounds(), (Bounds{0.0, 0x1p-20, false}));
}

TEST(IntervalVector, DotIsTheUnionOverAllOrders) {
    // In one order the small number is lost, in another it decides.
    const IntervalVec3 a(at(0x1p30), at(1.0), at(-0x1p30));
    const IntervalVec3 ones(at(1.0), at(1.0), at(1.0));
    const Bounds bounds = dot(a, ones).bounds();
    EXPECT_TRUE(bounds.contains(0.0) && bounds.contains(1.0));
    const IntervalVec4 b(at(1.0), at(2.0), at(3.0), at(4.0));
    EXPECT_EQ(dot(b, b).bounds(), Bounds::point(30.0));
    const IntervalVec2 turned =
        IntervalMat2(at(0.0), at(1.0), at(-1.0), at(0.0)) * IntervalVec2(at(3.0), at(4.0));
    EXPECT_EQ(turned.x.bounds(), Bounds::point(-4.0));
    EXPECT_EQ(turned.y.bounds(), Bounds::point(3.0));
}

TEST(Interval, AnyOfDoesNotFillTheGap) {
    std::vector<Bounds> seen;
    Paths::explore(float32, 4, [&] { seen.push_back(any_of(at(1.0), at(5.0)).bounds()); });
    EXPECT_EQ(seen, (std::vector{Bounds::point(1.0), Bounds::point(5.0)}));
    EXPECT_EQ(any_of(Interval::within(1.0, 3.0), Interval::within(2.0, 5.0)).bounds(),
              (Bounds{1.0, 5.0, false}));
}

}  // namespace interval_test
}  // namespace gloam::numeric
