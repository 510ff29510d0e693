// SPDX-License-Identifier: MIT
#include "stress/run.hpp"

#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tools/stress/support.hpp"

namespace gloam::stress::test::report_test {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Report, ABoundIsBrokenByMoreAndByNaN) {
    EXPECT_TRUE((Row{.measured = 2.0, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = 2.1, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = inf}.passed()));
    EXPECT_TRUE((Row{.measured = inf}.passed()));
}

TEST(Report, JsonHoldsEveryRow) {
    const auto json = nlohmann::json::parse(to_json(
        {.name = "device", .driver = "driver"},
        {{"run", "a", "b", 0.5, 1.0}, {"run", "c", "d", inf, std::nullopt}, {"run", "e", "f", nan, 0.0}}));
    EXPECT_EQ(json.at("device").at("name"), "device");
    EXPECT_EQ(json.at("device").at("driver"), "driver");
    ASSERT_EQ(json.at("rows").size(), 3U);
    EXPECT_EQ(json.at("rows")[0], (nlohmann::json{{"run", "run"},
                                                  {"varied", "a"},
                                                  {"quantity", "b"},
                                                  {"measured", 0.5},
                                                  {"bound", 1.0},
                                                  {"passed", true}}));
    EXPECT_TRUE(json.at("rows")[1].at("bound").is_null());
    EXPECT_EQ(json.at("rows")[1].at("measured"), "inf");
    EXPECT_EQ(json.at("rows")[2].at("measured"), "nan");
    EXPECT_EQ(json.at("rows")[2].at("passed"), false);
}

TEST(Report, LinesSayTheVerdict) {
    EXPECT_THAT(table_line({"run", "a", "b", 0.5, 1.0}), testing::EndsWith(" ok"));
    EXPECT_THAT(table_line({"run", "a", "b", 1.5, 1.0}), testing::EndsWith(" BROKEN"));
    EXPECT_THAT(table_line({"run", "a", "b", 1.5, std::nullopt}), testing::EndsWith(" measured"));
    EXPECT_EQ(table_line({"run", "a", "b", 0.5, 1.0}).find("0.5"), table_header().find("value") + 2);
}

TEST(Runs, ByNameOrAll) {
    EXPECT_EQ(select_runs("").size(), all_runs().size());
    for (const stress::Run& run : all_runs()) {
        ASSERT_EQ(select_runs(run.name).size(), 1U);
        EXPECT_EQ(select_runs(run.name).front().go, run.go);
        EXPECT_FALSE(run.description.empty());
    }
    EXPECT_THROW((void)select_runs("no-such-run"), std::invalid_argument);
}

}  // namespace gloam::stress::test::report_test
