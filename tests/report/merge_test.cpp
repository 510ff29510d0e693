// SPDX-License-Identifier: MIT
#include "report/merge.hpp"

#include <gmock/gmock.h>

#include "report/matrix.hpp"
#include "report/rows.hpp"

namespace gloam::report {
namespace merge_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> equations_of(const CheckReport& report) {
    std::vector<std::string> names;
    for (const check::Answer& row : report.rows) names.push_back(row.equation + " " + row.variant);
    return names;
}

check::Answer crashed(const std::string& equation) {
    check::Answer row = passing_row(equation);
    row.error = "ended";
    row.reason = check::Reason::crash;
    return row;
}

TEST(Merge, ShardsBecomeTheWhole) {
    const MergedReports merged =
        merge({{"a", report_of("A", {passing_row("EQ-1"), passing_row("EQ-3")})},
               {"b", report_of("A", {passing_row("EQ-2", "strict"), passing_row("EQ-2")})}});
    EXPECT_THAT(merged.conflicts, IsEmpty());
    ASSERT_EQ(merged.reports.size(), 1U);
    EXPECT_THAT(equations_of(merged.reports[0]),
                ElementsAre("EQ-1 shipped", "EQ-2 shipped", "EQ-2 strict", "EQ-3 shipped"));
}

TEST(Merge, DriversAreToldApartByAllTheySay) {
    CheckReport newer = report_of("A", {passing_row("EQ-1")});
    newer.device.driver = "driver 1.3";
    const MergedReports merged = merge({{"a", report_of("A", {passing_row("EQ-1")})},
                                        {"b", newer},
                                        {"c", report_of("B", {crashed("EQ-1")})}});
    ASSERT_EQ(merged.reports.size(), 3U);
    EXPECT_THAT(merged.conflicts, IsEmpty());
    EXPECT_EQ(merged.reports[1].device.driver, "driver 1.3");
    EXPECT_EQ(merged.reports[2].count(check::Outcome::failed), 1U);
}

TEST(Merge, TheSameRowTwiceIsOneWhateverItsTime) {
    check::Answer later = passing_row("EQ-1");
    later.seconds = 9.0;
    const MergedReports merged =
        merge({{"a", report_of("A", {passing_row("EQ-1")})}, {"b", report_of("A", {later})}});
    EXPECT_THAT(merged.conflicts, IsEmpty());
    EXPECT_EQ(merged.reports.at(0).rows.size(), 1U);
}

TEST(Merge, OfRowsThatDisagreeTheWorseIsKeptAndItIsSaid) {
    check::Answer little = passing_row("EQ-1");
    ordinary(little).outside = 1;
    check::Answer larger_error = passing_row("EQ-1");
    larger_error.budget_fraction = 0.9;
    check::Answer fault = passing_row("EQ-1");
    fault.fault = "pixel";
    const std::vector<check::Answer> ascending{passing_row("EQ-1"), larger_error, little, fault,
                                               crashed("EQ-1")};
    for (std::size_t i = 1; i < ascending.size(); ++i) {
        for (const bool swapped : {false, true}) {
            const check::Answer& first = ascending[swapped ? i : i - 1];
            const check::Answer& second = ascending[swapped ? i - 1 : i];
            const MergedReports merged =
                merge({{"a.json", report_of("A", {first})}, {"b.json", report_of("A", {second})}});
            ASSERT_EQ(merged.reports.at(0).rows.size(), 1U);
            EXPECT_EQ(to_json(merged.reports[0].rows[0]), to_json(ascending[i])) << i;
            ASSERT_EQ(merged.conflicts.size(), 1U);
            EXPECT_THAT(merged.conflicts[0], HasSubstr("EQ-1 shipped on A (driver 1.2): a.json says "));
            EXPECT_THAT(merged.conflicts[0], HasSubstr("b.json says "));
        }
    }
}

TEST(Merge, NothingIsNothing) {
    EXPECT_THAT(merge({}).reports, IsEmpty());
}

std::vector<CheckReport> two_drivers() {
    check::Answer lost{
        .equation = "device", .error = "the device cannot be opened", .reason = check::Reason::crash};
    check::Answer strict = passing_row("EQ-2", "strict");
    strict.verdict = check::Verdict::rules;
    strict.fraction = 0.5;
    check::Answer wrong = passing_row("EQ-2");
    ordinary(wrong).outside = 3;
    return {report_of("A", {passing_row("EQ-1"), strict}), report_of("B|C", {crashed("EQ-1"), wrong, lost})};
}

TEST(Matrix, HasALineForEachEquationAndAColumnForEachDriverAndVariant) {
    EXPECT_EQ(to_matrix(two_drivers()),
              "driver 1: A (driver 1.2)\n"
              "driver 2: B|C (driver 1.2)\n"
              "\n"
              "equation  1 shipped  1 strict  2 shipped\n"
              "EQ-1      ok 0.25    -         crash\n"
              "EQ-2      -          ok 0.50   FAIL 3/50\n"
              "\n"
              "ok 0.85: passed, the largest error is 0.85 of what is allowed. FAIL 3/100: 3 of 100 inputs "
              "are outside.\n"
              "not judged, unsupported: no verdict. Another reason, \"hang\" say: the check did not end. "
              "-: it was not run.\n"
              "\n"
              "driver 1: 2 checks, 0 failed; worst error 0.5 of what is allowed: EQ-2 strict\n"
              "driver 2: 3 checks, 3 failed; failed: 2 crash, 1 outside; worst error 0.25 of what is "
              "allowed: EQ-2 shipped; the device cannot be opened\n");
}

TEST(Matrix, WhatWasNotJudgedIsNotCountedAsOk) {
    const std::string text =
        to_matrix({report_of("A", {passing_row("EQ-1"), unjudged_row("EQ-2"), unsupported_row("EQ-3")})});
    EXPECT_THAT(text, HasSubstr("EQ-2      not judged\n"));
    EXPECT_THAT(text, HasSubstr("EQ-3      unsupported\n"));
    EXPECT_THAT(text, HasSubstr("driver 1: 3 checks, 0 failed, 2 not judged; worst error 0.25"));
}

TEST(Matrix, MarkdownHoldsTheSame) {
    const std::string page = to_matrix_markdown(two_drivers());
    EXPECT_THAT(page,
                HasSubstr("| equation | 1 shipped | 1 strict | 2 shipped |\n| --- | --- | --- | --- |\n"));
    EXPECT_THAT(page, HasSubstr("| EQ-2 | - | ok 0.50 | FAIL 3/50 |\n"));
    EXPECT_THAT(page, HasSubstr("| 2 | B\\|C (driver 1.2) | 3 checks, 3 failed"));
}

TEST(Matrix, OneDriverNeedsNoNumbers) {
    EXPECT_THAT(to_matrix({report_of("A", {passing_row("EQ-1")})}), HasSubstr("equation  shipped\n"));
}

}  // namespace merge_test
}  // namespace gloam::report
