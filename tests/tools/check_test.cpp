// SPDX-License-Identifier: MIT
#include <csignal>

#include "base/process.hpp"
#include "tools/gloam.hpp"

namespace gloam::test::check_test {

constexpr const char* function = "gloam_radical_inverse_base2";

json check_json(const fs::path& program, const fs::path& file, int expected_status) {
    const CommandResult result =
        run_program(program, words("check {} --inputs 4096 --json {}", function, file));
    EXPECT_EQ(result.status, expected_status) << result.out << result.err;
    json report = json::parse(read_file(file));
    for (json& row : report.at("results")) row["seconds"] = 0.0;  // all else must be the same in every run
    return report;
}

class Check : public InFolder {};

TEST_F(Check, JsonHasTheStableShapeAndIsTheSameForTheSameSeed) {
    const json report = check_json(GLOAM_BUILT_BINARY, path("a.json"), 0);
    EXPECT_EQ(report, check_json(GLOAM_BUILT_BINARY, path("b.json"), 0));
    EXPECT_NE(report.at("device").at("name"), "");
    ASSERT_EQ(report.at("results").size(), 1U);
    const json& result = report.at("results").front();
    EXPECT_NE(result.at("equation"), "");
    EXPECT_EQ(result.at("function"), function);
    EXPECT_EQ(result.at("file"), "gloam/sampling/halton.glsl");
    EXPECT_EQ(result.at("variant"), "shipped");
    EXPECT_EQ(result.at("inputs"), 4096);
    EXPECT_EQ(result.at("outside"), 0);
    for (const char* number : {"max_ulp", "max_abs", "budget_fraction", "seconds"})
        EXPECT_TRUE(result.at(number).is_number()) << number;
    EXPECT_EQ(result.at("verdict"), "budget");
    EXPECT_EQ(result.at("reason"), "");
    EXPECT_TRUE(result.contains("width_fraction"));
    EXPECT_TRUE(result.at("budget").is_object());
    EXPECT_TRUE(result.contains("worst"));
}

TEST_F(Check, AWrongConstantFailsWithStatusOneAndAStory) {
    const Installation installation;
    installation.spoil_radical_inverse_base2();
    const CommandResult result = installation.gloam("check {} --inputs 4096", function);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.err, "");
    EXPECT_THAT(result.out, HasSubstr("1 checks, 1 failed"));
    EXPECT_THAT(result.out, HasSubstr("want"));

    const json report = check_json(installation.program(), installation.file("a.json"), 1);
    const json& row = report.at("results").front();
    EXPECT_GT(row.at("outside").get<int>(), 2000);
    EXPECT_TRUE(row.at("worst").is_object());
}

TEST_F(Check, AShaderThatDoesNotCompileFailsAndNamesFileAndLine) {
    const Installation installation;
    installation.replace("gloam/sampling/halton.glsl", "uint bits = ", "uint bits = no_such_variable + ");
    const CommandResult result = installation.gloam("check {}", function);
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, testing::ContainsRegex("halton\\.glsl:[0-9]+: .*no_such_variable"));
}

class CheckResume : public InFolder {
  protected:
    [[nodiscard]] std::vector<std::string> command(std::vector<std::string> more = {}) const {
        std::vector<std::string> words{"check", "TSSAO-*", "--inputs", "64", "--json", results().string()};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }

    [[nodiscard]] fs::path results() const { return path("results.json"); }
    [[nodiscard]] fs::path journal() const { return path("results.json.journal"); }

    // The lines that stand in the journal whole.
    [[nodiscard]] std::vector<std::string> kept() const {
        std::ifstream stream(journal());
        std::vector<std::string> lines;
        for (std::string line; std::getline(stream, line) && !stream.eof();) lines.push_back(line);
        return lines;
    }

    // Runs the check until some results stand in the journal, and kills it then.
    void run_and_kill() {
        std::vector<std::string> words = command();
        words.insert(words.begin(), GLOAM_BUILT_BINARY);
        base::WorkerProcess check(words);
        constexpr std::size_t enough = 4;  // the heading and three results
        const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
        while (kept().size() < enough && std::chrono::steady_clock::now() < deadline)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        ASSERT_EQ(kill(check.id(), SIGKILL), 0);
        ASSERT_THAT(check.end(), HasSubstr("signal 9")) << "it ended before it was killed";
        ASSERT_GE(kept().size(), enough);
    }
};

