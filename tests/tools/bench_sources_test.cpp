// SPDX-License-Identifier: MIT
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tools/expect.hpp"
#include "tools/installation.hpp"

namespace gloam::test {
namespace bench_sources_test {

using nlohmann::json;
using testing::HasSubstr;

// Each experiment has all its rows, equal configurations have equal errors, and the printed numbers are the
// written ones.
TEST(BenchSources, RepeatsTheExperiments) {
    const TemporaryDirectory folder;
    const auto file = folder.path() / "sources.json";
    const auto page = folder.path() / "page.md";
    std::ofstream(page) << "before\n<!-- begin issao_table -->\n<!-- end issao_table -->\n"
                        << "<!-- begin quality -->\nold\n<!-- end quality -->\n"
                        << "<!-- begin radius -->\nold\n<!-- end radius -->\n";
    expect_success(run_command({"bench", "sources", "--table-scene", "corner", "--scene", "relief", "--size",
                                "64x36", "--rounds", "1", "--rays", "32", "--validation", "--json",
                                file.string(), "--page", page.string()}));
    const json document = json::parse(read_file(file));
    const json& table = document.at("issao_table");
    ASSERT_EQ(table.size(), 8U);  // four methods, each without and with the filter
    for (std::size_t i = 0; i < 8; i += 2) {
        EXPECT_EQ(table[i].at("configuration"), table[i + 1].at("configuration"));
        EXPECT_EQ(table[i].at("filter_ms"), 0.0);
        EXPECT_GT(table[i + 1].at("filter_ms"), 0.0);
        EXPECT_EQ(table[i].at("samples_taken"), table[i + 1].at("samples_taken"));
        EXPECT_NE(table[i].at("error"), table[i + 1].at("error"));
        EXPECT_EQ(table[i].at("error"), table[i].at("error_smaller_radius"));
    }
    EXPECT_LT(table[6].at("samples_taken"), 12.0);  // ISSAO's: fewer where the radius is small
    const json& quality = document.at("quality");
    ASSERT_EQ(quality.size(), 7U);
    for (const json& row : quality) {
        EXPECT_EQ(row.at("filter_ms"), 0.0);
        EXPECT_LE(row.at("error_remapped"), row.at("error"));
        EXPECT_GE(row.at("samples"), 2);  // one sample is too few for any of them
    }
    const json& radius = document.at("radius");
    ASSERT_EQ(radius.size(), 18U);  // six configurations, each in three ways
    for (std::size_t i = 0; i < 18; i += 3) {
        EXPECT_EQ(radius[i].at("error"), radius[i].at("error_smaller_radius"));
        EXPECT_NE(radius[i + 1].at("error"), radius[i + 1].at("error_smaller_radius"));
        EXPECT_EQ(radius[i + 1].at("radius"), 2.0);
        EXPECT_EQ(radius[i + 1].at("samples"), radius[i].at("samples"));
        EXPECT_EQ(radius[i + 2].at("samples"), 2 * radius[i].at("samples").get<int>());
        EXPECT_GT(radius[i + 2].at("occlusion_ms"), 0.0);
    }
    EXPECT_THAT(read_file(page), HasSubstr("| relief | volumetric-performance | radius doubled | 12 |"));
    EXPECT_THAT(read_file(page), testing::Not(HasSubstr("old")));
}

TEST(BenchSources, WrongOptionsAreNamed) {
    expect_could_not_run(run_command({"bench", "sources", "--scene", "releif"}), "releif");
    expect_could_not_run(run_command({"bench", "sources", "--size", "8x8"}), "8x8");
    expect_could_not_run(run_command({"bench", "sources", "--page", "/no/such.md"}), "/no/such.md");
}

}  // namespace bench_sources_test
}  // namespace gloam::test
