// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_temporal_test {

using nlohmann::json;
using testing::HasSubstr;

TEST(BenchTemporal, WritesWhatItMeasured) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "temporal.json";
    const auto out = folder.path() / "pictures";
    const CommandResult result = run_command(
        {"bench", "temporal", "--scene", "moving", "--size", "32x18", "--frames", "6", "--still-frames", "4",
         "--every", "2", "--rays", "32", "--validation", "--json", file.string(), "--out", out.string()});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("neighbourhood (9)"));
    EXPECT_EQ(read_file(out / "moving.md") + "\n", result.out);
    EXPECT_THAT(read_file(out / "moving-convergence.svg"), HasSubstr("<svg"));
    EXPECT_THAT(read_file(out / "moving-full-ao.png"), HasSubstr("PNG"));
    const json document = json::parse(read_file(file));
    EXPECT_THAT(document.at("versions"), HasSubstr("gloam"));
    const json& scene = document.at("scenes").at(0);
    EXPECT_EQ(scene.at("still").size(), 4U);
    EXPECT_EQ(scene.at("scored_frames"), json({0, 2, 4}));
    EXPECT_GT(scene.at("runs").size(), 15U);
    for (const json& run : scene.at("runs")) {
        EXPECT_EQ(run.at("frames").size(), 3U);
        EXPECT_GT(run.at("frames").at(2).at("raw").at("limit").at("all").at("rmse"), 0.0) << run.at("off");
    }
}

TEST(BenchTemporal, BadInputIsOneClearLine) {
    expect_could_not_run(run_command({"bench", "temporal", "--scene", "nowhere"}), "nowhere");
    expect_could_not_run(run_command({"bench", "temporal", "--size", "8x8"}), "--size 8x8");
    expect_could_not_run(run_command({"bench", "temporal", "--preset", "none"}), "none");
    expect_could_not_run(run_command({"bench", "temporal", "--frames", "1"}), "--frames");
    expect_could_not_run(run_command({"bench", "temporal", "--json", "/no/such/folder/a.json"}),
                         "/no/such/folder");
}

}  // namespace bench_temporal_test
}  // namespace gloam::test
