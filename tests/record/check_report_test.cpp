// SPDX-License-Identifier: MIT
#include "record/check_report.hpp"
#include "record/answer_json.hpp"
#include "record/rows.hpp"

namespace gloam::record::check_report_test {

using testing::_;

judge::Answer crashed(const std::string& equation) {
    judge::Answer row = passing_row(equation);
    row.error = "ended by signal 9 (Killed)\x1b[0m";
    row.reason = judge::Reason::crash;
    return row;
}

TEST(CheckReport, OneDeviceIsAnObjectSeveralAnArrayAndBothAreReadBack) {
    const CheckReport a = report_of("A", {failing_row(), passing_row("EQ-2")});
    const CheckReport b = report_of("B", {crashed("EQ-3")});
    EXPECT_EQ(to_json({a}).front(), '{');
    EXPECT_EQ(to_json({a, b}).front(), '[');
    for (const std::vector<CheckReport>& reports : {std::vector{a}, std::vector{a, b}}) {
        const std::vector<CheckReport> back = reports_from_json(to_json(reports));
        EXPECT_EQ(to_json(back), to_json(reports));
        EXPECT_TRUE(back.front().device.float32.preserves_signed_zero_inf_nan);
        EXPECT_FALSE(back.front().device.float32.flushes_denormals);
        EXPECT_EQ(back.front().count(judge::Outcome::failed), 1U);
    }
}

TEST(CheckReport, JunitTellsFailuresFromErrors) {
    const std::string xml =
        to_junit({report_of("A & B", {failing_row(), passing_row("EQ-2"), crashed("EQ-3")})});
    EXPECT_THAT(
        xml,
        HasSubstr("<testsuite name=\"A &amp; B\" tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\">"));
    EXPECT_THAT(xml, HasSubstr("<failure type=\"fault\" message=\"line one&#10;line &lt;two&gt;"));
    EXPECT_THAT(xml,
                HasSubstr("<error type=\"crash\" message=\"ended by signal 9 (Killed)\xEF\xBF\xBD[0m\""));
    EXPECT_THAT(xml, HasSubstr("name=\"EQ-2 shipped\" time=\"0.000\"/>"));
    EXPECT_THAT(xml, Not(HasSubstr("\x1b")));
}

TEST(CheckReport, WhatWasNotJudgedIsCountedApart) {
    const std::vector<CheckReport> reports{
        report_of("A", {failing_row(), passing_row("EQ-2"), unjudged_row("EQ-3"), unsupported_row("EQ-4")})};
    EXPECT_EQ(to_text(counts_of(reports)), "4 checks, 1 failed, 2 not judged");
    EXPECT_EQ(counts_of(reports).exit_status(), 1);
    EXPECT_THAT(to_junit(reports), AllOf(HasSubstr("failures=\"1\" errors=\"0\" skipped=\"2\">"),
                                         HasSubstr("<skipped message=\"the device promises nothing"),
                                         HasSubstr("<skipped message=\"h is no GLSL 3.30\"/>")));
    const std::string page = to_check_page(reports);
    EXPECT_THAT(page,
                AllOf(HasSubstr("4 checks, 1 failed, 2 not judged"), HasSubstr(">not judged</button>")));
}

TEST(CheckReport, TheTableSaysWhatBecameOfEachRow) {
    EXPECT_THAT(table_line(passing_row("EQ-2")), HasSubstr("ok"));
    EXPECT_THAT(table_line(failing_row()), HasSubstr("3 outside, reads outside its image"));
    EXPECT_THAT(table_line(crashed("EQ-3")), AllOf(HasSubstr("crash"), Not(HasSubstr("budget"))));
    judge::Answer row = crashed("EQ-3");
    row.reason = judge::Reason::error;
    EXPECT_THAT(table_line(row), HasSubstr("could not run"));
    EXPECT_THAT(table_line(unjudged_row("EQ-3")), HasSubstr("not judged; the device promises nothing"));
    EXPECT_THAT(table_line(unsupported_row("EQ-4")), HasSubstr("unsupported"));
}

// By the rules, an overflow may be right. By a budget it never is.
TEST(CheckReport, AnInfiniteErrorIsSaidToBePermittedWhereItIs) {
    judge::Answer row = passing_row("EQ-2");
    row.largest.ulp = std::numeric_limits<double>::infinity();
    EXPECT_THAT(table_line(row), HasSubstr(" inf "));
    row.criterion = judge::Criterion::rules;
    EXPECT_THAT(table_line(row), AllOf(HasSubstr(" permitted "), Not(HasSubstr("inf"))));
    ordinary(row).outside = 1;
    EXPECT_THAT(table_line(row), HasSubstr(" inf "));
}

// A verdict that says less than "ok" does not read as if it said all.
TEST(CheckReport, WhatWasNotJudgedIsRemarked) {
    judge::Answer row = passing_row("EQ-2");
    row.classes.back() = {.inputs = 10, .recorded = 10};
    ordinary(row).open = 3;
    EXPECT_EQ(verdict_of(row), "ok");
    EXPECT_EQ(remark_on(row), "any result would pass for 3 of 60; not promised: nan");
    EXPECT_THAT(table_line(row), EndsWith(" ok; " + remark_on(row)));
    row.variant = "strict | spirv-opt -O";
    EXPECT_THAT(table_line(row),
                AllOf(HasSubstr(" strict  "), EndsWith(remark_on(row) + "; after spirv-opt -O")));
    EXPECT_EQ(remark_on(passing_row("EQ-2")), "");
    EXPECT_EQ(remark_on(unsupported_row("EQ-4")), "h is no GLSL 3.30");
}

// The rows of each driver. Nothing is in conflict.
std::vector<std::vector<std::string>> merged(const std::vector<CheckReport>& files) {
    std::vector<ReportFile> named;
    for (const CheckReport& file : files) named.push_back({"a", file});
    const MergedReports all = merge(named);
    EXPECT_THAT(all.conflicts, IsEmpty());
    std::vector<std::vector<std::string>> names;
    for (const CheckReport& report : all.reports)
        for (auto& of_one = names.emplace_back(1, report.device.driver);
             const judge::Answer& row : report.rows)
            of_one.push_back(row.equation + " " + row.variant);
    return names;
}

TEST(Merge, ShardsBecomeTheWholeAndDriversAreToldApartByAllTheySay) {
    EXPECT_THAT(merged({report_of("A", {passing_row("EQ-1"), passing_row("EQ-3")}),
                        report_of("A", {passing_row("EQ-2", "strict"), passing_row("EQ-2")})}),
                ElementsAre(ElementsAre("driver 1.2", "EQ-1 shipped", "EQ-2 shipped", "EQ-2 strict",
                                        "EQ-3 shipped")));
    CheckReport newer = report_of("A", {passing_row("EQ-1")});
    newer.device.driver = "driver 1.3";
    EXPECT_THAT(merged({report_of("A", {passing_row("EQ-1")}), newer, report_of("B", {crashed("EQ-1")})}),
                ElementsAre(ElementsAre("driver 1.2", _), ElementsAre("driver 1.3", _),
                            ElementsAre("driver 1.2", _)));
    judge::Answer later = passing_row("EQ-1");
    later.seconds = 9.0;
    EXPECT_THAT(merged({report_of("A", {passing_row("EQ-1")}), report_of("A", {later})}),
                ElementsAre(ElementsAre("driver 1.2", "EQ-1 shipped")))
        << "the same row twice is one, whatever its time";
}

TEST(Merge, AShardThatIsMissingIsSaidAndADriverIsOneManifest) {
    std::vector<ReportFile> files;
    for (const char* shard : {"0/3", "2/3", "1/3"}) files.push_back({shard, report_of("A", {})});
    for (ReportFile& file : files) file.report.shards = {file.file};
    EXPECT_THAT(merge(files).missing, IsEmpty());
    files.back().report.device.manifest = "other.json";
    EXPECT_THAT(merge(files).missing, ElementsAre("A (driver 1.2): no file has the shard 1/3",
                                                  "A (driver 1.2), other.json: no file has the shard 0/3"));
    files.pop_back();
    files.push_back({"whole", report_of("A", {})});
    EXPECT_THAT(merge(files).missing, IsEmpty());
}

TEST(Merge, OfRowsThatDisagreeTheWorseIsKeptAndItIsSaid) {
    judge::Answer little = passing_row("EQ-1");
    ordinary(little).outside = 1;
    judge::Answer larger_error = passing_row("EQ-1");
    larger_error.largest.fraction = 0.9;
    judge::Answer fault = passing_row("EQ-1");
    fault.fault = "pixel";
    const std::vector<judge::Answer> ascending{passing_row("EQ-1"), larger_error, little, fault,
                                               crashed("EQ-1")};
    for (std::size_t i = 1; i < ascending.size(); ++i) {
        for (const bool swapped : {false, true}) {
            const judge::Answer& first = ascending[swapped ? i : i - 1];
            const judge::Answer& second = ascending[swapped ? i - 1 : i];
            const MergedReports merged =
                merge({{"a.json", report_of("A", {first})}, {"b.json", report_of("A", {second})}});
            ASSERT_EQ(merged.reports.at(0).rows.size(), 1U);
            EXPECT_EQ(line_of(merged.reports[0].rows[0]), line_of(ascending[i])) << i;
            ASSERT_EQ(merged.conflicts.size(), 1U);
            EXPECT_THAT(merged.conflicts[0], HasSubstr("EQ-1 shipped on A (driver 1.2): a.json says "));
            EXPECT_THAT(merged.conflicts[0], HasSubstr("b.json says "));
        }
    }
}

judge::Answer with_error(const std::string& equation, double fraction, const char* variant = "shipped") {
    judge::Answer row = passing_row(equation, variant);
    row.budget.ulp = 4;
    row.largest.fraction = fraction;
    return row;
}

TEST(Changes, TwoBuildsAreCompared) {
    const CheckReport before =
        report_of("A", {with_error("EQ-1", 0.2), with_error("EQ-2", 0.5), with_error("EQ-3", 0.001),
                        crashed("EQ-4"), passing_row("EQ-5"), with_error("EQ-6", 0.5), passing_row("EQ-7")});
    CheckReport now =
        report_of("A", {with_error("EQ-1", 0.45), with_error("EQ-2", 0.25), with_error("EQ-3", 0.002),
                        passing_row("EQ-4"), crashed("EQ-5"), with_error("EQ-6", 0.52), crashed("EQ-8")});
    now.device.driver = "driver 1.3";
    EXPECT_THAT(
        changes_since({before, report_of("B", {})}, {now}),
        ElementsAre("EQ-1 shipped on A (driver 1.3): the error grew from 0.20 to 0.45 of what is allowed",
                    "EQ-2 shipped on A (driver 1.3): the error shrank from 0.50 to 0.25 of what is allowed",
                    "EQ-4 shipped on A (driver 1.3): mended", "EQ-5 shipped on A (driver 1.3): newly failed",
                    "EQ-8 shipped on A (driver 1.3): newly failed",
                    "A (driver 1.3): 1 checks of the earlier run are missing"));
    EXPECT_THAT(changes_since({before}, {before}), IsEmpty());
    EXPECT_THAT(changes_since({now, before}, {before}), IsEmpty()) << "its own driver comes first";
    now.seed = 2;
    EXPECT_THAT(changes_since({before}, {now}),
                ElementsAre("A (driver 1.3): no earlier run has its 0 inputs with seed 2"));
    now.seed = before.seed;
    now.device.name = "A, 128 bits";
    EXPECT_EQ(changes_since({before}, {now}).size(), 6U) << "the only device of each";
    EXPECT_THAT(changes_since({before, before}, {now}), ElementsAre(HasSubstr("no earlier run")));
}

std::vector<CheckReport> two_drivers() {
    judge::Answer lost{{.equation = "device"}};
    lost.error = "the device cannot be opened";
    lost.reason = judge::Reason::crash;
    judge::Answer strict = passing_row("EQ-2", "strict");
    strict.criterion = judge::Criterion::rules;
    strict.fraction = 0.5;
    judge::Answer wrong = passing_row("EQ-2");
    ordinary(wrong).outside = 3;
    return {report_of("A", {passing_row("EQ-1"), strict, unjudged_row("EQ-3"), unsupported_row("EQ-4")}),
            report_of("B|C", {crashed("EQ-1"), wrong, lost})};
}

TEST(Matrix, HasALineForEachEquationAndAColumnForEachDriverAndVariant) {
    EXPECT_EQ(to_matrix(two_drivers()),
              "driver 1: A (driver 1.2)\n"
              "driver 2: B|C (driver 1.2)\n"
              "\n"
              "equation  1 shipped    1 strict  2 shipped\n"
              "EQ-1      ok 0.25      -         crash\n"
              "EQ-2      -            ok 0.50   FAIL 3/50\n"
              "EQ-3      not judged   -         -\n"
              "EQ-4      unsupported  -         -\n"
              "\n"
              "ok 0.85: passed, the largest error is 0.85 of what is allowed. FAIL 3/100: 3 of 100 inputs "
              "are outside.\n"
              "not judged, unsupported: no verdict. hang, crash and other words: the check did not end. "
              "-: it was not run.\n"
              "\n"
              "driver 1: 4 checks, 0 failed, 2 not judged; worst error 0.5 of what is allowed: EQ-2 strict\n"
              "driver 2: 3 checks, 3 failed; failed: 2 crash, 1 outside; worst error 0.25 of what is "
              "allowed: EQ-2 shipped; the device cannot be opened\n");
}

TEST(Matrix, MarkdownHoldsTheSame) {
    const std::string page = to_matrix_markdown(two_drivers());
    EXPECT_THAT(page,
                HasSubstr("| equation | 1 shipped | 1 strict | 2 shipped |\n| --- | --- | --- | --- |\n"));
    EXPECT_THAT(to_matrix({report_of("A", {passing_row("EQ-1")})}), HasSubstr("equation  shipped\n"))
        << "one driver needs no numbers";
    EXPECT_THAT(page, HasSubstr("| EQ-2 | - | ok 0.50 | FAIL 3/50 |\n"));
    EXPECT_THAT(page, HasSubstr("| 2 | B\\|C (driver 1.2) | 3 checks, 3 failed"));
}

judge::Answer strict(const std::string& equation, double width, double guaranteed_ulp) {
    judge::Answer by_rules = with_error(equation, 0.2, "strict");
    by_rules.criterion = judge::Criterion::rules;
    by_rules.fraction = width;
    by_rules.bounded = 500;
    by_rules.guarantee = {.ulp = guaranteed_ulp, .absolute = 3e-7, .fraction = guaranteed_ulp / 4};
    return by_rules;
}

TEST(Accuracy, TheTableOfAllHasEveryEquationAndDriver) {
    judge::Answer open = strict("B", 0.9, 7.5);
    open.unbounded = 125;
    CheckReport newer = report_of("one", {with_error("A", 0.75), with_error("B", 0.25), open,
                                          with_error("B", 0.5, "optimized"), with_error("B", 0.4, "small")});
    newer.device.driver = "newer";
    judge::Answer gone{{.equation = "C", .variant = "shipped"}};
    gone.error = "gone";
    gone.reason = judge::Reason::crash;
    judge::Answer undocumented = strict("D", 0.5, 2);
    undocumented.variant = "shipped";
    const Table table = accuracy_table({report_of("one", {with_error("A", 0.0), strict("A", 0.5, 2)}), newer,
                                        report_of("two", {gone, undocumented})});
    std::vector<std::vector<std::string>> rows(1);
    for (const Column& column : table.columns) rows[0].push_back(column.title);
    for (const std::vector<Cell>& cells : table.rows)
        for (auto& row = rows.emplace_back(); const Cell& cell : cells) row.push_back(cell.text);
    EXPECT_THAT(rows,
                ElementsAre(ElementsAre(_, _, _, _, _, "one (driver 1.2)", "one (newer)", "two"),
                            ElementsAre("A", "4 ulp", "3.0e-07", "2", "0", "exact", "0.75 shipped", "-"),
                            ElementsAre("B", "4 ulp", "3.0e-07", "7.5", "25", "-", "0.50 optimized", "-"),
                            ElementsAre("C", "exact", "-", "-", "-", "-", "-", "-"),
                            ElementsAre("D", "Vulkan's rules", "3.0e-07", "2", "0", "-", "-", "-")));
}

}  // namespace gloam::record::check_report_test
