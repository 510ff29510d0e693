// SPDX-License-Identifier: MIT
// Intervals in float32: results known in advance. bounds_test.py calculates those of many inputs.
#include <rapidcheck.h>

#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"
#include "numeric/random.hpp"
#include "support/test.hpp"

namespace gloam::numeric::interval_test {

constexpr double largest = std::numeric_limits<float>::max();
constexpr double smallest = std::numeric_limits<float>::min();

Interval at(double x) {
    return Interval::input(static_cast<float>(x));
}

TEST(Interval, ASumMayBeRoundedEitherWay) {
    const Bounds bounds = (at(1.0) + at(0x1p-60)).bounds();
    EXPECT_EQ(bounds, (Bounds{1.0, 1.0 + 0x1p-23, false})) << "what double cannot add counts as well";
    EXPECT_EQ((at(1.0) - at(0x1p-60)).bounds(), (Bounds{1.0 - 0x1p-24, 1.0, false}));
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

TEST(Interval, OfADivisionByWhatIsVeryLargeOrMayBeZeroNothingIsPromised) {
    EXPECT_TRUE((at(1.0) / at(0x1p127)).bounds().is_anything()) << "beyond 2^126 nothing is promised";
    EXPECT_TRUE((at(1.0) / at(smallest / 2)).bounds().is_anything());
    EXPECT_TRUE((at(1.0) / Interval::within(-1.0, 1.0)).bounds().is_anything());
    EXPECT_TRUE((at(0.0) / at(0.0)).bounds().is_anything());
}

TEST(Interval, WhatIsUndefinedIsAnything) {
    for (const Interval& x :
         {log(at(-1.0)), log2(at(0.0)), inversesqrt(at(0.0)), sqrt(at(-1.0)), pow(at(-2.0), at(2.0)),
          sin(at(4.0)), cos(at(-1e6)), atan(at(0.0), at(0.0)), clamp(at(1.0), at(3.0), at(2.0)),
          smoothstep(at(1.0), at(1.0), at(0.5)), ldexp(at(0x1p-100), 129), ldexp(at(0x1p100), 28),
          ldexp(at(1.0), 128), clamp(at(1.0), Interval::within(1.0, 3.0), at(2.0))}) {
        EXPECT_TRUE(x.bounds().is_anything());
    }
    EXPECT_EQ(ldexp(at(0x1p-1), 128).bounds(), Bounds::point(0x1p127));
    EXPECT_EQ(ldexp(at(0x1p20), -126).bounds(), Bounds::point(0x1p-106));
    EXPECT_EQ(ldexp(at(0x1p20), -127).bounds(), (Bounds{0.0, 0x1p-107, false})) << "may be flushed";
    EXPECT_EQ(times_power_of_two(at(0x1p127), -128).bounds(), Bounds::point(0.5)) << "a part of frexp()";
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
    EXPECT_EQ(closed([] { return sin(at(0x1p64)); }), (Bounds{-1.0, 1.0, false})) << "and it ends";
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

TEST(Interval, ASumIsTheUnionOverAllOrders) {
    // In one order the small number is lost, in another it decides.
    for (const std::size_t count : {3U, 4U}) {
        const std::array p{at(0x1p30), at(1.0), at(-0x1p30), at(0.0)};
        const Bounds bounds = sum_in_any_order(std::span(p).first(count)).bounds();
        EXPECT_TRUE(bounds.contains(0.0) && bounds.contains(1.0)) << count;
    }
    EXPECT_EQ(sum_in_any_order(std::array{at(1.0), at(4.0), at(9.0), at(16.0)}).bounds(),
              Bounds::point(30.0));
}

TEST(Interval, AnyOfDoesNotFillTheGap) {
    std::vector<Bounds> seen;
    Paths::explore(float32, 4, [&] { seen.push_back(any_of(at(1.0), at(5.0)).bounds()); });
    EXPECT_EQ(seen, (std::vector{Bounds::point(1.0), Bounds::point(5.0)}));
    EXPECT_EQ(any_of(Interval::within(1.0, 3.0), Interval::within(2.0, 5.0)).bounds(),
              (Bounds{1.0, 5.0, false}));
}

// Where Vulkan's rules end: what a division by zero gives, what is exact.

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

TEST(IntervalRules, WhereRoundingIsToEvenAConstantIsOneNumber) {
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
            float32, 4, [&] { all.push_back(at(0.0) <= at(x)); }, Paths::Gaps::open, Paths::Rounding::either,
            specials);
        return all;
    };
    for (const double special : {static_cast<double>(nan), infinity, -infinity}) {
        EXPECT_THAT(answers(Paths::Specials::listed, special), testing::UnorderedElementsAre(true, false));
        EXPECT_EQ(answers(Paths::Specials::kept, special).size(), 1U);
    }
    EXPECT_THAT(answers(Paths::Specials::dropped, 3.0), testing::ElementsAre(true));
}

// What holds for every operation on intervals: nothing that a value inside can lead to is lost.

// A float of any size; often a usual one.
float any_number() {
    const auto bits = *rc::gen::arbitrary<std::uint32_t>();
    const float wild = std::bit_cast<float>(bits);
    const bool usual = *rc::gen::inRange(0, 3) > 0;
    if (!usual && std::isfinite(wild)) return wild;
    return std::ldexp(static_cast<float>(bits % 20000U) / 5000.0F - 2.0F, *rc::gen::inRange(-6, 7));
}

struct Box {
    Interval interval;
    std::vector<float> members;
};

Box any_box() {
    float a = any_number();
    float b = *rc::gen::arbitrary<bool>() ? any_number() : step(a, *rc::gen::inRange(0, 50));
    if (a > b) std::swap(a, b);
    Box box{Interval::within(Interval::input(a).low(), Interval::input(b).high()), {a, b}};
    const auto middle = static_cast<float>((static_cast<double>(a) + b) / 2);
    box.members.push_back(middle);
    box.members.push_back(step(a, 1) <= b ? step(a, 1) : a);
    return box;
}

// All outcomes of a calculation, or that anything is permitted.
struct Outcomes {
    std::vector<Bounds> all;
    bool anything = false;

