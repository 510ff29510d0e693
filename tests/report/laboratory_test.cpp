// SPDX-License-Identifier: MIT
// Results of many machines, in a stream.
#include "report/results_database.hpp"
#include "report/rows.hpp"
#include "support/files.hpp"

namespace gloam::report::laboratory_test {

DeviceSummary device_of(const std::string& name, const std::string& driver) {
    return {.name = name, .driver = driver, .type = "discrete", .api_version = "1.3.230"};
}

CheckReport report_of_device(const DeviceSummary& device, const std::vector<check::Answer>& rows,
                             std::uint64_t seed = 7) {
    return {.device = device, .rows = rows, .versions = "gloam 0", .inputs = 50, .seed = seed};
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
    read_results(to_json(reports), [&](const ResultRun& run, const std::vector<ResultRow>& of_report) {
        devices.push_back(run.device.name + "/" + run.device.driver + "/" + api_of(run.device));
        rows.insert(rows.end(), of_report.begin(), of_report.end());
        EXPECT_EQ(run.versions, "gloam 0");
        EXPECT_EQ(run.inputs, 50U);
        EXPECT_EQ(run.seed, 7U);
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
        read_results(text, [](const ResultRun&, const std::vector<ResultRow>&) {});
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
    EXPECT_THAT(message_of(R"({"results": [{"equation": "E"}]})"), HasSubstr("a device and results"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a"}, "results": [{"variant": "v"}]})"),
                HasSubstr("without an equation"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a\nb"}, "results": []})"), HasSubstr("device.name"));
    EXPECT_THAT(message_of("{}"), HasSubstr("a device and results"));
    EXPECT_THAT(message_of(R"({"device": {"name": "a"}, "other": []})"), HasSubstr("a device and results"));
    EXPECT_THAT(message_of(std::string(100'000, '[')), HasSubstr("deeper than 64"));
}

LaboratorySummary summary_of(const std::vector<CheckReport>& files) {
    ResultsDatabase database("", ResultsDatabase::Access::add);
    for (const CheckReport& file : files) database.add(to_json(std::vector{file}));
    return database.summary();
}

TEST(ResultsDatabase, CountsRunsOfAllMachinesOfADriver) {
    const DeviceSummary sister = device_of("NVIDIA GeForce RTX 4080", geforce.driver);
    const LaboratorySummary summary =
        summary_of({report_of_device(geforce, {failing_row(), passing_row("EQ-2")}),
                    report_of_device(sister, {passing_row("EQ-1", "strict"), hanging_row("EQ-2")}),
                    report_of_device(device_of("B", "b 1"), {passing_row("EQ-2")})});
    ASSERT_EQ(summary.size(), 2U);
    const GroupSummary& group = summary.at(group_of(geforce));
    EXPECT_EQ(group.runs, 2U);
    EXPECT_THAT(group.devices, ElementsAre(sister.name, geforce.name));
    EXPECT_EQ(group.failing(), 2U);
    const CheckTally& first = group.checks.at({"EQ-1", "strict"});
    EXPECT_EQ(first.runs, 2U);
    EXPECT_EQ(first.failed, 1U);
    EXPECT_EQ(first.outside, failing_row().outside());
    EXPECT_EQ(first.worst, failing_row().fraction_of_allowed());
    EXPECT_EQ(group.checks.at({"EQ-2", "shipped"}).reasons, "hang");
}

TEST(ResultsDatabase, CountsWhatNoMachineJudged) {
    const LaboratorySummary summary = summary_of(
        {report_of_device(geforce, {unjudged_row("EQ-1"), unsupported_row("EQ-2"), passing_row("EQ-3")}),
         report_of_device(geforce, {passing_row("EQ-1")}, 8)});
    const GroupSummary& group = summary.at(group_of(geforce));
    EXPECT_EQ(group.checks.at({"EQ-1", "shipped"}).not_judged, 1U);
    EXPECT_EQ(group.not_judged(), 1U) << "EQ-1 was judged with another seed";
    EXPECT_EQ(group.failing(), 0U);
    EXPECT_THAT(to_summary_text(summary, std::nullopt),
                HasSubstr("1 drivers, 3 checks, 0 failed, 1 not judged"));
}

// The same question twice, in any order, and in shards cut in other places: it counts once, as the worse.
TEST(ResultsDatabase, AQuestionAnsweredTwiceCountsOnceInAnyOrder) {
    check::Answer slower = passing_row("EQ-1");
    slower.seconds = 9.0;
    std::vector<CheckReport> files{report_of_device(geforce, {passing_row("EQ-1"), passing_row("EQ-2")}),
                                   report_of_device(geforce, {slower}),
                                   report_of_device(geforce, {hanging_row("EQ-2"), passing_row("EQ-3")}),
                                   report_of_device(geforce, {passing_row("EQ-1")}, 8)};
    for (int order = 0; order < 24; ++order) {
        std::ranges::next_permutation(files, {},
                                      [](const CheckReport& file) { return to_json(std::vector{file}); });
        const LaboratorySummary summary = summary_of(files);
        const auto& checks = summary.at(group_of(geforce)).checks;
        EXPECT_EQ(checks.at({"EQ-1", "shipped"}).runs, 2U) << "two seeds";
        EXPECT_EQ(checks.at({"EQ-1", "shipped"}).inputs, 100U);
        EXPECT_EQ(checks.at({"EQ-2", "shipped"}).runs, 1U);
        EXPECT_EQ(checks.at({"EQ-2", "shipped"}).failed, 1U) << "the worse is kept";
        EXPECT_EQ(checks.at({"EQ-3", "shipped"}).runs, 1U);
    }
}

// A file that ends in the middle counts for nothing.
TEST(ResultsDatabase, ABadFileLeavesNoTrace) {
    ResultsDatabase database("", ResultsDatabase::Access::add);
    database.add(to_json(std::vector{report_of_device(geforce, {passing_row("EQ-2")})}));
    std::string cut = to_json(std::vector{report_of_device(geforce, {failing_row(), passing_row("EQ-2")})});
    cut.resize(cut.size() - 10);
    EXPECT_THROW(database.add(cut), std::runtime_error);
    EXPECT_THROW(
        database.add(
            R"({"device": {"name": "a"}, "results": [{"equation": "E", "inputs": 10000000000000}]})"),
        std::runtime_error);
    EXPECT_EQ(database.summary().at(group_of(geforce)).checks.size(), 1U);
}

TEST(ResultsDatabase, GrowsNoFurtherThanItsBounds) {
    std::vector<CheckReport> many;
    for (int i = 0; i < 1000; ++i)
        many.push_back(report_of_device(device_of("D" + std::to_string(i), "d 0"), {passing_row("EQ")}));
    EXPECT_NO_THROW((void)summary_of(many));
    many.push_back(report_of_device(device_of("one more", "d 0"), {passing_row("EQ")}));
    EXPECT_THROW((void)summary_of(many), std::runtime_error);
}

class ResultsFile : public testing::Test {
  protected:
    using Access = ResultsDatabase::Access;
    void put(const CheckReport& report) const {
        ResultsDatabase database(file_, Access::add);
        database.add(to_json(std::vector{report}));
        database.commit();
    }
    std::string refusal(Access access) const {
        try {
            (void)ResultsDatabase(file_, access).summary();
            return "";
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }

    test::TemporaryDirectory folder_;
    std::filesystem::path file_ = folder_.path() / "lab.sqlite";
};

TEST_F(ResultsFile, KeepsWhatWasCommittedAndOnlyThat) {
    {
        const ResultsDatabase unused(file_, Access::add);
    }
    EXPECT_FALSE(std::filesystem::exists(file_)) << "nothing was committed";
    put(report_of_device(geforce, {passing_row("EQ-1")}));
    const std::string bytes = test::read_file(file_);
    put(report_of_device(geforce, {passing_row("EQ-1")}));
    EXPECT_EQ(ResultsDatabase(file_, Access::read).summary().at(group_of(geforce)).checks.size(), 1U);
    {
        ResultsDatabase lost(file_, Access::add);
        lost.add(to_json(std::vector{report_of_device(geforce, {passing_row("EQ-2")})}));
    }
    put(report_of_device(geforce, {passing_row("EQ-3")}, 9));
    EXPECT_EQ(ResultsDatabase(file_, Access::read).summary().at(group_of(geforce)).checks.size(), 2U);
    EXPECT_EQ(ResultsDatabase(file_, Access::read).summary().at(group_of(geforce)).runs, 2U);
}

TEST_F(ResultsFile, AnotherOrADamagedFileIsRefused) {
    EXPECT_THAT(refusal(Access::read),
                HasSubstr(file_.string() + " cannot be used as a database of results"));
    folder_.write("lab.sqlite",
                  "these are no results, but longer than a hundred bytes so that it is no empty file ....");
    EXPECT_THAT(refusal(Access::read), HasSubstr("file is not a database"));
    EXPECT_THAT(refusal(Access::add), HasSubstr("file is not a database"));
    folder_.write("lab.sqlite", "");
    EXPECT_THAT(refusal(Access::read), HasSubstr("other tables"));
    std::vector<check::Answer> rows;
    for (int i = 0; i < 500; ++i) rows.push_back(passing_row("EQ-" + std::to_string(i)));
    std::filesystem::remove(file_);
    put(report_of_device(geforce, rows));
    std::string bytes = test::read_file(file_);
    std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(), '\xa5');
    folder_.write("lab.sqlite", bytes);
    EXPECT_THAT(refusal(Access::read), HasSubstr(file_.string()));
}

CheckReport build_of(const std::string& version, const std::vector<check::Answer>& rows) {
    return report_of_device(device_of("GPU", "radv Mesa " + version), rows);
}

check::Answer with_error(const std::string& equation, double fraction) {
    check::Answer row = passing_row(equation);
    row.budget_fraction = fraction;
    return row;
}

TEST(News, TellsWhatIsNew) {
    const DeviceSummary other = device_of("B", "b 1");
    const DeviceSummary gone = device_of("C", "c 1");
    const LaboratorySummary before =
        summary_of({report_of_device(geforce, {failing_row(), passing_row("EQ-2"), passing_row("EQ-3")}),
                    report_of_device(gone, {passing_row("EQ-2")})});
    EXPECT_THAT(to_summary_text(before, news_since(before, before)), HasSubstr("nothing is new"));
    const LaboratorySummary now = summary_of(
        {report_of_device(geforce, {passing_row("EQ-1", "strict"), hanging_row("EQ-2"), passing_row("EQ-3")}),
         report_of_device(other, {passing_row("EQ-2")})});
    const News news = news_since(before, now);
    EXPECT_THAT(news.new_groups, ElementsAre(group_of(other)));
    EXPECT_THAT(news.missing_groups, ElementsAre(group_of(gone)));
    EXPECT_TRUE(news.builds.empty());
    const std::string text = to_summary_text(now, news);
    EXPECT_THAT(text, HasSubstr("1 newly failed: EQ-2 shipped on NVIDIA 535.104.05, Vulkan 1.3.230"));
    EXPECT_THAT(text, HasSubstr("1 mended: EQ-1 strict"));
}

TEST(News, ComparesTwoBuildsOfOneDriver) {
    const LaboratorySummary before = summary_of(
        {build_of("9.3.0", {with_error("EQ-1", 0.9)}),
         build_of("22.3.6", {with_error("EQ-1", 0.2), with_error("EQ-2", 0.5), with_error("EQ-3", 0.5),
                             with_error("EQ-4", 0.001), hanging_row("EQ-5"), passing_row("EQ-6")})});
    const LaboratorySummary now = summary_of(
        {build_of("23.1.0", {with_error("EQ-1", 0.45), with_error("EQ-2", 0.25), with_error("EQ-3", 0.52),
                             with_error("EQ-4", 0.002), passing_row("EQ-5"), hanging_row("EQ-6")})});
    const std::string text = to_summary_text(now, news_since(before, now));
    EXPECT_THAT(text, HasSubstr("1 new builds: radv Mesa 23.1.0, Vulkan 1.3.230 (22.3.6 -> 23.1.0)\n"));
    EXPECT_THAT(text, HasSubstr("1 newly failed: EQ-6 shipped on radv Mesa 23.1.0"));
    EXPECT_THAT(text, HasSubstr("1 mended: EQ-5 shipped"));
    EXPECT_THAT(
        text,
        HasSubstr("1 errors that grew: EQ-1 shipped on radv Mesa 23.1.0, Vulkan 1.3.230 (0.20 -> 0.45)"));
    EXPECT_THAT(text, HasSubstr("1 errors that shrank: EQ-2 shipped"));
    EXPECT_THAT(text, HasSubstr("1 no longer reported: radv Mesa 9.3.0"));
    EXPECT_THAT(text, Not(HasSubstr("new drivers")));
    const std::string page = to_summary_page(now, news_since(before, now), {});
    EXPECT_THAT(page, HasSubstr("<td>errors that grew</td><td>EQ-1 shipped</td>"));
    // Backwards, as in a search for the build that broke something.
    EXPECT_THAT(to_summary_text(before, news_since(now, before)),
                HasSubstr("radv Mesa 22.3.6, Vulkan 1.3.230 (23.1.0 -> 22.3.6)"));
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
