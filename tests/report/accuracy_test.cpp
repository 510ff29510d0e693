// SPDX-License-Identifier: MIT
#include "report/accuracy.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/rows.hpp"

namespace gloam::report {
namespace accuracy_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

check::Answer row(const std::string& equation, const std::string& variant, double fraction) {
    check::Answer answer{.equation = equation,
                         .variant = variant,
                         .budget = {.ulp = 4},
                         .max_ulp = 2.0,
                         .max_absolute = 1e-7,
                         .budget_fraction = fraction};
    ordinary(answer).inputs = 1000;
    return answer;
}

check::Answer strict(const std::string& equation, double width, double guaranteed_ulp) {
    check::Answer by_rules = row(equation, "strict", 0.2);
    by_rules.verdict = check::Verdict::rules;
    by_rules.fraction = width;
    by_rules.bounded = 500;
    by_rules.guarantee = {.ulp = guaranteed_ulp, .absolute = 3e-7, .fraction = 1.0};
    return by_rules;
}

CheckReport device(const std::string& name, std::vector<check::Answer> rows) {
    return {.device = {.name = name, .driver = "driver of " + name}, .rows = std::move(rows)};
}

TEST(Accuracy, TakesTheWorstVariantThatIsJudgedByTheBudget) {
    const std::string text = to_accuracy_markdown(
        {device("one", {row("E", "shipped", 0.25), row("E", "optimized", 0.5), strict("E", 0.9, 7.5)})});
    EXPECT_THAT(text, HasSubstr("| E | 4 ulp | 3.0e-07, 7.5 ulp | 0.50 optimized |"));
}

TEST(Accuracy, SaysWhereNothingIsPromised) {
    check::Answer open = strict("E", 0.5, 2);
    open.unbounded = 125;
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
    check::Answer outside = row("E", "shipped", 3.0);
    ordinary(outside).outside = 17;
    check::Answer crashed{
        .equation = "F", .variant = "shipped", .error = "gone", .reason = check::Reason::crash};
    const std::string text = to_accuracy_markdown({device("one", {outside, crashed})});
    EXPECT_THAT(text, AllOf(HasSubstr("**17 of 1000 outside**"), HasSubstr("| F | **crash** |")));
}

TEST(Accuracy, TellsWhatConstantFoldingChanged) {
    check::Answer folded = row("E", "literals", 0.25);
    folded.differs = 3;
    EXPECT_THAT(to_accuracy_markdown({device("one", {folded})}), HasSubstr("0.25 (3 differ)"));
}

TEST(Accuracy, AFunctionThatIsJudgedByTheRulesAloneDocumentsNothing) {
    check::Answer alone = strict("E", 0.5, 2);
    alone.variant = "shipped";
    EXPECT_THAT(to_accuracy_markdown({device("one", {alone})}), HasSubstr("| E | Vulkan's rules |"));
}

TEST(Accuracy, WithoutAStrictRunThereIsNoGuarantee) {
    EXPECT_THAT(to_accuracy_markdown({device("one", {row("E", "shipped", 0.25)})}),
                AllOf(HasSubstr("not calculated"), Not(HasSubstr("open"))));
}

}  // namespace accuracy_test
}  // namespace gloam::report