    [[nodiscard]] bool contain(const Bounds& bounds) const {
        return anything || std::ranges::any_of(all, [&](const Bounds& b) { return b.contains(bounds); });
    }
};

template <class F>
Outcomes outcomes(const F& calculate, const FloatFormat& format) {
    Outcomes result;
    result.anything = Paths::explore(format, 64, [&] { result.all.push_back(calculate().bounds()); }) !=
                      Paths::Outcome::complete;
    return result;
}

void expect_contained(const Outcomes& narrow, const Outcomes& wide, const char* name) {
    if (narrow.anything) {
        RC_ASSERT(wide.anything);
        return;
    }
    for (const Bounds& bounds : narrow.all) {
        if (!wide.contain(bounds))
            RC_FAIL(std::string(name) + " of a member leaves the bounds of the interval");
    }
}

using Unary = Interval (*)(const Interval&);
using Binary = Interval (*)(const Interval&, const Interval&);

const std::vector<std::pair<const char*, Unary>> unary{{"abs", abs},
                                                       {"sign", sign},
                                                       {"floor", floor},
                                                       {"ceil", ceil},
                                                       {"trunc", trunc},
                                                       {"round", round},
                                                       {"fract", fract},
                                                       {"radians", radians},
                                                       {"exp", exp},
                                                       {"exp2", exp2},
                                                       {"log", log},
                                                       {"log2", log2},
                                                       {"inversesqrt", inversesqrt},
                                                       {"sqrt", sqrt},
                                                       {"sin", sin},
                                                       {"cos", cos},
                                                       {"tan", tan},
                                                       {"asin", asin},
                                                       {"acos", acos},
                                                       {"sinh", sinh},
                                                       {"cosh", cosh},
                                                       {"tanh", tanh},
                                                       {"quantize", quantize_to_half},
                                                       {"atan", [](const Interval& x) { return atan(x); }}};

const std::vector<std::pair<const char*, Binary>> binary{
    {"+", [](const Interval& a, const Interval& b) { return a + b; }},
    {"-", [](const Interval& a, const Interval& b) { return a - b; }},
    {"*", [](const Interval& a, const Interval& b) { return a * b; }},
    {"/", [](const Interval& a, const Interval& b) { return a / b; }},
    {"min", min},
    {"max", max},
    {"step", step},
    {"mod", mod},
    {"remainder", remainder},
    {"pow", pow},
    {"atan2", [](const Interval& y, const Interval& x) { return atan(y, x); }}};

FloatFormat any_format() {
    return *rc::gen::arbitrary<bool>() ? float32 : float16;
}

TEST(IntervalProperties, UnaryFunctionsContainTheirMembers) {
    EXPECT_TRUE(rc::check("f(x) lies in f(X) for every x in X", [] {
        const FloatFormat format = any_format();
        const auto& [name, function] = unary[*rc::gen::inRange<std::size_t>(0, unary.size())];
        const auto& f = function;  // clang 14 cannot capture a structured binding
        const Box x = any_box();
        const Outcomes wide = outcomes([&] { return f(enclose(x.interval.bounds())); }, format);
        for (const float member : x.members) {
            expect_contained(outcomes([&] { return f(Interval::input(member)); }, format), wide, name);
        }
    }));
}

TEST(IntervalProperties, BinaryFunctionsContainTheirMembers) {
    EXPECT_TRUE(rc::check("f(x, y) lies in f(X, Y) for every x in X and y in Y", [] {
        const FloatFormat format = any_format();
        const auto& [name, function] = binary[*rc::gen::inRange<std::size_t>(0, binary.size())];
        const auto& f = function;  // clang 14 cannot capture a structured binding
        const Box x = any_box();
        const Box y = any_box();
        const Outcomes wide =
            outcomes([&] { return f(enclose(x.interval.bounds()), enclose(y.interval.bounds())); }, format);
        for (const float a : x.members) {
            for (const float b : y.members) {
                expect_contained(outcomes([&] { return f(Interval::input(a), Interval::input(b)); }, format),
                                 wide, name);
            }
        }
    }));
}

}  // namespace gloam::numeric::interval_test
