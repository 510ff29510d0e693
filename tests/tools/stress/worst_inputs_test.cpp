// SPDX-License-Identifier: MIT
#include "stress/worst_inputs.hpp"

#include <gtest/gtest.h>

#include "catalogue/catalogue.hpp"
#include "support.hpp"

namespace gloam::stress {
namespace worst_inputs_test {

TEST(WorstInputs, StayWithinWhatEveryEquationDocuments) {
    const test::Bench bench;
    const Rows rows = worst_inputs(bench.context());
    EXPECT_EQ(rows.size(), 2 * catalogue::all_entries().size());
    test::expect_all_passed(rows);
}

TEST(WorstInputs, AreAtLeastAsBadAsRandomOnes) {
    const test::Bench bench;
    const Rows rows = worst_inputs(bench.context());
    std::size_t worse = 0;
    for (std::size_t i = 0; i + 1 < rows.size(); i += 2) {
        EXPECT_GE(rows[i].measured, rows[i + 1].measured) << rows[i].varied;
        worse += rows[i].measured > rows[i + 1].measured;
    }
    EXPECT_GT(worse, rows.size() / 8) << "the climb finds worse inputs than drawing for many equations";
}

}  // namespace worst_inputs_test
}  // namespace gloam::stress
