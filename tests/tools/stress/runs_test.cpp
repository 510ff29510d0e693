// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "support/entries.hpp"
#include "support/test.hpp"
#include "tools/stress/support.hpp"

namespace gloam::stress::test::runs_test {

TEST(LongRun, StaysWithinItsBounds) {
    const Bench bench;
    const Rows rows = long_run(bench.context());
    expect_all_passed(rows);
    EXPECT_GT(row_of(rows, "farthest from the exact mean", "k 8, w_max 1500").measured, 0.0);
}

// Relative to the eye nothing depends on the place; relative to the world's origin all grows with it.
TEST(Far, OnlyWorldCoordinatesLosePrecision) {
    const Bench bench;
    const Rows rows = far_away(bench.context());
    expect_all_passed(rows);
    for (const char* quantity :
         {"position off, part of the distance", "reprojection off, pixels of 1920 x 1080",
          "points that TSSAO-8 (0.01) rejects, %", "occlusion off after 4 frames"}) {
        EXPECT_EQ(row_of(rows, quantity, "1e+02, relative to the eye").measured,
                  row_of(rows, quantity, "1e+07, relative to the eye").measured);
        EXPECT_GT(row_of(rows, quantity, "1e+07, relative to the world").measured,
                  2.0 * row_of(rows, quantity, "1e+02, relative to the world").measured);
    }
    EXPECT_GT(row_of(rows, "occlusion of a bare wall (gtao)", "0.001 radii").measured, 0.01);
}

// Of one equation; a suite shares a run.
class WorstInputs : public testing::TestWithParam<std::size_t> {
  protected:
    static void SetUpTestSuite() { bench_.emplace(); }
    static void TearDownTestSuite() { bench_.reset(); }

    inline static std::optional<Bench> bench_;
};

TEST_P(WorstInputs, StayWithinWhatIsDocumentedAndAreAtLeastAsBadAsRandomOnes) {
    const Rows rows = worst_inputs(bench_->context(), gloam::test::entries()[GetParam()]);
    ASSERT_EQ(rows.size(), 2U);
    expect_all_passed(rows);
    EXPECT_GE(rows[0].measured, rows[1].measured);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WorstInputs, gloam::test::entry_numbers(), gloam::test::entry_name);

TEST(Climb, FindsWorseInputsThanDrawingForManyEquations) {
    const Bench bench;
    Context context = bench.context();
    context.equations = {"TSSAO-*"};
    const Rows rows = worst_inputs(context);
    std::size_t worse = 0;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) worse += rows[i].measured > rows[i + 1].measured;
    EXPECT_GT(worse, rows.size() / 8);
}

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Report, ABoundIsBrokenByMoreAndByNaN) {
    EXPECT_TRUE((Row{.measured = 2.0, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = 2.1, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = 2.0}.passed()));
    EXPECT_FALSE((Row{.measured = nan, .bound = inf}.passed()));
    EXPECT_TRUE((Row{.measured = inf}.passed()));
}

TEST(Report, JsonHoldsWhatIsNoNumber) {
    const auto rows = nlohmann::json::parse(to_json({.name = "device"}, {{"run", "c", "d", inf, std::nullopt},
                                                                         {"run", "e", "f", nan, 0.0}}))
                          .at("rows");
    EXPECT_TRUE(rows[0].at("bound").is_null());
    EXPECT_EQ(rows[0].at("measured"), "inf");
    EXPECT_EQ(rows[1].at("measured"), "nan");
    EXPECT_EQ(rows[1].at("passed"), false);
}

}  // namespace gloam::stress::test::runs_test
