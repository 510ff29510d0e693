// SPDX-License-Identifier: MIT
#include "report/benchmark/summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace gloam::report {
namespace summary_test {

using testing::ElementsAre;
using testing::Pair;

TEST(BenchmarkSummary, ThePassesThatTakeSamplesAreTheGather) {
    EXPECT_TRUE(is_gather("ambient_occlusion"));
    EXPECT_TRUE(is_gather("ambient_occlusion_quarter"));
    EXPECT_FALSE(is_gather("filter_x"));
    EXPECT_FALSE(is_gather(""));
}

TEST(BenchmarkSummary, TimesAreMediansAndCopiesThoseOfTheirMoment) {
    const std::array readings{Reading{{{"ambient_occlusion", 3.0}, {"filter_x", 1.0}}, 0.1},
                              Reading{{{"ambient_occlusion", 6.0}, {"filter_x", 2.0}}, 0.2},
                              Reading{{{"reproject", 1.0}, {"ambient_occlusion", 4.0}}, 0.1}};
    const Row row = row_of({.scene = "s", .method = "m", .samples = 4}, {.geometry = 0.5}, readings);
    EXPECT_EQ(row.readings, 3U);
    EXPECT_EQ(row.quality.geometry, 0.5);
    EXPECT_EQ(row.gather_ms.median, 4.0);
    EXPECT_EQ(row.total_ms.median, 5.0);
    EXPECT_DOUBLE_EQ(row.gather_copies.median, 30.0);
    EXPECT_DOUBLE_EQ(row.total_copies.median, 40.0);  // 40, 40, 50: drift cancels
    EXPECT_THAT(row.passes,
                ElementsAre(Pair("ambient_occlusion", 4.0), Pair("filter_x", 1.5), Pair("reproject", 1.0)));
}

TEST(BenchmarkSummary, WithoutReadingsNothingIsKnown) {
    const Row row = row_of({}, {}, {});
    EXPECT_TRUE(std::isnan(row.total_copies.median));
    EXPECT_TRUE(std::isnan(row.quality.geometry));
    EXPECT_TRUE(row.passes.empty());
}

TEST(BenchmarkSummary, KeysNameConfigurations) {
    EXPECT_EQ(key_of({.scene = "s", .method = "m", .samples = 4}), "s/m/4/single");
    EXPECT_EQ(key_of({.scene = "s", .method = "m", .preset = "p", .samples = 8, .temporal = true}),
              "s/p/8/temporal");
    EXPECT_EQ(choice_of({.scene = "s", .method = "m", .samples = 4}), "m/4/single");
}

}  // namespace summary_test
}  // namespace gloam::report
