// SPDX-License-Identifier: MIT
#include "report/check_report.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "report/check_page.hpp"
#include "report/rows.hpp"

namespace gloam::report {
namespace check_report_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

check::Answer crashed_row() {
    check::Answer row = passing_row("EQ-3");
    row.error = "ended by signal 9 (Killed)\x1b[0m";
    row.reason = check::Reason::crash;
    return row;
}

auto says(const std::string& text) {
    return testing::ThrowsMessage<std::runtime_error>(HasSubstr(text));
}

TEST(CheckReport, OneDeviceIsAnObjectSeveralAnArrayAndBothAreReadBack) {
    const CheckReport a = report_of("A", {failing_row(), passing_row("EQ-2")});
    const CheckReport b = report_of("B", {crashed_row()});
    EXPECT_EQ(to_json({a}).front(), '{');
    EXPECT_EQ(to_json({a, b}).front(), '[');
    for (const std::vector<CheckReport>& reports : {std::vector{a}, std::vector{a, b}}) {
        const std::vector<CheckReport> back = reports_from_json(to_json(reports));
        EXPECT_EQ(to_json(back), to_json(reports));
        EXPECT_TRUE(back.front().device.preserves_signed_zero_inf_nan);
        EXPECT_FALSE(back.front().device.flushes_denormals);
        EXPECT_EQ(back.front().count(check::Outcome::failed), 1U);
    }
}

TEST(CheckReport, ADeviceTravelsAlone) {
    const DeviceSummary device = report_of("A", {}).device;
    EXPECT_EQ(to_json(device_from_json(to_json(device))), to_json(device));
    EXPECT_EQ(name_of(device), "A (driver 1.2)");
    EXPECT_THAT([] { (void)device_from_json("{}"); }, says("float_controls: expected this field"));
}

TEST(CheckReport, ForeignTextsAreNamed) {
    EXPECT_THAT([] { (void)reports_from_json("{\"a\": 1}"); }, says("device: expected this field"));
    EXPECT_THAT([] { (void)reports_from_json("3"); }, says("expected an object"));
    EXPECT_THAT([] { (void)reports_from_json(""); }, says("no JSON: parse error at line 1"));
    std::string text = to_json({report_of("A", {passing_row("EQ-2"), failing_row()})});
    text.replace(text.find("\"inputs\": 100"), 13, "\"inputs\": null");
    EXPECT_THAT([&] { (void)reports_from_json(text); },
                says("results[1].inputs: expected a count, found null"));
}

TEST(CheckReport, JunitTellsFailuresFromErrors) {
    const std::string xml =
        to_junit({report_of("A & B", {failing_row(), passing_row("EQ-2"), crashed_row()})});
    EXPECT_THAT(
        xml,
        HasSubstr("<testsuite name=\"A &amp; B\" tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\">"));
    EXPECT_THAT(xml, HasSubstr("<failure type=\"fault\" message=\"line one&#10;line &lt;two&gt;"));
    EXPECT_THAT(xml, HasSubstr("<error type=\"crash\" message=\"ended by signal 9 (Killed)?[0m\""));
    EXPECT_THAT(xml, HasSubstr("name=\"EQ-2 shipped\" time=\"0.000\"/>"));
    EXPECT_THAT(xml, Not(HasSubstr("\x1b")));
}

TEST(CheckReport, WhatWasNotJudgedIsCountedApart) {
    const std::vector<CheckReport> reports{
        report_of("A", {failing_row(), passing_row("EQ-2"), unjudged_row("EQ-3"), unsupported_row("EQ-4")})};
    EXPECT_EQ(to_text(counts_of(reports)), "4 checks, 1 failed, 2 not judged");
    EXPECT_THAT(to_junit(reports), AllOf(HasSubstr("failures=\"1\" errors=\"0\" skipped=\"2\">"),
                                         HasSubstr("<skipped message=\"the device promises nothing"),
                                         HasSubstr("<skipped message=\"h is no GLSL 3.30\"/>")));
    const std::string page = to_check_page(reports);
    EXPECT_THAT(page,
                AllOf(HasSubstr("4 checks, 1 failed, 2 not judged"), HasSubstr(">not judged</button>")));
}

TEST(CheckReport, TheExitStatusSaysWhetherAnythingWasJudged) {
    const auto status = [](std::vector<check::Answer> rows) {
        return counts_of({report_of("A", std::move(rows))}).exit_status();
    };
    EXPECT_EQ(status({passing_row("EQ-1"), unjudged_row("EQ-2")}), 0);
    EXPECT_EQ(status({failing_row(), unjudged_row("EQ-2")}), 1);
    EXPECT_EQ(status({unsupported_row("EQ-1"), unjudged_row("EQ-2")}), 2);
    EXPECT_EQ(status({}), 0) << "a part of the checks without any";
}

TEST(CheckReport, TheTableSaysWhatBecameOfEachRow) {
    EXPECT_THAT(table_line(passing_row("EQ-2")), HasSubstr("ok"));
    EXPECT_THAT(table_line(failing_row()), HasSubstr("3 outside, reads outside its image"));
    EXPECT_THAT(table_line(crashed_row()), HasSubstr("crash"));
    check::Answer row = crashed_row();
    row.reason = check::Reason::error;
    EXPECT_THAT(table_line(row), HasSubstr("could not run"));
    EXPECT_THAT(table_line(unjudged_row("EQ-3")), HasSubstr("not judged; the device promises nothing"));
    EXPECT_THAT(table_line(unsupported_row("EQ-4")), HasSubstr("unsupported"));
}

// By the rules, an overflow may be right. By a budget it never is.
TEST(CheckReport, AnInfiniteErrorIsSaidToBePermittedWhereItIs) {
    check::Answer row = passing_row("EQ-2");
    row.max_ulp = std::numeric_limits<double>::infinity();
    EXPECT_THAT(table_line(row), HasSubstr(" inf "));
    row.verdict = check::Verdict::rules;
    EXPECT_THAT(table_line(row), AllOf(HasSubstr(" permitted "), Not(HasSubstr("inf"))));
    ordinary(row).outside = 1;
    EXPECT_THAT(table_line(row), HasSubstr(" inf "));
}

// A verdict that says less than "ok" does not read as if it said all.
TEST(CheckReport, WhatWasNotJudgedIsRemarked) {
    check::Answer row = passing_row("EQ-2");
    row.classes.back() = {.inputs = 10, .recorded = 10};
    ordinary(row).open = 3;
    EXPECT_EQ(verdict_of(row), "ok");
    EXPECT_EQ(remark_on(row), "any result would pass for 3 of 60; not promised: nan");
    EXPECT_THAT(table_line(row), testing::EndsWith(" ok; " + remark_on(row)));
    EXPECT_EQ(remark_on(passing_row("EQ-2")), "");
    EXPECT_EQ(remark_on(unsupported_row("EQ-4")), "h is no GLSL 3.30");
}

}  // namespace check_report_test
}  // namespace gloam::report
