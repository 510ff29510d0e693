// SPDX-License-Identifier: MIT
#include "report/accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gloam::report {
namespace accuracy_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

CheckRow row(const std::string& equation, const std::string& variant, double fraction) {
    return {.equation = equation,
            .variant = variant,
            .inputs = 1000,
            .max_ulp = 2.0,
            .max_abs = 1e-7,
            .budget_fraction = fraction,
            .budget = {.ulp = 4, .text = "4 ulp"}};
}

CheckRow strict(const std::string& equation, double width, double guaranteed_ulp) {
    CheckRow by_rules = row(equation, "strict", 0.2);
    by_rules.verdict = "rules";
    by_rules.width_fraction = width;
    by_rules.guarantee = GuaranteeNumbers{.ulp = guaranteed_ulp, .absolute = 3e-7, .fraction = 1.0};
    return by_rules;
}

CheckReport device(const std::string& name, std::vector<CheckRow> rows) {
    return {.device = {.name = name, .driver = "driver of " + name}, .rows = std::move(rows)};
}

TEST(Accuracy, TakesTheWorstVariantThatIsJudgedByTheBudget) {
    const std::string text = to_accuracy_markdown(
        {device("one", {row("E", "shipped", 0.25), row("E", "optimized", 0.5), strict("E", 0.9, 7.5)})});
    EXPECT_THAT(text, HasSubstr("| E | 4 ulp | 3.0e-07, 7.5 ulp | 0.50 optimized |"));
}

TEST(Accuracy, SaysWhereNothingIsPromised) {
    CheckRow open = strict("E", 0.5, 2);
    open.unbounded = 250;
    EXPECT_THAT(to_accuracy_markdown({device("one", {open})}), HasSubstr("3.0e-07, 2 ulp; 25 % open"));
}

TEST(Accuracy, HasAColumnForEachDriverAndATableForEach) {
    const std::string text =
        to_accuracy_markdown({device("one", {row("E", "shipped", 0.25)}),
                              device("two", {row("E", "shipped", 0.75), strict("E", 0.4, 2)})});
    EXPECT_THAT(text, AllOf(HasSubstr("| equation | documented | any driver | one | two |"),
                            HasSubstr("| 0.25 shipped | 0.75 shipped |"), HasSubstr("## one (driver of one)"),
                            HasSubstr("## two (driver of two)"), HasSubstr("| E | 0.75 | 0.4 |")));
}

TEST(Accuracy, FailuresStandOut) {
    CheckRow outside = row("E", "shipped", 3.0);
    outside.outside = 17;
    CheckRow crashed{.equation = "F", .variant = "shipped", .error = "gone", .reason = Reason::crash};
    const std::string text = to_accuracy_markdown({device("one", {outside, crashed})});
    EXPECT_THAT(text, AllOf(HasSubstr("**17 of 1000 outside**"), HasSubstr("| F | **crash** |")));
}

TEST(Accuracy, TellsWhatConstantFoldingChanged) {
    CheckRow folded = row("E", "literals", 0.25);
    folded.differs = 3;
    EXPECT_THAT(to_accuracy_markdown({device("one", {folded})}), HasSubstr("0.25 (3 differ)"));
}

TEST(Accuracy, AFunctionThatIsJudgedByTheRulesAloneDocumentsNothing) {
    CheckRow alone = strict("E", 0.5, 2);
    alone.variant = "shipped";
    EXPECT_THAT(to_accuracy_markdown({device("one", {alone})}), HasSubstr("| E | Vulkan's rules |"));
}

TEST(Accuracy, WithoutAStrictRunThereIsNoGuarantee) {
    EXPECT_THAT(to_accuracy_markdown({device("one", {row("E", "shipped", 0.25)})}),
                AllOf(HasSubstr("not calculated"), Not(HasSubstr("open"))));
}

}  // namespace accuracy_test
}  // namespace gloam::report
