// SPDX-License-Identifier: MIT
#include "support/entries.hpp"
#include "support/test.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::runs_test {

TEST(LongRun, StaysWithinItsBounds) {
    const Bench bench;
    const Rows rows = rows_of(long_run, bench.context());
    expect_all_passed(rows);
    const Rows farthest = rows_with(rows, "farthest from the exact mean", "k 8, w_max 1500");
    ASSERT_EQ(farthest.size(), 1U);
    EXPECT_GT(farthest[0].measured, 0.0);
}

// Relative to the eye nothing depends on the place; relative to the world's origin all grows with it.
TEST(Far, OnlyWorldCoordinatesLosePrecision) {
    const Bench bench;
    const Rows rows = rows_of(far_away, bench.context());
    expect_all_passed(rows);
    for (std::size_t i = 0; i < 8; ++i)  // those of 1e2 and 1e7
        EXPECT_TRUE(i < 4 ? rows[i + 40].measured == rows[i].measured
                          : rows[i + 40].measured > 2.0 * rows[i].measured)
            << rows[i + 40].varied;
    const Rows of_halves = rows_with(rows, "occlusion of a bare wall (gtao)", "0.001 radii");
    ASSERT_EQ(of_halves.size(), 1U);
    EXPECT_GT(of_halves[0].measured, 0.01);
}

using WorstInputs = OfEach<std::size_t>;

TEST_P(WorstInputs, StayWithinWhatIsDocumentedAndAreAtLeastAsBadAsRandomOnes) {
    const catalogue::Entry& entry = gloam::test::entries()[GetParam()];
    const Rows rows =
        rows_of([&](const Context& context) { worst_inputs(context, entry); }, bench->context());
    ASSERT_EQ(rows.size(), 2U);
    expect_all_passed(rows);
    EXPECT_GE(rows[0].measured, rows[1].measured);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WorstInputs, gloam::test::entry_numbers(), gloam::test::entry_name);

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Report, ABoundIsBrokenByMoreAndByNaN) {
    EXPECT_TRUE((Row{.measured = 2.0, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = 2.1, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = inf}.passed()));
    EXPECT_TRUE((Row{.measured = inf}.passed()));
}

}  // namespace gloam::stress::test::runs_test
