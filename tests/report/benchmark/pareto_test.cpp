// SPDX-License-Identifier: MIT
#include "report/benchmark/pareto.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "report/benchmark/budget.hpp"
#include "report/benchmark_rows.hpp"

namespace gloam::report {
namespace pareto_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Points = std::vector<std::pair<double, double>>;

TEST(BenchmarkPareto, FrontIsWhatNothingBeats) {
    EXPECT_THAT(pareto_front(Points{{3, 1}, {1, 3}, {2, 2}, {2.5, 2.5}, {4, 1}}), ElementsAre(1, 2, 0));
    EXPECT_THAT(pareto_front(Points{{1, 1}}), ElementsAre(0));
    EXPECT_THAT(pareto_front(Points{}), IsEmpty());
}

TEST(BenchmarkPareto, OfEqualPointsTheFirst) {
    EXPECT_THAT(pareto_front(Points{{1, 2}, {1, 2}, {2, 1}, {2, 1}}), ElementsAre(0, 2));
    EXPECT_THAT(pareto_front(Points{{1, 3}, {1, 2}}), ElementsAre(1));
    EXPECT_THAT(pareto_front(Points{{2, 2}, {1, 2}}), ElementsAre(1));
}

TEST(BenchmarkPareto, WhatIsNotKnownIsInNoFront) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(pareto_front(Points{{nan, 0}, {0, nan}, {5, 5}, {HUGE_VAL, 0}}), ElementsAre(2));
}

// Every point of a grid either is in the front or is beaten by one that is.
TEST(BenchmarkPareto, HoldsOnManyPoints) {
    Points points;
    for (unsigned i = 0; i < 500; ++i) points.emplace_back((i * 7919U) % 101U, (i * 104'729U) % 97U);
    const std::vector<std::size_t> front = pareto_front(points);
    for (const auto& point : points) {
        bool held = false;
        for (const std::size_t f : front)
            held |= points[f].first <= point.first && points[f].second <= point.second;
        EXPECT_TRUE(held);
    }
    for (std::size_t i = 1; i < front.size(); ++i) {
        EXPECT_LT(points[front[i - 1]].first, points[front[i]].first);
        EXPECT_GT(points[front[i - 1]].second, points[front[i]].second);
    }
}

Benchmark two_scenes() {
    return make_benchmark({make_row("a", "fast", 4, 10, 0.08), make_row("a", "good", 4, 40, 0.02),
                           make_row("a", "bad", 4, 50, 0.09), make_row("b", "fast", 4, 10, 0.04),
                           make_row("b", "good", 4, 90, 0.04), make_row("b", "bad", 4, 50, 0.05),
                           make_row("a", "once", 4, 1, 0.001)});
}

TEST(BenchmarkPareto, FrontOfASceneIsOfItsRows) {
    const Benchmark benchmark = two_scenes();
    EXPECT_THAT(scenes_of(benchmark), ElementsAre("a", "b"));
    const std::vector<const Row*> front = front_of(benchmark, "b");
    ASSERT_EQ(front.size(), 1U);
    EXPECT_EQ(front.front()->configuration.method, "fast");
    EXPECT_THAT(front_of(benchmark, "c"), IsEmpty());
}

TEST(BenchmarkPareto, OverallIsGeometricMeansOfWhatIsInAllScenes) {
    Benchmark benchmark = two_scenes();
    benchmark.rows.pop_back();
    const std::vector<Overall> all = overall_of(benchmark);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(choice_of(all[0].choice), "fast/4/single");
    EXPECT_DOUBLE_EQ(all[0].copies, 10.0);
    EXPECT_DOUBLE_EQ(all[0].error_ratio, 2.0);  // 4 and 1 times the scene's least
    EXPECT_DOUBLE_EQ(all[1].copies, 60.0);
    EXPECT_DOUBLE_EQ(all[1].error_ratio, 1.0);
    EXPECT_DOUBLE_EQ(all[1].mean_error, 0.03);
    EXPECT_EQ(all[1].worst_copies, 90.0);
    EXPECT_EQ(all[1].worst_ms, 9.0);
    EXPECT_EQ(all[1].worst_error, 0.04);
    const std::vector<Overall> front = front_of(all);
    ASSERT_EQ(front.size(), 2U);
    EXPECT_EQ(front[0].choice.method, "fast");
    EXPECT_EQ(front[1].choice.method, "good");
}

TEST(BenchmarkPareto, WhatASceneLacksIsNoOverallChoice) {
    for (const Overall& choice : overall_of(two_scenes())) EXPECT_NE(choice.choice.method, "once");
}

TEST(BenchmarkBudget, ReadsTimes) {
    EXPECT_EQ(time_budget("1ms").value, 1.0);
    EXPECT_FALSE(time_budget("1ms").copies);
    EXPECT_EQ(time_budget("0.25ms").value, 0.25);
    EXPECT_EQ(time_budget("40copies").value, 40.0);
    EXPECT_TRUE(time_budget("40copies").copies);
    for (const char* text : {"", "1", "ms", "1s", "-1ms", "0ms", "1 ms", "nanms", "infms", "1copy", "1msx"}) {
        EXPECT_THAT([&] { (void)time_budget(text); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr("--budget " + std::string(text))))
            << text;
    }
}

TEST(BenchmarkBudget, NamesTheBestWithinAndTheFastestWith) {
    const std::vector<Overall> all = overall_of(two_scenes());
    EXPECT_EQ(best_within(all, {95, true})->choice.method, "good");
    EXPECT_EQ(best_within(all, {89, true})->choice.method, "fast");  // 90 in one scene
    EXPECT_EQ(best_within(all, {9, false})->choice.method, "good");  // milliseconds
    EXPECT_FALSE(best_within(all, {9, true}));
    EXPECT_EQ(fastest_with(all, 0.08)->choice.method, "fast");
    EXPECT_EQ(fastest_with(all, 0.07)->choice.method, "good");
    EXPECT_FALSE(fastest_with(all, 0.03));  // 0.04 in one scene
    EXPECT_FALSE(best_within({}, {1, true}));
}

}  // namespace pareto_test
}  // namespace gloam::report
