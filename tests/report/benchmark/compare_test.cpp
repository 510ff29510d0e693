// SPDX-License-Identifier: MIT
#include "report/benchmark/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "report/benchmark/join.hpp"
#include "report/benchmark_rows.hpp"

namespace gloam::report {
namespace compare_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(BenchmarkCompare, TheSameIsNoChange) {
    const Benchmark benchmark = make_benchmark({make_row("a", "m", 4, 10, 0.05)});
    const Comparison same = compared(benchmark, benchmark);
    EXPECT_FALSE(same.got_worse());
    EXPECT_THAT(same.warnings, IsEmpty());
    EXPECT_DOUBLE_EQ(same.time, 1.0);
    EXPECT_DOUBLE_EQ(same.error, 1.0);
    EXPECT_THAT(to_text(same), HasSubstr("nothing got worse"));
}

TEST(BenchmarkCompare, ATimeChangesBeyondItsSpread) {
    const Benchmark before = make_benchmark(
        {make_row("a", "m", 4, 10, 0.05), make_row("a", "n", 4, 10, 0.05), make_row("a", "o", 4, 10, 0.05)});
    const Benchmark after = make_benchmark(
        {make_row("a", "m", 4, 12, 0.05), make_row("a", "n", 4, 13, 0.05), make_row("a", "o", 4, 8, 0.05)});
    const Comparison found = compared(before, after);
    EXPECT_FALSE(found.changes[0].slower);  // 10.8 to 13.2 after 9 to 11
    EXPECT_TRUE(found.changes[1].slower);   // 11.7 to 14.3
    EXPECT_FALSE(found.changes[1].faster);
    EXPECT_TRUE(found.changes[2].faster);  // 7.2 to 8.8
    EXPECT_DOUBLE_EQ(found.changes[1].time.median, 1.3);
    EXPECT_DOUBLE_EQ(found.changes[1].time.low, 11.7 / 11.0);
    EXPECT_DOUBLE_EQ(found.changes[1].time.high, 14.3 / 9.0);
    EXPECT_NEAR(found.time, std::cbrt(1.2 * 1.3 * 0.8), 1e-12);
    EXPECT_TRUE(found.got_worse());
    EXPECT_THAT(to_text(found), HasSubstr("slower, beyond the spread: 1\n  a/n/4/single"));
    EXPECT_THAT(to_text(found), Not(HasSubstr("nothing got worse")));
}

TEST(BenchmarkCompare, AnErrorThatRisesIsNamed) {
    const Benchmark before =
        make_benchmark({make_row("a", "m", 4, 10, 0.0500), make_row("a", "n", 4, 10, 0.05)});
    const Benchmark after =
        make_benchmark({make_row("a", "m", 4, 10, 0.0502), make_row("a", "n", 4, 10, 0.04)});
    const Comparison found = compared(before, after);
    EXPECT_TRUE(found.changes[0].worse);
    EXPECT_TRUE(found.changes[1].better);
    EXPECT_TRUE(found.got_worse());
    EXPECT_FALSE(compared(after, after).got_worse());
    EXPECT_FALSE(compared(make_benchmark({make_row("a", "m", 4, 10, 0.05)}),
                          make_benchmark({make_row("a", "m", 4, 10, 0.05001)}))
                     .got_worse());
}

TEST(BenchmarkCompare, WarnsOfOtherCircumstancesAndStillCompares) {
    const Benchmark before = make_benchmark({make_row("a", "m", 4, 10, 0.05), make_row("a", "old", 4, 1, 1)});
    Benchmark after = make_benchmark({make_row("a", "m", 4, 20, 0.05), make_row("a", "new", 4, 1, 1)});
    after.device = "another";
    after.width = 640;
    after.rays = 64;
    const Comparison found = compared(before, after);
    EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("other devices: device"),
                                            HasSubstr("other sizes: 320x180"), HasSubstr("256 rays")));
    ASSERT_EQ(found.changes.size(), 1U);
    EXPECT_DOUBLE_EQ(found.changes.front().time.median, 2.0);
    EXPECT_THAT(found.only_old, ElementsAre("a/old/4/single"));
    EXPECT_THAT(found.only_new, ElementsAre("a/new/4/single"));
    EXPECT_THAT(to_text(found), testing::StartsWith("warning: other devices"));
}

TEST(BenchmarkJoin, PutsPartsTogether) {
    Benchmark rows = make_benchmark({make_row("a", "m", 4, 10, 0.05)});
    const Benchmark more = make_benchmark({make_row("b", "m", 4, 10, 0.05)});
    const Benchmark extra{.device = rows.device, .driver = rows.driver, .framework = {{"figure", "ms", 1.0}}};
    const Benchmark whole = joined(std::vector{extra, rows, more});
    EXPECT_EQ(whole.rows.size(), 2U);
    EXPECT_EQ(whole.width, 320U);
    EXPECT_EQ(whole.framework.size(), 1U);
}

TEST(BenchmarkJoin, RefusesWhatDoesNotBelongTogether) {
    const Benchmark one = make_benchmark({make_row("a", "m", 4, 10, 0.05)});
    Benchmark other = make_benchmark({make_row("b", "m", 4, 10, 0.05)});
    const auto refusal = [&](const Benchmark& part, const char* text) {
        EXPECT_THAT([&] { (void)joined(std::vector{one, part}); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
    };
    refusal(one, "a/m/4/single: in two results");
    other.width = 640;
    refusal(other, "expected the same");
    other.device = "another";
    refusal(other, "expected one device");
    EXPECT_THAT([] { (void)joined({}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("expected one or more")));
}

}  // namespace compare_test
}  // namespace gloam::report
