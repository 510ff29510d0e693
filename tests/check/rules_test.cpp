// SPDX-License-Identifier: MIT
// Verdicts by Vulkan's precision rules: what they permit passes, anything beyond fails, and nobody chose a
// number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/lab.hpp"

namespace gloam::check {
namespace rules_test {

using testing::AllOf;
using testing::HasSubstr;

constexpr auto quotient = [](auto x, auto y) { return x / y; };

class RulesTest : public testing::Test {
  protected:
    template <class Signature, class Reference>
    Result judged(const std::string& function, Reference reference, const Domain& domain) {
        return compare_by_rules<Signature>(lab, "rules.glsl", function, reference, domain, {.inputs = 8192});
    }

    Lab lab = test::make_lab(FIXTURES);
    const Domain pairs{signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e3)};
};

TEST_F(RulesTest, ARightFunctionPassesAndUsesAPartOfTheWidth) {
    const Result result = judged<float(float, float)>("quotient", quotient, pairs);
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_GT(result.census.fraction, 0.0);
    EXPECT_LE(result.census.fraction, 1.0);
    EXPECT_EQ(result.census.unbounded, 0U);
    EXPECT_GT(result.census.guarantee.ulp, 2.4);
    EXPECT_LE(result.census.guarantee.ulp, 5.0);
}

TEST_F(RulesTest, AQuotientMayBeTwoUlpOffAndNotFour) {
    const auto off = [](auto x, auto y, int) { return x / y; };
    const auto at = [&](int ulps) {
        return Domain{log_uniform(1e-3, 1e3), log_uniform(1e-3, 1e3), integers(ulps, ulps)};
    };
    EXPECT_TRUE((judged<float(float, float, int)>("quotient_off", off, at(2)).passed()));
    EXPECT_TRUE((judged<float(float, float, int)>("quotient_off", off, at(-1)).passed()));
    const Result far = judged<float(float, float, int)>("quotient_off", off, at(4));
    EXPECT_EQ(far.census.outside(), far.census.inputs()) << far;
    EXPECT_FALSE((judged<float(float, float, int)>("quotient_off", off, at(-4)).passed()));
}

TEST_F(RulesTest, ADifferenceHasNoSlackButItsRounding) {
    const auto difference = [](auto x, auto y) { return x - y; };
    EXPECT_TRUE((judged<float(float, float)>("difference", difference, pairs).passed()));
    const Result off = judged<float(float, float)>("difference_off", difference, pairs);
    EXPECT_GT(off.census.outside(), off.census.inputs() / 2) << off;
}

TEST_F(RulesTest, AnUndecidedBranchPermitsBothSides) {
    const auto branch = [](auto x) {
        using T = decltype(x);
        const T third = x / T(3);
        if (third > T(1)) return third - T(1);
        return T(0);
    };
    const Domain around{uniform(0, 9).and_near({3.0})};
    EXPECT_TRUE((judged<float(float)>("branch", branch, around).passed()));
    const Result wrong = judged<float(float)>("branch_wrong", branch, around);
    EXPECT_FALSE(wrong.passed());
    ASSERT_TRUE(wrong.census.worst);
    EXPECT_GT(from_word<float>(wrong.census.worst->inputs[0]), 4.0F);
}

TEST_F(RulesTest, IntegersMustBeOneOfThoseInReach) {
    const auto whole = [](auto x) { return to_int(floor(x / decltype(x)(3))); };
    const auto any = [whole](auto x) {
        if constexpr (std::same_as<decltype(x), double>) {
            return static_cast<int>(std::floor(x / 3));
        } else {
            return whole(x);
        }
    };
    const Domain domain{uniform(0, 300).and_near({3.0, 6.0, 99.0})};
    EXPECT_TRUE((judged<int(float)>("whole", any, domain).passed()));
    EXPECT_FALSE((judged<int(float)>("whole_wrong", any, domain).passed()));
}

TEST_F(RulesTest, WhatIsUndefinedIsCountedNotJudged) {
    const auto sine = [](auto x) {
        using std::sin;
        return sin(x);
    };
    const Result result = judged<float(float)>("sine", sine, {uniform(-6, 6)});
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_GT(result.census.unbounded, result.census.inputs() / 3);
    ASSERT_TRUE(result.census.first_unbounded);
    EXPECT_GT(std::abs(from_word<float>(result.census.first_unbounded->inputs[0])), 3.14F);
}

TEST_F(RulesTest, AFailureTellsWhatWasPermitted) {
    const auto off = [](auto x, auto y, int) { return x / y; };
    const Result result =
        judged<float(float, float, int)>("quotient_off", off, {constant(6.0F), constant(2.0F), constant(9)});
    EXPECT_THAT(describe(result),
                AllOf(HasSubstr("permitted [2.99999"), HasSubstr("Vulkan's precision rules")));
}

TEST_F(RulesTest, HalfPrecisionHasItsOwnRules) {
    const auto off = [](auto x, auto y, int) { return x / y; };
    const Domain domain{log_uniform(0.1, 10), log_uniform(0.1, 10), integers(1000, 1000)};
    RunOptions options{.inputs = 1024, .format = numeric::float16};
    EXPECT_TRUE(
        (compare_by_rules<float(float, float, int)>(lab, "rules.glsl", "quotient_off", off, domain, options)
             .passed()));
    options.format = numeric::float32;
    EXPECT_FALSE(
        (compare_by_rules<float(float, float, int)>(lab, "rules.glsl", "quotient_off", off, domain, options)
             .passed()));
}

TEST(Rules, AFunctionOfYourOwn) {
    const auto reciprocal = [](auto x) { return decltype(x)(1) / x; };
    const Lab strict({.include_roots = {FIXTURES}, .variant = shader::variant("strict")});
    const Result result =
        compare_by_rules<float(float)>(strict, "rules.glsl", "reciprocal", reciprocal, {uniform(1, 2)});
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_LE(result.census.guarantee.ulp, 4.0);
}

TEST_F(RulesTest, AReferenceInDoubleAloneCannotJudge) {
    Case check_case{
        .file = "rules.glsl",
        .function = "quotient",
        .signature = SignatureOf<float(float, float)>::describe(),
        .domain = pairs,
        .reference = make_reference<float(float, float)>([](double x, double y) { return x / y; })};
    EXPECT_THAT([&] { (void)run(lab, check_case, {.inputs = 16, .verdict = Verdict::rules}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("takes intervals")));
}

TEST_F(RulesTest, TheVariantDecidesWhatIsAsked) {
    const Case check_case{.file = "rules.glsl",
                          .function = "quotient",
                          .signature = SignatureOf<float(float, float)>::describe(),
                          .domain = pairs,
                          .reference = make_reference<float(float, float)>(quotient),
                          .budget = {.ulp = 2.5},
                          .permitted = make_permission<float(float, float)>(quotient)};
    const auto verdict_in = [&](const char* variant) {
        const Lab other({.device = lab.options().device,
                         .validation = true,
                         .include_roots = lab.options().include_roots,
                         .variant = shader::variant(variant)});
        const Result result = run(other, check_case, {.inputs = 512});
        EXPECT_TRUE(result.passed()) << variant << result;
        EXPECT_EQ(result.differs, 0U) << variant;
        EXPECT_EQ(result.census.inputs(),
                  other.options().variant.constants == shader::Variant::Constants::none ? 512U : 64U);
        return result.verdict;
    };
    for (const char* variant :
         {"shipped", "optimized", "small", "round_trip", "literals", "specialization"}) {
        EXPECT_EQ(verdict_in(variant), Verdict::budget) << variant;
    }
    for (const char* variant : {"strict", "relaxed"})
        EXPECT_EQ(verdict_in(variant), Verdict::rules) << variant;
}

TEST(FractionOfWidth, IsMeasuredFromTheExactResultToItsSide) {
    const numeric::Bounds bounds{1.0, 4.0, false};
    EXPECT_EQ(fraction_of_width(2.0, 2.0, bounds), 0.0);
    EXPECT_EQ(fraction_of_width(3.0, 2.0, bounds), 0.5);
    EXPECT_EQ(fraction_of_width(1.5, 2.0, bounds), 0.5);
    EXPECT_EQ(fraction_of_width(5.0, 2.0, bounds), 1.5);
    EXPECT_EQ(fraction_of_width(1.0, 9.0, numeric::Bounds::point(1.0)), 0.0)
        << "inside, wherever the exact result is";
    EXPECT_TRUE(std::isinf(fraction_of_width(2.0, 1.0, numeric::Bounds::point(1.0))));
    EXPECT_TRUE(std::isinf(fraction_of_width(std::nan(""), 2.0, bounds)));
    EXPECT_EQ(fraction_of_width(std::nan(""), 2.0, {1.0, 4.0, true}), 0.0);
    EXPECT_TRUE(std::isinf(fraction_of_width(2.0, std::nan(""), numeric::Bounds::only_nan())));
}

}  // namespace rules_test
}  // namespace gloam::check
