// SPDX-License-Identifier: MIT
// Results of many machines, in a stream.

#include <nlohmann/json.hpp>
#include <sstream>

#include "report/laboratory.hpp"
#include "report/rows.hpp"
#include "support/matchers.hpp"

namespace gloam::report::laboratory_test {

DeviceSummary device_of(const std::string& name, const std::string& driver) {
    return {.name = name, .driver = driver, .type = "discrete", .api_version = "1.3.230"};
}

CheckReport report_of_device(const DeviceSummary& device, const std::vector<check::Answer>& rows) {
    return {.device = device, .rows = rows};
}

const DeviceSummary geforce = device_of("NVIDIA GeForce RTX 4090", "NVIDIA 535.104.05");

check::Answer hanging_row(const std::string& equation) {
    check::Answer row = passing_row(equation);
    row.error = "no end";
    row.reason = check::Reason::hang;
    return row;
}

TEST(DriverGroup, IsOfTheVendorTheDriverAndItsVersion) {
    const DriverGroup group = group_of(geforce);
    EXPECT_EQ(group.vendor, "NVIDIA");
    EXPECT_EQ(group.driver, "NVIDIA");
    EXPECT_EQ(group.version, "535.104.05");
    EXPECT_EQ(name_of(group), "NVIDIA 535.104.05, Vulkan 1.3.230");
    EXPECT_EQ(name_of(group_of(device_of("llvmpipe (LLVM 15.0.6)", "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"))),
              "llvmpipe Mesa 22.3.6 (LLVM 15.0.6), Vulkan 1.3.230");
    EXPECT_EQ(group_of(device_of("Mali-G78", "Mali-G78 v1.r32p1")).version, "v1.r32p1");
    EXPECT_EQ(group_of(device_of("Mali-G78", "Mali-G78 v1.r32p1")).vendor, "Arm");
    EXPECT_EQ(group_of(device_of("a thing", "")).vendor, "other");
    EXPECT_EQ(name_of(group_of(device_of("a thing", ""))), "a thing, Vulkan 1.3.230");
}

// The stream sees what the document holds, whatever kind a row is.
TEST(ResultStream, SeesWhatTheDocumentHolds) {
    const std::vector<CheckReport> reports{
        report_of_device(geforce, {failing_row(), passing_row("EQ-2"), hanging_row("EQ-3"),
                                   unsupported_row("EQ-4"), unjudged_row("EQ-5")}),
        report_of_device(device_of("B", "b 1"), {passing_row("EQ-2", "strict")})};
    std::vector<std::string> devices;
    std::vector<ResultRow> rows;
    read_results(to_json(reports), [&](const DeviceSummary& device, const ResultRow& row) {
        devices.push_back(device.name + "/" + device.driver + "/" + api_of(device));
        rows.push_back(row);
    });
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(devices.front(), "NVIDIA GeForce RTX 4090/NVIDIA 535.104.05/Vulkan 1.3.230");
    EXPECT_EQ(devices.back(), "B/b 1/Vulkan 1.3.230");
    std::size_t at = 0;
    for (const CheckReport& report : reports) {
        for (const check::Answer& answer : report.rows) {
            const ResultRow& row = rows[at++];
            EXPECT_EQ(row.equation, answer.equation);
            EXPECT_EQ(row.variant, answer.variant);
            EXPECT_EQ(row.inputs, answer.inputs());
            EXPECT_EQ(row.outside, answer.outside());
            EXPECT_EQ(row.fraction, answer.fraction_of_allowed());
            EXPECT_EQ(row.reason, name_of(answer.reason));
            EXPECT_EQ(row.outcome, answer.outcome()) << answer.equation;
        }
    }
}

std::string message_of(const std::string& text) {
    try {
        read_results(text, [](const DeviceSummary&, const ResultRow&) {});
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(ResultStream, OtherTextsAreRefused) {
    EXPECT_THAT(message_of(""), HasSubstr("parse error"));
    EXPECT_THAT(message_of("{"), HasSubstr("parse error"));
    EXPECT_THAT(message_of("[]"), HasSubstr("no report"));
    EXPECT_THAT(message_of("7"), HasSubstr("no report"));
    EXPECT_THAT(message_of(R"({"results": [{"equation": "E"}]})"), HasSubstr("expected a device before"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a"}, "results": [{"variant": "v"}]})"),
                HasSubstr("without an equation"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a\nb"}, "results": []})"), HasSubstr("device.name"));
    EXPECT_THAT(message_of("{}"), HasSubstr("a device and results"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a"}, "other": []})"), HasSubstr("a device and results"));
    EXPECT_THAT(message_of(std::string(100'000, '[')), HasSubstr("deeper than 64"));
}

EarlierSummary earlier_of(const std::string& text) {
    std::istringstream lines(text);
    return earlier_from_lines(lines);
}

LaboratorySummary summary_of(const std::vector<CheckReport>& files) {
    LaboratorySummary summary;
    for (const CheckReport& file : files) summary.add_file(to_json(std::vector{file}));
    return summary;
}

TEST(LaboratorySummary, CountsRunsOfAllMachinesOfADriver) {
    const DeviceSummary sister = device_of("NVIDIA GeForce RTX 4080", geforce.driver);
    const LaboratorySummary summary =
        summary_of({report_of_device(geforce, {failing_row(), passing_row("EQ-2")}),
                    report_of_device(sister, {passing_row("EQ-1", "strict"), hanging_row("EQ-2")}),
                    report_of_device(device_of("B", "b 1"), {passing_row("EQ-2")})});
    EXPECT_EQ(summary.files(), 3U);
    ASSERT_EQ(summary.groups().size(), 2U);
    const GroupSummary& group = summary.groups().at(group_of(geforce));
    EXPECT_EQ(group.files, 2U);
    EXPECT_THAT(group.devices, ElementsAre(sister.name, geforce.name));
    EXPECT_EQ(group.failing(), 2U);
    const CheckTally& first = group.checks.at({"EQ-1", "strict"});
    EXPECT_EQ(first.runs, 2U);
    EXPECT_EQ(first.failed, 1U);
    EXPECT_EQ(first.outside, failing_row().outside());
    EXPECT_EQ(first.worst, failing_row().fraction_of_allowed());
    EXPECT_THAT(group.checks.at({"EQ-2", "shipped"}).reasons, ElementsAre("hang"));
}

TEST(LaboratorySummary, CountsWhatNoMachineJudged) {
    const LaboratorySummary summary = summary_of(
        {report_of_device(geforce, {unjudged_row("EQ-1"), unsupported_row("EQ-2"), passing_row("EQ-3")}),
         report_of_device(geforce, {passing_row("EQ-1")})});
    const GroupSummary& group = summary.groups().at(group_of(geforce));
    EXPECT_EQ(group.checks.at({"EQ-1", "shipped"}).not_judged, 1U);
    EXPECT_EQ(group.not_judged(), 1U) << "EQ-1 was judged on one machine";
    EXPECT_EQ(group.failing(), 0U);
    EXPECT_THAT(to_summary_text(summary, std::nullopt),
                HasSubstr("2 files, 1 drivers, 3 checks, 0 failed, 1 not judged"));
}

// A file that ends in the middle counts for nothing.
TEST(LaboratorySummary, ABadFileLeavesNoTrace) {
    LaboratorySummary summary = summary_of({report_of_device(geforce, {passing_row("EQ-2")})});
    std::string cut = to_json(std::vector{report_of_device(geforce, {failing_row(), passing_row("EQ-2")})});
    cut.resize(cut.size() - 10);
    EXPECT_THROW(summary.add_file(cut), std::runtime_error);
    EXPECT_EQ(summary.files(), 1U);
    EXPECT_EQ(summary.groups().at(group_of(geforce)).failing(), 0U);
}

TEST(LaboratorySummary, GrowsNoFurtherThanItsBounds) {
    std::vector<CheckReport> many;
    for (int i = 0; i < 1000; ++i)
        many.push_back(report_of_device(device_of("D" + std::to_string(i), "d 0"), {passing_row("EQ")}));
    LaboratorySummary summary;
    EXPECT_NO_THROW(summary.add_file(to_json(many)));
    many = {report_of_device(device_of("one more", "d 0"), {passing_row("EQ")})};
    EXPECT_THROW(summary.add_file(to_json(many)), std::runtime_error);
}

TEST(SummaryLines, ComeBackAndTellWhatIsNew) {
    const DeviceSummary other = device_of("B", "b 1");
    const DeviceSummary gone = device_of("C", "c 1");
    const LaboratorySummary before =
        summary_of({report_of_device(geforce, {failing_row(), passing_row("EQ-2"), passing_row("EQ-3")}),
                    report_of_device(gone, {passing_row("EQ-2")})});
    const std::string lines = to_json_lines(before);
    const nlohmann::json first = nlohmann::json::parse(lines.substr(0, lines.find('\n')));
    EXPECT_EQ(first.at("vendor"), "NVIDIA");
    EXPECT_EQ(first.at("equation"), "EQ-1");
    EXPECT_EQ(first.at("failed"), 1);
    EXPECT_EQ(first.at("worst"), 1.25);
    EXPECT_THAT(to_summary_text(before, news_since(earlier_of(lines), before)), HasSubstr("nothing is new"));

    const LaboratorySummary now = summary_of(
        {report_of_device(geforce, {passing_row("EQ-1", "strict"), hanging_row("EQ-2"), passing_row("EQ-3")}),
         report_of_device(other, {passing_row("EQ-2")})});
    const News news = news_since(earlier_of(lines), now);
    EXPECT_THAT(news.new_groups, ElementsAre(group_of(other)));
    EXPECT_THAT(news.missing_groups, ElementsAre(group_of(gone)));
    ASSERT_EQ(news.newly_failed.size(), 1U);
    EXPECT_EQ(news.newly_failed[0].check.first, "EQ-2");
    ASSERT_EQ(news.mended.size(), 1U);
    EXPECT_EQ(news.mended[0].check.first, "EQ-1");
    const std::string text = to_summary_text(now, news);
    EXPECT_THAT(text, HasSubstr("1 newly failed: EQ-2 shipped on NVIDIA 535.104.05, Vulkan 1.3.230"));
    EXPECT_THAT(text, HasSubstr("1 mended: EQ-1 strict"));
}

TEST(SummaryLines, OtherLinesAreRefused) {
    EXPECT_THROW((void)earlier_of("{}\n"), std::runtime_error);
    EXPECT_THROW((void)earlier_of(std::string(100'000, ' ')), std::runtime_error);
    EXPECT_TRUE(earlier_of("").failed.empty());
    try {
        (void)earlier_of("\nnonsense\n");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("line 2"));
    }
}

TEST(SummaryPage, NamesTheWorstFirstAndEscapesForeignText) {
    const LaboratorySummary summary =
        summary_of({report_of_device(device_of("A", "<script> 1"), {passing_row("EQ-2")}),
                    report_of_device(geforce, {failing_row()})});
    const std::string page = to_summary_page(summary, std::nullopt, {"x.json is <nothing>"});
    EXPECT_THAT(page, Not(HasSubstr("<script> 1")));
    EXPECT_THAT(page, HasSubstr("x.json is &lt;nothing&gt;"));
    EXPECT_LT(page.find("535.104.05"), page.rfind("&lt;script&gt;"));
    EXPECT_THAT(page, HasSubstr("1 of 1"));
}

}  // namespace gloam::report::laboratory_test
