// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_plain_test {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

Arguments tiny(const Arguments& more) {
    Arguments arguments{"bench", "plain", "--size", "64x36", "--rounds", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchPlain, AMethodIsTimedBesideThePlainLoop) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "plain.json";
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "before\n<!-- begin plain -->\nold\n<!-- end plain -->\nafter\n";
    const CommandResult result = run_command(
        tiny({"--taps", "1x2", "2x3", "--validation", "--json", file.string(), "--page", page.string()}));
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| gtao | 2 x 3 |"));
    EXPECT_EQ(read_file(page),
              "before\n<!-- begin plain -->\n\n" + result.out + "\n<!-- end plain -->\nafter\n");
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    ASSERT_EQ(document.at("comparisons").size(), 2U);
    const json& row = document.at("comparisons").at(1);
    EXPECT_EQ(row.at("slices"), 2);
    EXPECT_EQ(row.at("steps"), 3);
    ASSERT_EQ(row.at("plain_ms").size(), 2U);
    const double first = double{row.at("method_ms").at(0)} / double{row.at("plain_ms").at(0)};
    const double second = double{row.at("method_ms").at(1)} / double{row.at("plain_ms").at(1)};
    EXPECT_NEAR(double{row.at("ratio").at("median")}, 0.5 * (first + second), 1e-9);
    EXPECT_GT(double{row.at("rms_difference")}, 0.0);
}

TEST(BenchPlain, WrongOptionsAreNamed) {
    const TemporaryDirectory folder;
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "no block\n";
    expect_could_not_run(run_command(tiny({"--method", "alchemy"})), "alchemy: its samples are not slices");
    expect_could_not_run(run_command(tiny({"--method", "magic"})), "magic");
    expect_could_not_run(run_command(tiny({"--taps", "3"})), "3: expected SLICESxSTEPS");
    expect_could_not_run(run_command(tiny({"--taps", "65x1"})), "65x1: expected SLICESxSTEPS");
    expect_could_not_run(run_command(tiny({"--scene", "nowhere"})), "nowhere");
    expect_could_not_run(run_command(tiny({"--page", page.string()})), "begin plain");
    expect_could_not_run(run_command({"bench", "plain", "--rounds", "0"}), "--rounds");
}

}  // namespace bench_plain_test
}  // namespace gloam::test
