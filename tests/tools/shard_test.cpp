// SPDX-License-Identifier: MIT
#include "cli/check/worker_session.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "tools/expect.hpp"

namespace gloam::cli {
namespace shard_test {

using test::run_command;

// The first words of the lines of a check's table.
std::multiset<std::string> equations_of(const std::string& out) {
    std::istringstream lines(out);
    std::multiset<std::string> ids;
    for (std::string line; std::getline(lines, line);) {
        if (line.find(" shipped ") != std::string::npos) ids.insert(line.substr(0, line.find(' ')));
    }
    return ids;
}

test::CommandResult check_shard(const std::string& shard) {
    return run_command({"check", "gloam_radical_*", "--inputs", "16", "--shard", shard});
}

TEST(Shard, EveryPositionIsInExactlyOne) {
    for (std::size_t position = 0; position < 20; ++position) {
        std::size_t holders = 0;
        for (const char* text : {"0/3", "1/3", "2/3"}) holders += shard_from(text).holds(position) ? 1 : 0;
        EXPECT_EQ(holders, 1U);
    }
    EXPECT_TRUE(Shard{}.holds(7));
}

TEST(Shard, TogetherTheShardsOfACheckAreTheWhole) {
    const test::CommandResult whole =
        run_command({"check", "gloam_radical_*", "--inputs", "16", "--in-process"});
    const std::multiset<std::string> all = equations_of(whole.out);
    ASSERT_GT(all.size(), 1U);
    std::multiset<std::string> parts = equations_of(check_shard("0/2").out);
    EXPECT_LT(parts.size(), all.size());
    parts.merge(equations_of(check_shard("1/2").out));
    EXPECT_EQ(parts, all);
}

TEST(Shard, WhatGoogleTestSaysIsHeard) {
    const test::CommandOptions second{.environment = {"GTEST_SHARD_INDEX=1", "GTEST_TOTAL_SHARDS=2"}};
    const test::CommandResult said = run_command({"check", "gloam_radical_*", "--inputs", "16"}, second);
    test::expect_success(said);
    EXPECT_EQ(equations_of(said.out), equations_of(check_shard("1/2").out));
    const test::CommandResult overruled =
        run_command({"check", "gloam_radical_*", "--inputs", "16", "--shard", "0/2"}, second);
    EXPECT_EQ(equations_of(overruled.out), equations_of(check_shard("0/2").out));
}

TEST(Shard, AnEmptyShareIsNoFailure) {
    const test::CommandResult result = check_shard("999/1000");
    test::expect_success(result);
    EXPECT_THAT(result.out, testing::HasSubstr("0 checks, 0 failed"));
}

TEST(Shard, WhatIsNoneIsNamed) {
    for (const char* text : {"2/2", "1", "a/b", "1/", "/2", "-1/2", "0/0", "1/2/3", " 0/1"}) {
        test::expect_could_not_run(check_shard(text), "--shard");
    }
    test::expect_could_not_run(run_command({"check"}, {.environment = {"GTEST_TOTAL_SHARDS=2"}}),
                               "GTEST_SHARD_INDEX");
    test::expect_could_not_run(
        run_command({"check"}, {.environment = {"GTEST_TOTAL_SHARDS=2", "GTEST_SHARD_INDEX=2"}}),
        "GTEST_TOTAL_SHARDS");
}

}  // namespace shard_test
}  // namespace gloam::cli
