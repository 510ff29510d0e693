// SPDX-License-Identifier: MIT
// Intervals in float16 against every value of the format.
#include "halves.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric::interval_half_test {

constexpr double infinity = std::numeric_limits<double>::infinity();

Bounds in_half(const std::function<Interval()>& calculate) {
    Bounds bounds{};
    const auto outcome = Paths::explore(float16, 1, [&] { bounds = calculate().bounds(); });
    EXPECT_EQ(outcome, Paths::Outcome::complete);
    return bounds;
}

Interval half(double value) {
    return Interval::input(static_cast<float>(value));
}

// What a correctly rounded operation may return: both neighbours, and zero for a subnormal result.
Bounds rounded(double exact) {
    Bounds bounds{halves::at_or_below(exact), halves::at_or_above(exact), false};
    if (exact > 65504.0) bounds.low = 65504.0;
    if (exact < -65504.0) bounds.high = -65504.0;
    if (exact > 0.0 && exact < 0x1p-14) bounds.low = 0.0;
    if (exact < 0.0 && exact > -0x1p-14) bounds.high = 0.0;
    return bounds;
}

bool is_normal(double x) {
    return x == 0.0 || std::abs(x) >= 0x1p-14;
}

TEST(IntervalHalf, SumsDifferencesAndProductsAreBothNeighbours) {
    const auto check = [](double x, double y) {
        ASSERT_EQ(in_half([&] { return half(x) + half(y); }), rounded(x + y)) << x << " + " << y;
        ASSERT_EQ(in_half([&] { return half(x) - half(y); }), rounded(x - y)) << x << " - " << y;
        ASSERT_EQ(in_half([&] { return half(x) * half(y); }), rounded(x * y)) << x << " * " << y;
    };
    const std::vector<double> some = halves::some();
    for (std::size_t i = 0; i < halves::finite().size(); ++i) {
        const double x = halves::finite()[i];
        const double y = some[i % some.size()];
        if (is_normal(x) && is_normal(y)) check(x, y);
    }
    for (const double x : some) {
        for (const double y : some) {
            if (is_normal(x) && is_normal(y)) check(x, y);
        }
    }
}

TEST(IntervalHalf, ASubnormalInputMayBeZero) {
    for (const double x : halves::finite()) {
        if (is_normal(x)) continue;
        ASSERT_EQ(in_half([&] { return half(x); }), (Bounds{std::min(x, 0.0), std::max(x, 0.0), false}));
    }
}

// Every half within `error` of the exact result is permitted; where nothing is flushed, none beyond it.
void expect_rule(const Bounds& bounds, double exact, double error, const std::string& what) {
    constexpr double double_error = 1e-9;
    ASSERT_TRUE(bounds.contains(halves::at_or_above(exact - error * (1.0 - double_error)))) << what;
    ASSERT_TRUE(bounds.contains(halves::at_or_below(exact + error * (1.0 - double_error)))) << what;
    if (std::abs(exact) - error < 0x1p-14) return;
    ASSERT_GE(bounds.low, halves::at_or_above(exact - error * (1.0 + double_error))) << what;
    ASSERT_LE(bounds.high, halves::at_or_below(exact + error * (1.0 + double_error))) << what;
}

TEST(IntervalHalf, QuotientsErrByTwoAndAHalfUlp) {
    const std::vector<double> some = halves::some();
    for (std::size_t i = 0; i < halves::finite().size(); ++i) {
        const double x = halves::finite()[i];
        const double y = some[i % some.size()];
        if (!is_normal(x) || !is_normal(y) || y == 0.0) continue;
        const Bounds bounds = in_half([&] { return half(x) / half(y); });
        const double exact = x / y;
        if (std::abs(y) > 16384.0) {
            ASSERT_TRUE(bounds.is_anything()) << x << " / " << y;
        } else if (std::abs(exact) <= 60000.0) {
            expect_rule(bounds, exact, 2.5 * halves::gap(exact),
                        std::to_string(x) + " / " + std::to_string(y));
        }
    }
}

