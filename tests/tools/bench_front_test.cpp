// SPDX-License-Identifier: MIT
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_front_test {

using nlohmann::json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

struct Mean {
    double rmse = 0.0;    // arithmetic
    double copies = 0.0;  // geometric
};

Mean mean_of(const json& size, std::size_t run) {
    Mean sum;
    for (const json& view : size.at("views")) {
        sum.rmse += double{view.at("runs").at(run).at("rmse_geometry")};
        sum.copies += std::log(double{view.at("runs").at(run).at("copies")});
    }
    const auto views = static_cast<double>(size.at("views").size());
    return {sum.rmse / views, std::exp(sum.copies / views)};
}

bool beaten(const json& size, std::size_t run, std::size_t runs) {
    const Mean own = mean_of(size, run);
    for (std::size_t other = 0; other < runs; ++other)
        if (mean_of(size, other).rmse < own.rmse && mean_of(size, other).copies < own.copies) return true;
    return false;
}

std::string fixed(double value, int digits) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

Arguments tiny(const Arguments& more) {
    Arguments arguments{"bench", "front",    "--size", "48x27",  "64x36", "--frames",
                        "3",     "--scored", "2",      "--rays", "32"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchFront, ShowsPresetsBesideThePlainLoopAtEachSize) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "front.json";
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "before\n<!-- begin front -->\n<!-- end front -->\nafter\n";
    const CommandResult result = run_command(tiny({"--view", "room", "knot", "moving", "plan", "--sequence",
                                                   "fast", "balanced,samples=4,filter=none", "--validation",
                                                   "--json", file.string(), "--page", page.string()}));
    expect_success(result);
    EXPECT_THAT(read_file(page), HasSubstr(result.out));
    for (const char* text : {"2 views", "48 x 27", "64 x 36", "| plain loop, 9 x 3 |", "scene (2)",
                             "| plain loop, 1 x 2 and a blur |", "| plain loop, 3 x 3 and 2 blurs |",
                             "| sweep-quality, single |", "| balanced,samples=4,filter=none, sequence |"})
        EXPECT_THAT(result.out, HasSubstr(text));
    const json document = json::parse(read_file(file));
    ASSERT_EQ(document.at("sizes").size(), 2U);
    for (const json& size : document.at("sizes")) {
        ASSERT_EQ(size.at("views").size(), 2U);  // moving is of the other half, plan is orthographic
        const json& runs = size.at("views").at(0).at("runs");
        ASSERT_EQ(runs.size(), 6U);
        for (const json& run : runs) EXPECT_GT(double{run.at("copies")}, 0.0);
        EXPECT_GT(double{runs.at(1).at("rmse_geometry")}, double{runs.at(0).at("rmse_geometry")});
        EXPECT_LT(double{runs.at(3).at("rmse_geometry")}, double{runs.at(0).at("rmse_geometry")});
        EXPECT_TRUE(runs.at(3).at("flicker").is_null());
        EXPECT_GT(double{runs.at(4).at("flicker")}, 0.0);
        for (std::size_t run = 0; run < runs.size(); ++run) {
            const Mean mean = mean_of(size, run);
            const std::string mark = beaten(size, run, runs.size()) ? "" : "**";
            EXPECT_THAT(result.out, HasSubstr(" " + mark + fixed(mean.rmse, 4) + mark + " | " +
                                              fixed(mean.rmse / mean_of(size, 0).rmse, 2) + " | " + mark +
                                              fixed(mean.copies, 1) + mark + " |"));
        }
    }
}

TEST(BenchFront, WrongOptionsAreNamed) {
    expect_could_not_run(run_command(tiny({"--plain", "9x3"})), "--plain 9x3: expected SLICESxSTEPS+BLURS");
    expect_could_not_run(run_command(tiny({"--plain", "9+1"})), "expected SLICESxSTEPS");
    expect_could_not_run(run_command(tiny({"--sequence", "fast,magic=1"})), "magic");
    expect_could_not_run(run_command(tiny({"--view", "plan"})), "no perspective view");
    expect_could_not_run(run_command({"bench", "front", "--frames", "2", "--scored", "3"}), "--scored 3");
}

}  // namespace bench_front_test
}  // namespace gloam::test
