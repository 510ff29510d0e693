// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_benchmark_test {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

// Two methods at two counts, as small as images may be useful.
Arguments tiny(const Arguments& more) {
    Arguments arguments{"bench",     "--scene", "moving", "--method", "hemisphere", "gtao",
                        "--samples", "4",       "16",     "--size",   "64x36",      "--frames",
                        "4",         "--rays",  "32",     "--repeat", "1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

// A configuration of a case, as --json has it.
void expect_plausible(const json& row) {
    const bool temporal = row.at("candidate").get<std::string>().ends_with("temporal");
    EXPECT_GT(double{row.at("copies")}, 0.0);
    EXPECT_GT(double{row.at("rmse")}, 0.0);
    EXPECT_LT(double{row.at("rmse")}, 0.3);
    EXPECT_GT(double{row.at("rmse_depth")}, 0.0);
    const double taken = row.at("samples");
    EXPECT_GT(taken, 0.0);
    // Fewer where nothing can block, but one slice at least.
    constexpr double slice = 8.0;
    EXPECT_LE(taken, std::max(double{row.at("samples_asked")}, slice) + 1e-9);
    EXPECT_GT(std::uint64_t{row.at("memory_bytes")}, 64U * 36U * 4U * 10U);
    EXPECT_EQ(row.at("rounds_ms").size(), 1U);
    EXPECT_EQ(row.at("flicker").is_number(), temporal);
}

json results_in(const std::filesystem::path& file) {
    return json::parse(read_file(file)).at("sizes").at(0).at("cases").at(0).at("results");
}

void expect_compared(const std::filesystem::path& file, const std::filesystem::path& second) {
    const CommandResult comparison = run_command({"bench", "--compare", file.string(), second.string()});
    expect_success(comparison);
    EXPECT_THAT(comparison.out, HasSubstr("8 configurations in both"));
    EXPECT_THAT(comparison.out, HasSubstr("error 1.000"));
}

void expect_answered(const std::filesystem::path& file) {
    const CommandResult answered =
        run_command({"bench", "--from", file.string(), "--budget", "1000000copies", "--error", "0.3"});
    expect_success(answered);
    EXPECT_THAT(answered.out, HasSubstr("within 1000000copies: "));
    EXPECT_THAT(answered.out, HasSubstr("RMSE at most 0.3: "));
    const CommandResult none = run_command({"bench", "--from", file.string(), "--error", "0.000001"});
    EXPECT_EQ(none.status, 1);
    EXPECT_THAT(none.out, HasSubstr("no configuration"));
}

TEST(Bench, MeasuresResumesAnswersAndCompares) {
    const TemporaryDirectory folder;
    const auto out = folder.path() / "out";
    const auto file = folder.path() / "a.json";
    const CommandResult first =
        run_command(tiny({"--validation", "--out", out.string(), "--json", file.string()}));
    expect_success(first);
    EXPECT_THAT(first.out, HasSubstr("all scenes"));
    const json results = results_in(file);
    ASSERT_EQ(results.size(), 8U);
    for (const json& row : results) {
        SCOPED_TRACE(row.dump());
        expect_plausible(row);
    }
    EXPECT_EQ(read_file(out / "results.json"), read_file(file));
    EXPECT_EQ(line_count(read_file(out / "results.csv")), 1 + 8);
    EXPECT_THAT(read_file(out / "moving.svg"), HasSubstr("<svg"));
    EXPECT_THAT(read_file(out / "overall.png"), HasSubstr("PNG"));

    // Interrupted in the middle of a line, and taken up again.
    const std::string journal = read_file(out / "journal.jsonl");
    ASSERT_EQ(line_count(journal), 1 + 8 + 4);  // the second round visits single frames only
    std::ofstream(out / "journal.jsonl") << journal.substr(0, journal.size() / 2);
    const auto second = folder.path() / "b.json";
    expect_success(run_command(tiny({"--resume", "--out", out.string(), "--json", second.string()})));
    EXPECT_EQ(line_count(read_file(out / "journal.jsonl")), line_count(journal));
    const json again = results_in(second);
    ASSERT_EQ(again.size(), results.size());
    for (std::size_t i = 0; i < results.size(); ++i)
        for (const char* error : {"rmse", "rmse_raw", "rmse_depth", "similarity", "flicker", "samples"})
            EXPECT_EQ(again[i].at(error), results[i].at(error)) << error;  // the same to the bit
    expect_could_not_run(run_command({"bench", "--scene", "moving", "--preset", "fast", "--frames", "2",
                                      "--rays", "32", "--resume", "--out", out.string()}),
                         "cannot resume");

    expect_compared(file, second);
    expect_answered(file);
}

// A result file changed by hand: errors that rise are found, and another device is no obstacle.
TEST(Bench, ComparesWithWhatGotWorse) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "a.json";
    const auto worse = folder.path() / "b.json";
    const auto page = folder.path() / "page.md";
    expect_success(run_command({"bench", "--scene", "corner", "--preset", "fast", "--size", "32x18",
                                "--frames", "2", "--rays", "32", "--repeat", "1", "--single", "--json",
                                file.string(), "--report", page.string()}));
    EXPECT_THAT(read_file(page), HasSubstr("| fast/12/single |"));
    EXPECT_THAT(read_file(page), HasSubstr("all scenes, presets"));
    EXPECT_THAT(read_file(page), HasSubstr("](images/samples/corner.svg)"));
    EXPECT_THAT(read_file(folder.path() / "images" / "samples" / "corner.png"), HasSubstr("PNG"));
    EXPECT_THAT(read_file(folder.path() / "images" / "samples" / "overall.svg"), HasSubstr("<svg"));
    json document = json::parse(read_file(file));
    document["device"] = "another";
    json& error = document["visits"][0]["quality"]["rmse"];
    error = double{error} + 0.01;
    std::ofstream(worse) << document.dump();
    const CommandResult told = run_command({"bench", "--compare", file.string(), worse.string()});
    expect_success(told);
    EXPECT_THAT(told.out, HasSubstr("warning: other devices"));
    EXPECT_THAT(told.out, HasSubstr("larger error: 1\n  corner/fast/12/single"));
    const CommandResult failed =
        run_command({"bench", "--compare", file.string(), worse.string(), "--fail-if-worse"});
    EXPECT_EQ(failed.status, 1);
    expect_success(run_command({"bench", "--compare", worse.string(), worse.string(), "--fail-if-worse"}));
}

TEST(Bench, FrameworkIsMeasuredAlone) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "a.json";
    expect_success(run_command({"bench", "framework", "--repeat", "1", "--json", file.string()}));
    const json document = json::parse(read_file(file));
    EXPECT_GE(document.at("framework").size(), 8U);
    for (const json& figure : document.at("framework")) EXPECT_GT(double{figure.at("value")}, 0.0) << figure;
}

