// SPDX-License-Identifier: MIT
#include "report/internal/plot_layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gloam::report::internal {
namespace plot_layout_test {

TEST(PlotLayout, RangesHoldWhatIsShown) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const LogRange range = range_around({20.0, nan, 0.0, -1.0, 80.0});
    EXPECT_GT(range.low, 15.0);
    EXPECT_LT(range.low, 20.0);
    EXPECT_GT(range.high, 80.0);
    EXPECT_LT(range.high, 100.0);
    EXPECT_DOUBLE_EQ(range.at(range.low), 0.0);
    EXPECT_DOUBLE_EQ(range.at(range.high), 1.0);
    const LogRange one = range_around({3.0});
    EXPECT_LT(one.low, 3.0);
    EXPECT_GT(one.high, 3.0);
    EXPECT_LT(range_around({}).low, range_around({}).high);
}

TEST(PlotLayout, TicsAreRoundAndWithinTheRange) {
    EXPECT_THAT(tics_of({3.0, 300.0}),
                testing::Pointwise(testing::DoubleEq(), {5.0, 10.0, 20.0, 50.0, 100.0, 200.0}));
    EXPECT_THAT(tics_of({0.07, 0.16}),
                testing::Pointwise(testing::DoubleNear(1e-12), {0.08, 0.1, 0.12, 0.15}));
}

// Twenty points that nearly coincide: every label can still be read.
TEST(PlotLayout, LabelsDoNotCoverEachOther) {
    Plot plot{.title = "crowd", .logarithmic = true};
    plot.curves.push_back({.name = "points"});
    for (int i = 0; i < 20; ++i) {
        plot.curves[0].points.emplace_back(10.0 + 0.1 * i, 0.1 + 0.0001 * i);
        plot.curves[0].labels.push_back("method/" + std::to_string(i));
    }
    plot.curves[0].points.emplace_back(1000.0, 1.0);
    plot.curves[0].labels.emplace_back("corner");
    const auto labels = placed_labels(plot, {5.0, 1010.0}, {0.05, 1.01});
    ASSERT_EQ(labels.size(), 21U);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const bool same_line = std::abs(labels[i].at.second - labels[j].at.second) < 0.03;
            const bool beside = std::abs(labels[i].at.first - labels[j].at.first) > 0.06;
            EXPECT_TRUE(!same_line || beside) << labels[i].text << ' ' << labels[j].text;
        }
    }
    EXPECT_LT(labels.back().at.first, labels.back().point.first - 0.05) << "it would reach beyond the plot";
}

}  // namespace plot_layout_test
}  // namespace gloam::report::internal