TEST_F(CheckResume, AKilledRunLeavesItsResultsAndTheNextGoesOnFromThere) {
    run_and_kill();
    EXPECT_FALSE(fs::exists(results()));
    std::map<std::string, double> seconds;
    const std::vector<std::string> lines = kept();
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const json row = json::parse(json::parse(lines[i]).at("row").get<std::string>());
        seconds[row.at("equation")] = row.at("seconds");
    }
    std::ofstream(journal(), std::ios::app) << R"({"device": "cut of)";  // as a kill may leave it

    const std::string resumed = output_of(run_command(command(words("--resume"))));
    EXPECT_FALSE(fs::exists(journal()));
    const json rows = json::parse(read_file(results())).at("results");
    EXPECT_GT(rows.size(), seconds.size());
    for (const auto& [equation, time] : seconds) {
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&name = equation](const json& r) { return r.at("equation") == name; });
        ASSERT_NE(row, rows.end()) << equation;
        EXPECT_EQ(row->at("seconds"), time) << equation << " was run again";
        EXPECT_THAT(resumed, HasSubstr(equation));
    }
}

TEST_F(CheckResume, WithoutTheOptionARunBeginsAnew) {
    std::ofstream(journal()) << "of another run\n";
    expect_success(gloam("check gloam_radical_inverse_base2 --inputs 64 --json {}", results()));
    EXPECT_FALSE(fs::exists(journal()));
}

TEST_F(CheckResume, ResultsOfOtherInputsAreNotTakenOver) {
    run_and_kill();
    const CommandResult other = run_command(command(words("--resume --seed 2")));
    expect_could_not_run(other, journal().string());
    EXPECT_THAT(other.err, HasSubstr("\"seed\":2"));
}

TEST_F(CheckResume, ALineThatIsNoResultIsNamed) {
    run_and_kill();
    std::ofstream(journal(), std::ios::app) << "\n{}\n";
    expect_could_not_run(run_command(command(words("--resume"))), journal().string() + ", line ");
}

// The first words of the lines of a check's table.
std::multiset<std::string> equations_of(const std::string& out) {
    std::istringstream lines(out);
    std::multiset<std::string> ids;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(" shipped ") != std::string::npos) ids.insert(line.substr(0, line.find(' ')));
    }
    return ids;
}

CommandResult check_shard(const std::string& shard) {
    return gloam("check gloam_radical_* --inputs 16 --shard {}", shard);
}

TEST(Shard, TogetherTheShardsOfACheckAreTheWhole) {
    const CommandResult whole = gloam("check gloam_radical_* --inputs 16 --in-process");
    const std::multiset<std::string> all = equations_of(whole.out);
    ASSERT_GT(all.size(), 1U);
    std::multiset<std::string> parts = equations_of(check_shard("0/2").out);
    EXPECT_LT(parts.size(), all.size());
    parts.merge(equations_of(check_shard("1/2").out));
    EXPECT_EQ(parts, all);
}

TEST(Shard, WhatGoogleTestSaysIsHeard) {
    const CommandOptions second{.environment = {"GTEST_SHARD_INDEX=1", "GTEST_TOTAL_SHARDS=2"}};
    EXPECT_EQ(equations_of(output_of(run_command(words("check gloam_radical_* --inputs 16"), second))),
              equations_of(check_shard("1/2").out));
    const CommandResult overruled =
        run_command(words("check gloam_radical_* --inputs 16 --shard 0/2"), second);
    EXPECT_EQ(equations_of(overruled.out), equations_of(check_shard("0/2").out));
}

TEST(Shard, AnEmptyShareIsNoFailure) {
    EXPECT_THAT(output_of(check_shard("999/1000")), HasSubstr("0 checks, 0 failed"));
}

TEST(Shard, WhatIsNoneIsNamed) {
    expect_could_not_run(check_shard(" 0/1"), "--shard");
    expect_could_not_run(run_command(words("check"), {.environment = {"GTEST_TOTAL_SHARDS=2"}}),
                         "GTEST_SHARD_INDEX");
    expect_could_not_run(
        run_command(words("check"), {.environment = {"GTEST_TOTAL_SHARDS=2", "GTEST_SHARD_INDEX=2"}}),
        "GTEST_TOTAL_SHARDS");
}

}  // namespace gloam::test::check_test
