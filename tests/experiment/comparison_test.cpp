// SPDX-License-Identifier: MIT
#include "experiment/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "experiment/visits.hpp"

namespace gloam::experiment {
namespace comparison_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using Points = std::vector<std::pair<double, double>>;

TEST(ExperimentFront, HoldsWhatNothingBeatsInBoth) {
    EXPECT_THAT(pareto_front(Points{}), IsEmpty());
    EXPECT_THAT(pareto_front(Points{{3, 1}, {1, 3}, {2, 2}, {2, 3}, {4, 1}}), ElementsAre(1, 2, 0));
    EXPECT_THAT(pareto_front(Points{{1, 1}, {1, 1}}), ElementsAre(0));
    EXPECT_THAT(pareto_front(Points{{1, 2}, {1, 1}}), ElementsAre(1));
    EXPECT_THAT(pareto_front(Points{{2, 2}, {1, 2}}), ElementsAre(1));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(pareto_front(Points{{nan, 0}, {0, nan}, {5, 5}, {HUGE_VAL, 0}}), ElementsAre(2));
}

// Every point of a grid either is in the front or is beaten by one that is.
TEST(ExperimentFront, HoldsOnManyPoints) {
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

const std::vector<Row> two_scenes{{"a", "fast", 10, 0.08}, {"a", "good", 40, 0.02}, {"a", "bad", 50, 0.09},
                                  {"b", "fast", 10, 0.04}, {"b", "good", 90, 0.04}, {"b", "bad", 50, 0.05}};

std::vector<Choice> choices_in(const std::vector<Row>& rows) {
    const Record record = make_record(rows);
    Experiment what;
    return choices_of(what, results_of(what, choose_recorded(what, record), record).at(0));
}

TEST(ExperimentChoices, AreMeansOfWhatIsInAllCases) {
    std::vector<Row> rows = two_scenes;
    rows.push_back({"a", "once", 1, 0.001});
    const std::vector<Choice> all = choices_in(rows);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[1].name, "good");
    EXPECT_DOUBLE_EQ(all[1].copies, 60.0);  // the geometric mean
    EXPECT_DOUBLE_EQ(all[1].mean_error, 0.03);
    EXPECT_DOUBLE_EQ(all[1].worst_copies, 90.0);
    EXPECT_DOUBLE_EQ(all[1].worst_ms, 9.0);
    EXPECT_EQ(all[1].worst_error, 0.04);
}

TEST(ExperimentChoices, BudgetsAreTimes) {
    EXPECT_EQ(time_budget("0.25ms").value, 0.25);
    EXPECT_FALSE(time_budget("1ms").copies);
    EXPECT_EQ(time_budget("40copies").value, 40.0);
    EXPECT_TRUE(time_budget("40copies").copies);
    for (const char* text : {"", "1", "ms", "1s", "-1ms", "0ms", "1 ms", "nanms", "infms", "1copy", "1msx"}) {
        EXPECT_THAT([&] { (void)time_budget(text); },
                    testing::ThrowsMessage<std::invalid_argument>(HasSubstr("--budget " + std::string(text))))
            << text;
    }
}

TEST(ExperimentChoices, NameTheBestWithinAndTheFastestWith) {
    const std::vector<Choice> all = choices_in(two_scenes);
    EXPECT_EQ(best_within(all, {95, true})->name, "good");
    EXPECT_EQ(best_within(all, {89, true})->name, "fast");      // 90 in one case
    EXPECT_EQ(best_within(all, {9.001, false})->name, "good");  // milliseconds
    EXPECT_FALSE(best_within(all, {9, true}));
    EXPECT_EQ(fastest_with(all, 0.08)->name, "fast");
    EXPECT_EQ(fastest_with(all, 0.07)->name, "good");
    EXPECT_FALSE(fastest_with(all, 0.03));  // 0.04 in one case
    EXPECT_FALSE(best_within({}, {1, true}));
}

TEST(ExperimentComparison, TheSameIsNoChange) {
    const Record record = make_record({{"a", "m/4", 10, 0.05}});
    const Comparison same = compared(record, record);
    EXPECT_FALSE(same.got_worse());
    EXPECT_THAT(same.warnings, IsEmpty());
    EXPECT_DOUBLE_EQ(same.time, 1.0);
    EXPECT_DOUBLE_EQ(same.error, 1.0);
    EXPECT_THAT(to_text(same), HasSubstr("nothing got worse"));
}

TEST(ExperimentComparison, ATimeChangesBeyondItsSpread) {
    const Record before = make_record({{"a", "m", 10, 0.05}, {"a", "n", 10, 0.05}, {"a", "o", 10, 0.05}});
    const Record after = make_record({{"a", "m", 12, 0.05}, {"a", "n", 13, 0.05}, {"a", "o", 8, 0.05}});
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
    EXPECT_THAT(to_text(found), HasSubstr("slower, beyond the spread: 1\n  a/n"));
    EXPECT_THAT(to_text(found), Not(HasSubstr("nothing got worse")));
}

TEST(ExperimentComparison, AnErrorThatRisesIsNamed) {
    const Record before = make_record({{"a", "m", 10, 0.0500}, {"a", "n", 10, 0.05}});
    const Record after = make_record({{"a", "m", 10, 0.0502}, {"a", "n", 10, 0.04}});
    const Comparison found = compared(before, after);
    EXPECT_TRUE(found.changes[0].worse);
    EXPECT_TRUE(found.changes[1].better);
    EXPECT_TRUE(found.got_worse());
    EXPECT_FALSE(
        compared(make_record({{"a", "m", 10, 0.05}}), make_record({{"a", "m", 10, 0.05001}})).got_worse());
}

TEST(ExperimentComparison, WarnsOfOtherCircumstancesAndStillCompares) {
    const Record before = make_record({{"a", "m/4", 10, 0.05}, {"a", "old/4", 1, 1}});
    Record after({.experiment = "mine",
                  .device = "another",
                  .driver = "x",
                  .frames = 16,
                  .scored = 8,
                  .repeat = 1,
                  .rays = 64});
    for (const int round : {0, 1}) {
        for (const char* name : {"m/4", "new/4"}) {
            Visit visit = make_visit("a", name, round, 20, 0.05);
            visit.size = {640, 180};
            after.add(visit);
        }
    }
    const Comparison found = compared(before, after);
    EXPECT_THAT(found.warnings, ElementsAre(HasSubstr("other devices: device"),
                                            HasSubstr("other sizes: 320 x 180"), HasSubstr("256 rays")));
    ASSERT_EQ(found.changes.size(), 1U);
    EXPECT_DOUBLE_EQ(found.changes.front().time.median, 2.0);
    EXPECT_THAT(found.only_old, ElementsAre("a/old/4"));
    EXPECT_THAT(found.only_new, ElementsAre("a/new/4"));
    EXPECT_THAT(to_text(found), testing::StartsWith("warning: other devices"));
}

}  // namespace comparison_test
}  // namespace gloam::experiment
