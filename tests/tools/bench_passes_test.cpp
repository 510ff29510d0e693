// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_passes_test {

using nlohmann::json;
using testing::HasSubstr;

TEST(BenchPasses, PrintsATableAndWritesEveryNumber) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "passes.json";
    const CommandResult result = run_command(
        {"bench", "passes", "--size", "96x54", "--rounds", "1", "--validation", "--json", file.string()});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| fresh | "));
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    EXPECT_GT(document.at("copy_ms"), 0.0);
    bool reprojected = false;
    for (const json& state : document.at("cases")) {
        bool shaded = false;
        for (const json& pass : state.at("passes")) {
            EXPECT_GT(pass.at("ms"), 0.0) << state.at("state") << ' ' << pass.at("pass");
            EXPECT_GT(pass.at("copies"), 0.0);
            shaded |= pass.at("pass") == "ambient_occlusion";
            reprojected |= pass.at("pass") == "reproject";
        }
        EXPECT_TRUE(shaded) << state.at("state");
    }
    EXPECT_TRUE(reprojected) << "no state in which the view moves";
    ASSERT_EQ(document.at("history_copies").size(), 3U);
    for (const json& copy : document.at("history_copies"))
        EXPECT_GT(copy.at("copies"), 0.0) << copy.at("precision");
    EXPECT_THAT(result.out, HasSubstr("| history, packed | "));
}

TEST(BenchPasses, WrongOptionsAreNamed) {
    expect_could_not_run(run_command({"bench", "passes", "--size", "8x8"}), "8x8");
    expect_could_not_run(run_command({"bench", "passes", "--rounds", "0"}), "--rounds");
}

}  // namespace bench_passes_test
}  // namespace gloam::test
