// SPDX-License-Identifier: MIT
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_views_test {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

Arguments tiny(const Arguments& more) {
    Arguments arguments{"bench", "views",    "--size", "48x27",  "--frames",
                        "3",     "--scored", "2",      "--rays", "32"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchViews, MeasuresPresetsOnBothHalves) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "views.json";
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "before\n<!-- begin views -->\n<!-- end views -->\nafter\n";
    const CommandResult result = run_command(
        tiny({"--view", "moving", "room", "--single", "gtao-quality", "sweep-quality", "--sequence",
              "sweep-quality", "--validation", "--json", file.string(), "--page", page.string()}));
    expect_success(result);
    EXPECT_THAT(read_file(page), HasSubstr(result.out));
    EXPECT_THAT(result.out, HasSubstr("| moving | scene | tuning |"));
    EXPECT_THAT(result.out, HasSubstr("| room | scene | unseen |"));
    const json document = json::parse(read_file(file));
    ASSERT_EQ(document.at("views").size(), 2U);
    for (const json& view : document.at("views")) {
        ASSERT_EQ(view.at("results").size(), 3U);
        EXPECT_GT(double{view.at("rmse_depth_truth")}, 0.0);
        for (const json& cell : view.at("results")) {
            EXPECT_GT(double{cell.at("copies")}, 0.0);
            EXPECT_GT(double{cell.at("rmse_geometry")}, std::abs(double{cell.at("bias")}));
        }
        EXPECT_LT(double{view.at("results").at(1).at("rmse_geometry")},
                  double{view.at("results").at(0).at("rmse_geometry")});
        EXPECT_TRUE(view.at("results").at(0).at("flicker").is_null());
        EXPECT_FALSE(view.at("results").at(2).at("flicker").is_null());
    }
    // The means' row of a half with one view holds that view's error and its ratio to the first.
    const json& unseen = document.at("views").at(1).at("results");
    EXPECT_EQ(document.at("views").at(1).at("half"), "unseen");
    const double error = unseen.at(1).at("rmse_geometry");
    const double base = unseen.at(0).at("rmse_geometry");
    EXPECT_THAT(result.out, HasSubstr(fixed(error, 4) + " | "));
    EXPECT_THAT(result.out, HasSubstr(fixed(error / base, 2) + " | "));
}

TEST(BenchViews, AHalfAlone) {
    const CommandResult result = run_command(
        tiny({"--view", "moving", "room", "--half", "unseen", "--single", "fast", "--rounds", "0"}));
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("1 views"));
    EXPECT_THAT(result.out, HasSubstr("| room | scene | unseen |"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("| moving |")));
}

TEST(BenchViews, WrongOptionsAreNamed) {
    expect_could_not_run(run_command(tiny({})), "--single or --sequence");
    expect_could_not_run(run_command(tiny({"--single", "magic"})), "magic");
    expect_could_not_run(run_command(tiny({"--single", "fast", "--view", "magic"})), "--view magic");
    expect_could_not_run(run_command(tiny({"--single", "fast", "--half", "magic"})), "magic");
    expect_could_not_run(run_command(tiny({"--single", "fast", "--set", "magic=1"})), "magic");
    expect_could_not_run(run_command(tiny({"--single", "fast", "--view", "bunny", "--meshes", "/nowhere"})),
                         "/nowhere/bunny.obj");
    expect_could_not_run(
        run_command({"bench", "views", "--single", "fast", "--frames", "2", "--scored", "3"}), "--scored 3");
}

}  // namespace bench_views_test
}  // namespace gloam::test