TEST(Bench, BadInputIsOneClearLine) {
    const TemporaryDirectory folder;
    const auto bad = folder.path() / "bad.json";
    std::ofstream(bad) << R"({"experiment": "e", "device": 7})";
    const auto out = folder.path() / "out";
    expect_could_not_run(run_command({"bench", "--scene", "nowhere", "--out", out.string()}), "nowhere");
    EXPECT_FALSE(std::filesystem::exists(out));
    expect_could_not_run(run_command({"bench", "--method", "magic"}), "magic");
    expect_could_not_run(run_command({"bench", "--preset", "magic"}), "magic");
    expect_could_not_run(run_command({"bench", "--method", "gtao", "gtao"}), "twice");
    expect_could_not_run(run_command({"bench", "--samples", "0"}), "--samples");
    expect_could_not_run(run_command({"bench", "--repeat", "-1"}), "--rounds");
    expect_could_not_run(run_command({"bench", "--from", bad.string(), "--samples", "4"}), "--samples");
    expect_could_not_run(run_command({"bench", "views", "--from", bad.string(), "--single", "fast"}),
                         "--single");
    expect_could_not_run(run_command({"bench", "--size", "8x8"}), "--size 8x8");
    expect_could_not_run(run_command({"bench", "--temporal", "--single"}), "--single");
    expect_could_not_run(run_command({"bench", "--resume"}), "--out");
    expect_could_not_run(run_command({"bench", "--budget", "3s"}), "--budget 3s");
    expect_could_not_run(run_command({"bench", "--error", "0"}), "--error");
    expect_could_not_run(run_command({"bench", "--from", bad.string()}), "device: expected a text");
    expect_could_not_run(run_command({"bench", "--from", "/no/such.json"}), "/no/such.json");
    expect_could_not_run(run_command({"bench", "--compare", bad.string()}), "--compare");
    expect_could_not_run(run_command({"bench", "--compare", bad.string(), bad.string()}), bad.string());
    expect_could_not_run(run_command({"bench", "--json", "/no/such/folder/a.json"}), "/no/such/folder");
    expect_could_not_run(run_command({"bench", "--out", "/proc/out"}), "/proc/out");
}

}  // namespace bench_benchmark_test
}  // namespace gloam::test
