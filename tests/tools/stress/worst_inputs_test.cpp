// SPDX-License-Identifier: MIT
#include "stress/worst_inputs.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "support.hpp"
#include "support/entries.hpp"

namespace gloam::stress::worst_inputs_test {

// Of one equation; a suite shares a run.
class WorstInputs : public testing::TestWithParam<std::size_t> {
  protected:
    static void SetUpTestSuite() { bench_.emplace(); }
    static void TearDownTestSuite() { bench_.reset(); }

    inline static std::optional<test::Bench> bench_;
};

TEST_P(WorstInputs, StayWithinWhatIsDocumentedAndAreAtLeastAsBadAsRandomOnes) {
    const Rows rows = worst_inputs(bench_->context(), gloam::test::entries()[GetParam()]);
    ASSERT_EQ(rows.size(), 2U);
    test::expect_all_passed(rows);
    EXPECT_GE(rows[0].measured, rows[1].measured);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, WorstInputs, gloam::test::entry_numbers(), gloam::test::entry_name);

TEST(Climb, FindsWorseInputsThanDrawingForManyEquations) {
    const test::Bench bench;
    Context context = bench.context();
    context.equations = {"TSSAO-*"};
    const Rows rows = worst_inputs(context);
    std::size_t worse = 0;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) worse += rows[i].measured > rows[i + 1].measured;
    EXPECT_GT(worse, rows.size() / 8);
}

}  // namespace gloam::stress::worst_inputs_test
