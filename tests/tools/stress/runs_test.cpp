// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "stress/long_run.hpp"
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
