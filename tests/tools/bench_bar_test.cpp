// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_bar_test {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

Arguments tiny(const Arguments& more) {
    Arguments arguments{"bench", "bar", "--size", "64x36", "--frames", "4", "--rays", "32", "--rounds", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchBar, ARunIsHeldAgainstPlainSlices) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "bar.json";
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "before\n<!-- begin bar -->\nold\n<!-- end bar -->\nafter\n";
    const CommandResult result = run_command(
        tiny({"--scene", "moving", "--validation", "--json", file.string(), "--page", page.string()}));
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| moving |"));
    EXPECT_EQ(read_file(page), "before\n<!-- begin bar -->\n\n" + result.out + "\n<!-- end bar -->\nafter\n");
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    ASSERT_EQ(document.at("scenes").size(), 1U);
    const json& row = document.at("scenes").at(0);
    EXPECT_EQ(row.at("readings"), 4U);  // two frames are scored, twice
    for (const char* time :
         {"ms", "gather_ms", "fast_ms", "exact_ms", "time_ratio", "time_ratio_to_slices"}) {
        EXPECT_GT(double{row.at(time).at("low")}, 0.0) << time;
        EXPECT_LE(double{row.at(time).at("low")}, double{row.at(time).at("median")}) << time;
        EXPECT_LE(double{row.at(time).at("median")}, double{row.at(time).at("high")}) << time;
    }
    EXPECT_GT(double{row.at("ms").at("median")}, double{row.at("gather_ms").at("median")});
    EXPECT_GT(double{row.at("flicker")}, 0.0);
    const double error = row.at("rmse_geometry").at("shown");
    const double exact = row.at("rmse_geometry_exact").at("shown");
    EXPECT_GT(error, 0.0);
    EXPECT_LT(exact, double{row.at("rmse_geometry_fast").at("shown")});
    EXPECT_DOUBLE_EQ(double{row.at("error_ratio")}, error / exact);
}

// A run that shows no occlusion at all misses any bar.
TEST(BenchBar, SaysWhatIsMissed) {
    const Arguments nothing{"--scene", "moving", "--set", "intensity=0"};
    const CommandResult told = run_command(tiny(nothing));
    expect_success(told);
    EXPECT_THAT(told.out, HasSubstr("`fast, intensity=0`"));
    EXPECT_THAT(told.out, HasSubstr("**not met**"));
    Arguments strict = nothing;
    strict.emplace_back("--fail-if-missed");
    EXPECT_EQ(run_command(tiny(strict)).status, 1);
}

TEST(BenchBar, WrongOptionsAreNamed) {
    const TemporaryDirectory folder;
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "no block\n";
    expect_could_not_run(run_command(tiny({"--scene", "corner"})), "corner: its camera stands still");
    expect_could_not_run(run_command(tiny({"--scene", "nowhere"})), "nowhere");
    expect_could_not_run(run_command(tiny({"--preset", "magic"})), "magic");
    expect_could_not_run(run_command(tiny({"--error-of", "magic"})), "magic: expected SLICESxSTEPS");
    expect_could_not_run(run_command(tiny({"--time-of", "0x2"})), "0x2: expected SLICESxSTEPS");
    expect_could_not_run(run_command(tiny({"--method", "magic"})), "magic");
    expect_could_not_run(run_command(tiny({"--set", "magic=1"})), "magic");
    expect_could_not_run(run_command({"bench", "bar", "--frames", "1"}), "--frames");
    expect_could_not_run(run_command({"bench", "bar", "--rounds", "0"}), "--rounds");
    expect_could_not_run(run_command({"bench", "bar", "--size", "8x8"}), "8x8");
    expect_could_not_run(run_command(tiny({"--page", page.string()})), "begin bar");
}

}  // namespace bench_bar_test
}  // namespace gloam::test
