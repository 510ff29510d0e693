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
    by_rules.guarantee = {.ulp = guaranteed_ulp, .absolute = 3e-7, .fraction = guaranteed_ulp / 4};
    return by_rules;
}

CheckReport device(const std::string& name, std::vector<check::Answer> rows) {
    return {.device = {.name = name, .driver = "driver of " + name}, .rows = std::move(rows)};
}

TEST(Accuracy, TakesTheWorstVariantThatIsJudgedByTheBudget) {
    const std::vector<CheckReport> reports{
        device("one", {row("E", "shipped", 0.25), row("E", "optimized", 0.5), strict("E", 0.9, 7.5)})};
    EXPECT_THAT(to_accuracy_markdown(reports),
                HasSubstr("| E | 4 ulp | 3.0e-07, 7.5 ulp | 0.50 optimized |"));
    const std::vector<EquationAccuracy> all = accuracies(reports);
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all.front().measured.at(0).value().variant, "optimized");
}

TEST(Accuracy, SaysWhereNothingIsPromised) {
    check::Answer open = strict("E", 0.5, 2);
    open.unbounded = 125;
    EXPECT_THAT(to_accuracy_markdown({device("one", {open, row("E", "shipped", 0.1)})}),
                HasSubstr("3.0e-07, 2 ulp; 25 % open"));
}

TEST(Accuracy, CountsEquationsByThePartOfTheirErrorOnEachDriver) {
    const std::string text = to_accuracy_markdown(
        {device("one", {row("A", "shipped", 0.0), row("B", "shipped", 0.25), row("C", "shipped", 0.3)}),
         device("two", {row("A", "shipped", 0.75), row("B", "shipped", 1.5), strict("C", 0.4, 2)})});
    EXPECT_THAT(text,
                AllOf(HasSubstr("3 equations."), HasSubstr("| part of the documented error | one | two |"),
                      HasSubstr("| nothing: exact | 1 | 0 |"), HasSubstr("| up to a quarter | 1 | 0 |"),
                      HasSubstr("| up to a half | 1 | 0 |"), HasSubstr("| up to all of it | 0 | 1 |"),
                      HasSubstr("| more: outside | 0 | 1 |"), HasSubstr("alone | 0 | 1 |")));
}

TEST(Accuracy, TwoVersionsOfADriverAreToldApart) {
    std::vector<CheckReport> reports{device("one", {row("A", "shipped", 0.5)}),
                                     device("one", {row("A", "shipped", 0.5)})};
    reports[1].device.driver = "newer";
    EXPECT_THAT(to_accuracy_markdown(reports), HasSubstr("| one (driver of one) | one (newer) |"));
}

TEST(Accuracy, ListsTheTenThatUseMost) {
    std::vector<check::Answer> rows;
    for (int i = 0; i < 20; ++i) rows.push_back(row("E" + std::to_string(i), "shipped", 0.04 * i));
    const std::string text = to_accuracy_markdown({device("one", rows)});
    EXPECT_THAT(text, AllOf(HasSubstr("| E19 | 4 ulp | not calculated | 0.76 shipped |"),
                            HasSubstr("| E10 |"), Not(HasSubstr("| E9 |"))));
}

TEST(Accuracy, ListsEveryCheckThatFailed) {
    check::Answer outside = row("E", "shipped", 3.0);
    ordinary(outside).outside = 17;
    check::Answer strictly = outside;
    strictly.variant = "strict";
    check::Answer crashed{
        .equation = "F", .variant = "shipped", .error = "gone", .reason = check::Reason::crash};
    const std::string text = to_accuracy_markdown({device("one", {outside, strictly, crashed})});
    EXPECT_THAT(text, AllOf(HasSubstr("| E | one | shipped 17 of 1000, strict 17 of 1000 |"),
                            HasSubstr("| F | one | shipped crash |")));
    EXPECT_THAT(to_accuracy_markdown({device("one", {row("E", "shipped", 0.1)})}),
                HasSubstr("No check failed."));
}

TEST(Accuracy, CountsTheChecksOfEachVariant) {
    check::Answer outside = row("E", "hlsl", 3.0);
    ordinary(outside).outside = 17;
    const std::string text = to_accuracy_markdown(
        {device("one", {row("E", "shipped", 0.5), row("F", "shipped", 0.5), outside, row("F", "hlsl", 0.5)}),
         device("two", {row("E", "shipped", 0.5)})});
    EXPECT_THAT(text, AllOf(HasSubstr("\n| checks passed in the variant | one | two |\n"),
                            HasSubstr("\n| shipped | 2 of 2 | 1 of 1 |\n| hlsl | 1 of 2 | 0 of 0 |\n")));
}

TEST(Accuracy, CountsWhatTheRulesAloneKeep) {
    EXPECT_THAT(to_accuracy_markdown(
                    {device("one", {strict("A", 0.5, 2), strict("B", 0.5, 6), strict("C", 0.5, 4)})}),
                HasSubstr("Of 3 functions with a documented error, 2 keep it"));
}

TEST(Accuracy, AFunctionThatIsJudgedByTheRulesAloneDocumentsNothing) {
    check::Answer alone = strict("E", 0.5, 2);
    alone.variant = "shipped";
    const PageTable table = accuracy_table({device("one", {alone})});
    ASSERT_EQ(table.rows.size(), 1U);
    EXPECT_EQ(table.rows[0][1].text, "Vulkan's rules");
    EXPECT_EQ(table.rows[0].size(), table.columns.size());
}

TEST(Accuracy, TheTableOfAllHasEveryEquationAndDriver) {
    const PageTable table =
        accuracy_table({device("one", {row("A", "shipped", 0.25), strict("A", 0.5, 2)}),
                        device("two", {row("A", "shipped", 0.75), row("B", "shipped", 0.5)})});
    ASSERT_EQ(table.rows.size(), 2U);
    const auto texts = [](const std::vector<PageCell>& cells) {
        std::vector<std::string> all;
        for (const PageCell& cell : cells) all.push_back(cell.text);
        return all;
    };
    EXPECT_THAT(texts(table.rows[0]),
                testing::ElementsAre("A", "4 ulp", "3.0e-07", "2", "0", "0.25 shipped", "0.75 shipped"));
    EXPECT_THAT(texts(table.rows[1]), testing::ElementsAre("B", "4 ulp", "-", "-", "-", "-", "0.50 shipped"));
}

}  // namespace accuracy_test
}  // namespace gloam::report
