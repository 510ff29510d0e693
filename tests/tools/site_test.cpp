// SPDX-License-Identifier: MIT
// gloam site: the files that it writes. The site itself is used in tests/site.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "expect.hpp"
#include "installation.hpp"

namespace gloam {
namespace site_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The JSON between the first and the last of two characters of a file.
nlohmann::json json_in(const fs::path& file, char begin, char end) {
    const std::string text = test::read_file(file);
    const std::size_t first = text.find(begin);
    return nlohmann::json::parse(text.substr(first, text.rfind(end) - first + 1));
}

TEST(SiteTest, WritesPagesAndTheChecksOfEachPart) {
    const test::TemporaryDirectory folder;
    const fs::path site = folder.path() / "site";
    const test::CommandResult result =
        test::run_command({"site", site.string(), "HALTON*", "TSSAO-11", "--inputs", "40", "--no-pictures"});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("index.html: "));
    for (const char* page : {"index.html", "check.html", "check.js", "style.css"})
        EXPECT_TRUE(fs::exists(site / page)) << page;
    EXPECT_THAT(
        test::read_file(site / "check.html"),
        AllOf(testing::StartsWith("<!DOCTYPE html>\n"), HasSubstr("<title>gloam: check this browser</title>"),
              HasSubstr("<main>\n<h1>Check this browser</h1>\n"), Not(HasSubstr("<!-- main -->"))));
    const nlohmann::json index = json_in(site / "site.js", '{', '}');
    EXPECT_EQ(index.at("files"), (nlohmann::json{"checks-filter.js", "checks-sampling.js"}));
    EXPECT_EQ(index.at("inputs"), 40);
    const nlohmann::json checks = json_in(site / "checks-filter.js", '[', ']');
    ASSERT_EQ(checks.size(), 1U);
    EXPECT_EQ(checks.front().at("equation"), "TSSAO-11");
    EXPECT_EQ(checks.front().at("scenarios").front().at("count"), 40);
    EXPECT_THAT(checks.front().at("kernel").get<std::string>(),
                AllOf(HasSubstr("#version 300 es\n"), Not(HasSubstr("//")), Not(HasSubstr("#undef"))));
}

TEST(SiteTest, TheSameSeedGivesTheSameFiles) {
    const test::TemporaryDirectory folder;
    for (const char* name : {"a", "b", "c"}) {
        const std::string seed = name == std::string("c") ? "2" : "1";
        const test::CommandResult result = test::run_command(
            {"site", (folder.path() / name).string(), "TSSAO-11", "--seed", seed, "--no-pictures"});
        EXPECT_EQ(result.status, 0) << result.err;
    }
    const auto text = [&folder](const char* name) {
        return test::read_file(folder.path() / name / "checks-filter.js");
    };
    EXPECT_EQ(text("a"), text("b"));
    EXPECT_NE(text("a"), text("c"));
}

TEST(SiteTest, WhatCannotBeWrittenIsOneLineAndLeavesNothing) {
    const test::TemporaryDirectory folder;
    const fs::path site = folder.path() / "site";
    test::expect_could_not_run(test::run_command({"site", site.string(), "NO-SUCH", "--no-pictures"}),
                               "NO-SUCH");
    EXPECT_FALSE(fs::exists(site));
    test::expect_could_not_run(test::run_command({"site", site.string(), "--inputs", "0"}), "--inputs");
    test::expect_could_not_run(test::run_command({"site", "/dev/null", "--no-pictures"}), "/dev/null");
    test::expect_could_not_run(test::run_command({"site", site.string(), "--measured", "no-such.md"}),
                               "no-such.md");
}

}  // namespace site_test
}  // namespace gloam