struct Function {
    const char* name;
    Interval (*interval)(const Interval&);
    double (*exact)(double);
    double (*error)(double x, double exact);
    double low;
    double high;
};

double relative(double ulps, double exact) {
    return ulps * halves::gap(exact);
}

const Function functions[] = {
    {"inversesqrt", inversesqrt, [](double x) { return 1 / std::sqrt(x); },
     [](double, double y) { return relative(2, y); }, 0x1p-14, 65504},
    {"exp", exp, [](double x) { return std::exp(x); },
     [](double x, double y) { return relative(1 + 2 * std::abs(x), y); }, -9, 11},
    {"exp2", exp2, [](double x) { return std::exp2(x); },
     [](double x, double y) { return relative(1 + 2 * std::abs(x), y); }, -13, 15},
    {"log", log, [](double x) { return std::log(x); },
     [](double x, double y) { return x >= 0.5 && x <= 2 ? 0x1p-7 : relative(3, y); }, 0x1p-14, 65504},
    {"log2", log2, [](double x) { return std::log2(x); },
     [](double x, double y) { return x >= 0.5 && x <= 2 ? 0x1p-7 : relative(3, y); }, 0x1p-14, 65504},
    {"sin", sin, [](double x) { return std::sin(x); }, [](double, double) { return 0x1p-7; }, -3.14, 3.14},
    {"cos", cos, [](double x) { return std::cos(x); }, [](double, double) { return 0x1p-7; }, -3.14, 3.14},
    {"atan", [](const Interval& x) { return atan(x); }, [](double x) { return std::atan(x); },
     [](double, double y) { return relative(5, y); }, -65504, 65504},
};

TEST(IntervalHalf, FunctionsErrAsTheirRulesSay) {
    for (const Function& function : functions) {
        for (const double x : halves::finite()) {
            if (x < function.low || x > function.high || !is_normal(x)) continue;
            const double exact = function.exact(x);
            const Bounds bounds = in_half([&] { return function.interval(half(x)); });
            const double error = function.error(x, exact);
            const std::string what = std::string(function.name) + "(" + std::to_string(x) + ")";
            const bool sinusoid = std::string(function.name) == "sin" || std::string(function.name) == "cos";
            if (sinusoid && std::abs(exact) + error > 1.0) {
                ASSERT_TRUE(bounds.contains(exact)) << what;
                ASSERT_TRUE(bounds.low >= -1.0 && bounds.high <= 1.0) << what;
            } else {
                expect_rule(bounds, exact, error, what);
            }
        }
    }
}

TEST(IntervalHalf, RootsHoldTheExactRoot) {
    for (const double x : halves::finite()) {
        if (!(x > 0.0) || !is_normal(x)) continue;
        const Bounds bounds = in_half([&] { return sqrt(half(x)); });
        const double exact = std::sqrt(x);
        ASSERT_TRUE(bounds.contains(exact)) << x;
        ASSERT_LE(bounds.high - bounds.low, 13.0 * halves::gap(exact) * 2.0) << x;
    }
}

TEST(IntervalHalf, IntegersAndPartsAreExact) {
    for (const double x : halves::finite()) {
        if (!is_normal(x)) continue;
        ASSERT_EQ(in_half([&] { return floor(half(x)); }), Bounds::point(std::floor(x)));
        ASSERT_EQ(in_half([&] { return ceil(half(x)); }), Bounds::point(std::ceil(x)));
        ASSERT_EQ(in_half([&] { return trunc(half(x)); }), Bounds::point(std::trunc(x)));
        ASSERT_EQ(in_half([&] { return abs(half(x)); }), Bounds::point(std::abs(x)));
        ASSERT_EQ(in_half([&] { return fract(half(x)); }), rounded(x - std::floor(x))) << x;
    }
}

}  // namespace gloam::numeric::interval_half_test
