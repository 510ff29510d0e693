// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "report/benchmark/benchmark_json.hpp"
#include "report/benchmark/journal.hpp"
#include "report/benchmark/page.hpp"
#include "report/benchmark/plots.hpp"
#include "report/benchmark_rows.hpp"
#include "support/run_command.hpp"

namespace gloam::report {
namespace files_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Benchmark everything() {
    Benchmark benchmark =
        make_benchmark({make_row("a", "m", 4, 10, 0.05), make_row("a", "n", 8, 30, 0.02, true),
                        make_row("a", "n", 4, 40, 0.03, true)});
    benchmark.rows[1].configuration.preset = "p";
    benchmark.framework = {{"figure", "ms", 1.25}};
    return benchmark;
}

TEST(BenchmarkJson, ReadsWhatItWrote) {
    const Benchmark benchmark = everything();
    const std::string text = to_json(benchmark);
    const Benchmark back = benchmark_from_json(text);
    EXPECT_EQ(to_json(back), text);
    EXPECT_EQ(back.rows[1].configuration, benchmark.rows[1].configuration);
    EXPECT_EQ(back.rows[1].quality.memory_bytes, 3'145'728U);
    EXPECT_TRUE(std::isnan(back.rows[0].quality.flicker));
    EXPECT_EQ(back.rows[0].passes, benchmark.rows[0].passes);
    EXPECT_EQ(back.framework[0].value, 1.25);
}

// A results file is untrusted: each name in it becomes one line, and no name becomes a path.
TEST(BenchmarkJson, NamesAreOneLine) {
    const auto refusal = [](auto&& change, const char* named) {
        Benchmark benchmark = everything();
        change(benchmark);
        EXPECT_THAT([&] { (void)benchmark_from_json(to_json(benchmark)); },
                    testing::ThrowsMessage<std::runtime_error>(
                        testing::AllOf(HasSubstr(named), HasSubstr("expected a name"))));
    };
    const std::string bad = "a\nsystem('id')\n";
    refusal([&](Benchmark& b) { b.device = bad; }, "device");
    refusal([&](Benchmark& b) { b.driver = bad; }, "driver");
    refusal([&](Benchmark& b) { b.rows[0].configuration.scene = bad; }, "results[0].scene");
    refusal([&](Benchmark& b) { b.rows[0].configuration.method = bad; }, "results[0].method");
    refusal([&](Benchmark& b) { b.rows[1].configuration.preset = bad; }, "results[1].preset");
}

TEST(BenchmarkJson, PlotsAreNamedSoThatNoneLeadsAway) {
    Benchmark benchmark = everything();
    benchmark.rows[0].configuration.scene = "../../evil";
    for (const auto& [name, plot] : plots_of(benchmark)) EXPECT_EQ(name.find('/'), std::string::npos) << name;
    EXPECT_THAT(to_benchmark_page(benchmark, "images"), testing::Not(HasSubstr("images/../")));
}

TEST(BenchmarkJson, DepthSizeAndNumbersAreBounded) {
    const auto refusal = [](const std::string& text, const char* named) {
        EXPECT_THAT([&] { (void)benchmark_from_json(text); },
                    testing::ThrowsMessage<std::runtime_error>(HasSubstr(named)));
    };
    refusal(std::string(1'000'000, '['), "nested more than 64 deep");
    refusal(R"({"benchmark": 1e999})", "no JSON");
    const std::string endless = "{\"" + std::string(100'000, 'x');
    try {
        (void)benchmark_from_json(endless);
    } catch (const std::runtime_error& error) {
        EXPECT_LT(std::string(error.what()).size(), 400U);  // the parser quotes what it read last
    }
    std::string text = to_json(everything());
    text.replace(text.find("\"width\": 320"), 12, "\"width\": 18446744073709551615");
    refusal(text, "width: expected a count of at most");
}

TEST(BenchmarkJson, SaysWhereSomethingElseStands) {
    const std::string text = to_json(everything());
    const auto refusal = [&](const std::string& from, const std::string& to, const char* named) {
        std::string bad = text;
        bad.replace(bad.find(from), from.size(), to);
        EXPECT_THAT([&] { (void)benchmark_from_json(bad); },
                    testing::ThrowsMessage<std::runtime_error>(HasSubstr(named)))
            << to;
    };
    refusal("\"benchmark\": 1", "\"benchmark\": 2", "version 1");
    refusal("\"benchmark\": 1,", "", "benchmark: expected this field");
    refusal("\"samples\": 4", "\"samples\": \"many\"", "results[0].samples: expected a count");
    refusal("\"temporal\": false", "\"temporal\": 3", "results[0].temporal");
    refusal("{", "", "no JSON");
    EXPECT_THROW((void)benchmark_from_json("[]"), std::runtime_error);
}

TEST(BenchmarkJson, CsvHasALineForEachConfiguration) {
    const std::string text = to_csv(everything());
    EXPECT_EQ(test::line_count(text), 4);
    EXPECT_THAT(text, HasSubstr("\na,m,,4,single,0.05,"));
    EXPECT_THAT(text, HasSubstr("\na,n,p,8,temporal,0.02,"));
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(BenchmarkPlots, OneForEachScene) {
    const auto plots = plots_of(everything());
    ASSERT_EQ(plots.size(), 2U);
    EXPECT_EQ(plots[0].first, "a");
    EXPECT_EQ(plots[1].first, "overall");
    const Plot& scene = plots[0].second;
    ASSERT_EQ(scene.curves.size(), 4U);
    EXPECT_EQ(scene.curves[0].name, "others");
    EXPECT_EQ(scene.curves[0].points.size(), 1U);  // beaten in both
    EXPECT_EQ(scene.curves[2].name, "p, temporal");
    EXPECT_THAT(scene.curves[3].labels, testing::ElementsAre("m/4/single", "p/8/temporal"));
    EXPECT_THAT(to_svg(scene), HasSubstr("p/8/temporal"));
}

TEST(BenchmarkPage, HoldsFrontsAndFramework) {
    const std::string page = to_benchmark_page(everything(), "images/x");
    for (const char* text :
         {"## `a`", "images/x/a.svg", "images/x/overall.svg", "320 x 180", "| m/4/single |",
          "**p/8/temporal**", "| n/4/temporal |", "## The framework", "1.25 ms"})
        EXPECT_THAT(page, HasSubstr(text));
}

// A preset on the front, one behind it, and the points between which they lie.
Benchmark with_presets() {
    Benchmark benchmark = make_benchmark({make_row("a", "m", 4, 10, 0.05), make_row("a", "n", 8, 20, 0.03),
                                          make_row("a", "n", 16, 30, 0.02), make_row("a", "m", 8, 25, 0.04)});
    benchmark.rows[2].configuration.preset = "good";
    benchmark.rows[3].configuration.preset = "behind";
    return benchmark;
}

TEST(BenchmarkPage, SaysOfEachPresetWhetherItLiesOnTheFront) {
    const std::string page = to_benchmark_page(with_presets(), "images");
    EXPECT_THAT(page, HasSubstr("## The presets"));
    EXPECT_THAT(page, HasSubstr("| good/16/single | 30.0 | 3.000 | 1.00 | 0.0200 | 0.0200 | on the front |"));
    EXPECT_THAT(page,
                HasSubstr("| behind/8/single | 25.0 | 2.500 | 2.00 | 0.0400 | 0.0400 | behind n/8/single |"));
    const std::string without =
        to_benchmark_page(make_benchmark({make_row("a", "m", 4, 10, 0.05)}), "images");
    EXPECT_THAT(without, testing::Not(HasSubstr("## The presets")));
}

TEST(BenchmarkPlots, NamePresetsThatLieBehindTheFront) {
    const Plot plot = error_against_time(with_presets(), "a");
    const Curve& behind = plot.curves[plot.curves.size() - 2];
    EXPECT_THAT(behind.labels, testing::ElementsAre("behind, single"));
    EXPECT_THAT(behind.points, testing::ElementsAre(testing::Pair(25.0, 0.04)));
}

class BenchmarkJournal : public testing::Test {
  protected:
    [[nodiscard]] Journal open(bool resume) const { return {file_, setup_, resume}; }

    static Visit visit(int round, double ms) {
        Visit visit{.configuration = configuration(), .round = round};
        if (round == 0) visit.quality = Quality{.geometry = 0.25};
        visit.readings = {{{{"ambient_occlusion", ms}}, 0.5}};
        return visit;
    }
    static Configuration configuration() { return {.scene = "s", .method = "m", .samples = 4}; }

    test::TemporaryDirectory folder_;
    fs::path file_ = folder_.path() / "journal.jsonl";
    JournalSetup setup_{
        .device = "d", .driver = "e", .width = 8, .height = 4, .frames = 2, .scored = 1, .rays = 32};
};

TEST_F(BenchmarkJournal, TakesUpWhereItWasLeft) {
    {
        Journal journal = open(false);
        journal.add(visit(0, 1.0));
        journal.add(visit(1, 2.0));
    }
    const Journal journal = open(true);
    EXPECT_TRUE(journal.has(configuration(), 0));
    EXPECT_TRUE(journal.has(configuration(), 1));
    EXPECT_FALSE(journal.has(configuration(), 2));
    const Row row = journal.row_of(configuration());
    EXPECT_EQ(row.readings, 2U);
    EXPECT_EQ(row.quality.geometry, 0.25);
    EXPECT_EQ(row.total_ms.median, 1.5);
    EXPECT_EQ(row.total_copies.median, 3.0);
    EXPECT_EQ(journal.copies().median, 0.5);
}

TEST_F(BenchmarkJournal, DropsALineThatWasBeingWritten) {
    {
        open(false).add(visit(0, 1.0));
    }
    const std::string whole = read(file_);
    std::ofstream(file_, std::ios::app) << R"({"configuration":{"scene":"s")";
    Journal journal = open(true);
    EXPECT_EQ(read(file_), whole);
    EXPECT_TRUE(journal.has(configuration(), 0));
    journal.add(visit(1, 3.0));
    EXPECT_TRUE(open(true).has(configuration(), 1));
}

TEST_F(BenchmarkJournal, StartsEmptyWhereNothingIsToBeResumed) {
    {
        open(false).add(visit(0, 1.0));
    }
    EXPECT_FALSE(open(false).has(configuration(), 0));
    fs::remove(file_);
    EXPECT_FALSE(open(true).has(configuration(), 0));
    EXPECT_TRUE(fs::exists(file_));
    std::ofstream(file_).close();
    EXPECT_FALSE(open(true).has(configuration(), 0));
}

TEST_F(BenchmarkJournal, RefusesWhatWasMeasuredOtherwiseAndWhatIsNone) {
    {
        open(false).add(visit(0, 1.0));
    }
    const std::string whole = read(file_);
    const auto refusal = [&](const char* text) {
        EXPECT_THAT([&] { (void)open(true); }, testing::ThrowsMessage<std::runtime_error>(HasSubstr(text)));
    };
    setup_.width = 16;
    refusal("cannot resume");
    EXPECT_EQ(read(file_), whole);
    setup_.width = 8;
    std::ofstream(file_, std::ios::app) << "{}\n";
    refusal("line 3: configuration: expected this field");
    std::ofstream(file_) << "something\n";
    refusal("cannot resume");
    EXPECT_THROW(Journal("/no/such/folder/journal.jsonl", setup_, false), std::runtime_error);
}

TEST_F(BenchmarkJournal, WithoutAFileKeepsInMemory) {
    Journal journal({}, setup_, false);
    journal.add(visit(0, 1.0));
    EXPECT_TRUE(journal.has(configuration(), 0));
}

}  // namespace files_test
}  // namespace gloam::report
