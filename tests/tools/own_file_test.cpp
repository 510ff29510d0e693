// SPDX-License-Identifier: MIT
// Somebody's shader file: `gloam check FILE` and `gloam explain`.
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace own_file_test {

using testing::HasSubstr;

const std::string file = std::string(GLOAM_TOOLS_FIXTURES) + "/own.glsl";

TEST(OwnFile, EveryFunctionIsJudgedByTheRules) {
    const TemporaryDirectory folder;
    const std::string report = (folder.path() / "own.json").string();
    const CommandResult result = run_command({"check", file, "--inputs", "512", "--json", report});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("2 checks, 0 failed"));
    const nlohmann::json rows = nlohmann::json::parse(read_file(report)).at("results");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].at("function"), "own_root");
    EXPECT_EQ(rows[0].at("verdict"), "rules");
    EXPECT_EQ(rows[0].at("inputs"), 512);
}

TEST(OwnFile, OneFunctionInAllVariantsFromItsRange) {
    const CommandResult result = run_command({"check", file, "own_root", "--range", "p=2:3", "--range",
                                              "q=0:1", "--inputs", "64", "--variant", "all"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("9 checks, 0 failed"));
}

// Each function in a worker: a hang is reported, and the other functions are checked.
TEST(OwnFile, AHangCostsOneFunction) {
    const std::string spins = std::string(GLOAM_TOOLS_FIXTURES) + "/own_spins.glsl";
    const TemporaryDirectory folder;
    const std::string json = (folder.path() / "own.json").string();
    const std::string failures = (folder.path() / "failures").string();
    const CommandResult result = run_command(
        {"check", spins, "--inputs", "4096", "--timeout", "1.5", "--json", json, "--failures", failures});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("3 checks, 1 failed"));
    EXPECT_THAT(result.out, testing::ContainsRegex("run it again: gloam check .*own_spins.glsl own_spins"));
    const nlohmann::json rows = nlohmann::json::parse(read_file(json)).at("results");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1].at("reason"), "hang");
    EXPECT_EQ(rows[1].at("function"), "own_spins");
    EXPECT_EQ(rows[2].at("outside"), 0);
    EXPECT_EQ(rows[2].at("inputs"), 4096);
    EXPECT_EQ(rows[2].at("by_rules"), 4096);
    EXPECT_EQ(rows[2].at("bounded"), 2048);  // Bounds are calculated for at most 2,048 inputs of a run.
    EXPECT_FALSE(std::filesystem::is_empty(failures));
}

TEST(OwnFile, CoverageIsReportedOnRequest) {
    const TemporaryDirectory folder;
    const std::string json = (folder.path() / "own.json").string();
    const CommandResult result =
        run_command({"check", file, "own_swap", "--inputs", "64", "--coverage", "--json", json});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("own_swap shipped: lines 1 of 1, ways of branches 2 of 2"));
    const nlohmann::json row = nlohmann::json::parse(read_file(json)).at("results").at(0);
    EXPECT_EQ(row.at("coverage").at("points").at(0).at("text"), "return really ? v.yx : v;");
}

TEST(OwnFile, BadInputIsNamed) {
    expect_could_not_run(run_command({"check", file, "no_such"}), "no_such");
    expect_could_not_run(run_command({"check", "no_such.glsl"}), "no_such.glsl");
    expect_could_not_run(run_command({"check", file, "--range", "z=0:1"}), "z");
    expect_could_not_run(run_command({"check", file, "--range", "p=1:0"}), "LOW <= HIGH");
    expect_could_not_run(run_command({"check", "--range", "p=0:1"}), "--range");
    expect_could_not_run(run_command({"explain", file, "own_root", "1"}), "takes 2 values");
    expect_could_not_run(run_command({"explain", file, "own_root", "1", "x"}), "x");
    expect_could_not_run(run_command({"explain", "no_such.glsl", "f", "1"}), "no_such.glsl");
}

TEST(OwnFile, ExplainNamesTheLineWhereTheErrorEnters) {
    const CommandResult result = run_command({"explain", file, "own_root", "1", "1e-4"});
    expect_success(result);
    EXPECT_THAT(result.out, testing::ContainsRegex("own.glsl:4 own_root +OpFMul"));
    EXPECT_THAT(result.out, testing::ContainsRegex("own.glsl:5 own_root +OpFSub.*most of the error"));
    EXPECT_THAT(result.out, HasSubstr("grows most at"));
}

}  // namespace own_file_test
}  // namespace gloam::test
