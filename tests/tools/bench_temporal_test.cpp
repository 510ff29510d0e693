// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_temporal_test {

using nlohmann::json;
using testing::HasSubstr;

std::vector<std::string> tiny(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"bench",  "temporal", "--case",   "moving",      "moving, still",
                                       "--size", "32x18",    "--frames", "9",           "--scored",
                                       "5",      "--rays",   "32",       "--validation"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(BenchTemporal, WritesWhatItMeasured) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "temporal.json";
    const auto out = folder.path() / "out";
    const CommandResult result = run_command(tiny({"--json", file.string(), "--out", out.string()}));
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("| moving | neighbourhood (9) off: the history counts in full | 0."));
    EXPECT_THAT(result.out, HasSubstr("| moving, still | 16 | "));
    EXPECT_THAT(result.out, HasSubstr(", at most 0.01: "));
    EXPECT_THAT(read_file(out / "moving-still-convergence.svg"), HasSubstr("<svg"));
    EXPECT_THAT(read_file(out / "moving-near_moving.svg"), HasSubstr("same view, still"));
    for (const char* kind : {"visibility", "error", "convergence", "samples", "limit"})
        EXPECT_THAT(read_file(out / (std::string("moving-full-") + kind + ".png")), HasSubstr("PNG"));
    const json document = json::parse(read_file(file));
    std::size_t sequences = 0;
    for (const json& visit : document.at("visits")) {
        const json& scores = visit.at("quality").at("by_class");
        const bool still = visit.at("case") == "moving, still";
        ASSERT_EQ(scores.at("frames").size(), still ? 32U : 2U) << visit.at("candidate");
        EXPECT_EQ(scores.at("frames").back().at("frame"), still ? 32 : 9);
        for (const json& frame : scores.at("frames")) {
            const json& first = frame.at("classes").at(0);
            EXPECT_EQ(first.at("pixels"), "all");
            EXPECT_EQ(first.at("against"), "limit");
            EXPECT_GT(first.at("raw_squares"), 0.0) << visit.at("candidate");
        }
        sequences += scores.at("flicker").empty() ? 0 : 1;
    }
    EXPECT_EQ(sequences, 18U) << "but for single frames and what stands still";

    // The same tables from the journal, with the pictures that were drawn before.
    const CommandResult again = run_command(tiny({"--resume", "--out", out.string()}));
    expect_success(again);
    EXPECT_EQ(again.out, result.out);
    EXPECT_THAT(read_file(out / "moving-full-error.png"), HasSubstr("PNG"));
}

TEST(BenchTemporal, BadInputIsOneClearLine) {
    expect_could_not_run(run_command({"bench", "temporal", "--case", "nowhere"}), "nowhere");
    expect_could_not_run(run_command({"bench", "temporal", "--size", "8x8"}), "--size 8x8");
    expect_could_not_run(run_command({"bench", "temporal", "--frames", "0"}), "--frames");
    expect_could_not_run(run_command({"bench", "temporal", "--frames", "4", "--scored", "5"}), "5 scored");
    expect_could_not_run(run_command({"bench", "temporal", "--json", "/no/such/folder/a.json"}),
                         "/no/such/folder");
}

}  // namespace bench_temporal_test
}  // namespace gloam::test
