// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_skips_test {

using nlohmann::json;
using testing::HasSubstr;

TEST(BenchSkips, PrintsATableAndWritesEveryNumber) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "skips.json";
    const CommandResult result = run_command(
        {"bench", "skips", "--size", "96x54", "--rounds", "1", "--validation", "--json", file.string()});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| sky | mostly sky"));
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    ASSERT_EQ(document.at("cases").size(), 7U);
    for (const json& row : document.at("cases")) {
        for (const char* time : {"copy_ms", "without_ms", "with_ms", "background_ms", "open_ms", "closed_ms",
                                 "settled_ms", "first_frame_ms"})
            EXPECT_GT(row.at(time), 0.0) << row.at("scene") << ' ' << time;
    }
    EXPECT_GT(document.at("cases").at(0).at("tiles_blank"), 0);
    EXPECT_GT(document.at("cases").at(1).at("tiles_open"), 0);
    EXPECT_GT(document.at("cases").at(5).at("pixels_ended_early"), 0);
    EXPECT_GT(document.at("cases").at(6).at("pixels_ended_early"), 0);
    ASSERT_EQ(document.at("shares").size(), 14U);
    for (const json& row : document.at("shares")) {
        const double tiles = row.at("tiles");
        const char* counter = row.at("part") == "open"      ? "tiles_open"
                              : row.at("part") == "settled" ? "tiles_settled"
                                                            : "tiles_blank";
        EXPECT_LE(row.at(counter).get<double>() / tiles, row.at("share").get<double>() + 0.02) << row;
        if (row.at("share") >= 0.75) {
            EXPECT_GT(row.at(counter), 0) << row;
        }
        EXPECT_GT(row.at("with_ms"), 0.0);
    }
    const json& settled = document.at("cases").at(4);
    EXPECT_EQ(settled.at("tiles_settled").get<int>() + settled.at("tiles_blank").get<int>(),
              settled.at("tiles"));
}

TEST(BenchSkips, WrongOptionsAreNamed) {
    expect_could_not_run(run_command({"bench", "skips", "--size", "8x8"}), "8x8");
    expect_could_not_run(run_command({"bench", "skips", "--rounds", "0"}), "--rounds");
}

}  // namespace bench_skips_test
}  // namespace gloam::test
