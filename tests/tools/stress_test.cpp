// SPDX-License-Identifier: MIT
#include "tools/gloam.hpp"

namespace gloam::test::stress_test {

class Stress : public InFolder {};

TEST_F(Stress, WritesWhatItMeasured) {
    const auto file = path("stress.json");
    const std::string result = output_of(gloam("stress --only far --seed 5 --json {}", file));
    EXPECT_THAT(result, HasSubstr("0 bounds broken"));
    const json document = json::parse(read_file(file));
    EXPECT_NE(document.at("device").at("name"), "");
    ASSERT_FALSE(document.at("rows").empty());
    for (const json& row : document.at("rows")) {
        EXPECT_EQ(row.at("run"), "far");
        EXPECT_EQ(row.at("passed"), true);
        EXPECT_TRUE(row.at("measured").is_number() && (row.at("bound").is_null() || row.at("bound") < 1.0));
        EXPECT_THAT(result, HasSubstr(row.at("varied").get<std::string>()));
    }
}

TEST_F(Stress, ABrokenBoundIsStatusOne) {
    const Installation broken;
    broken.replace("gloam/temporal/blend.glsl", "total < cap ? total : cap", "total");
    const CommandResult result = broken.gloam("stress --only long-run --frames 400");
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.out, HasSubstr("BROKEN"));
}

// Whoever stops it has what was found until then.
TEST_F(Stress, RowsAppearAsTheyAreFound) {
    const std::string report = path("rows.txt").string();
    const std::string call =
        fmt::format("timeout -s INT 60 {} stress --only worst-inputs --brief | head -n 8 > {}",
                    GLOAM_BUILT_BINARY, report);
    (void)run_program("/bin/bash", {"-c", call});
    EXPECT_EQ(line_count(read_file(report)), 8);
}

}  // namespace gloam::test::stress_test
