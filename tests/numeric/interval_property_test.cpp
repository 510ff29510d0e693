// SPDX-License-Identifier: MIT
// What holds for every operation on intervals: nothing that a value inside can lead to is lost.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <vector>

#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace interval_property_test {

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

TEST(IntervalProperties, HalfPrecisionPermitsWhatFullPrecisionDoes) {
    EXPECT_TRUE(rc::check("float16 bounds contain float32 bounds", [] {
        const auto& [name, function] = unary[*rc::gen::inRange<std::size_t>(0, unary.size())];
        const auto& f = function;  // clang 14 cannot capture a structured binding
        const float x = any_number();
        const auto calculate = [&] { return f(Interval::input(x)); };
        expect_contained(outcomes(calculate, float32), outcomes(calculate, float16), name);
    }));
}

TEST(IntervalProperties, BranchesContainTheirMembers) {
    const auto twisted = [](const auto& x, const auto& y) {
        using T = std::remove_cvref_t<decltype(x)>;
        T sum = x + y;
        if (sum > T(1)) sum = T(1) / sum;
        return x < y ? sum : -sum;
    };
    EXPECT_TRUE(rc::check("a function with branches", [&] {
        const Box x = any_box();
        const Box y = any_box();
        const Outcomes wide = outcomes([&] { return twisted(x.interval, y.interval); }, float32);
        for (const float a : x.members) {
            for (const float b : y.members) {
                expect_contained(
                    outcomes([&] { return twisted(Interval::input(a), Interval::input(b)); }, float32), wide,
                    "twisted");
            }
        }
    }));
}

}  // namespace interval_property_test
}  // namespace gloam::numeric
