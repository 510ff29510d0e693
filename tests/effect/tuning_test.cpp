// SPDX-License-Identifier: MIT
#include "effect/study/tuning.hpp"
#include "support/test.hpp"

namespace gloam::effect::test::tuning_test {

using scene::ViewHalf;
using scene::ViewInfo;

const std::vector<ViewInfo> four_views{{"a", "kind", "", ViewHalf::tuning},
                                       {"b", "kind", "", ViewHalf::unseen},
                                       {"c", "kind", "", ViewHalf::tuning},
                                       {"d", "kind", "", ViewHalf::unseen}};

TuneTask intensity_task() {
    return {.start = Settings{.own = {.intensity = 0.1F}},
            .parameters = {{.name = "intensity", .least = 0.0, .most = 2.0}}};
}

template <class Exception, class Call>
void expect_refused(const Call& call, const char* text) {
    try {
        call();
        ADD_FAILURE() << "no error, expected one with " << text;
    } catch (const Exception& error) {
        EXPECT_THAT(error.what(), HasSubstr(text));
    }
}

TEST(PatternSearch, FindsTheMinimumOfOneParameter) {
    const SearchOutcome found =
        pattern_search({{.name = "x", .least = 0.0, .most = 10.0}}, {9.0}, 200,
                       [](const std::vector<double>& at) { return (at[0] - 3.3) * (at[0] - 3.3); });
    EXPECT_NEAR(found.best.at[0], 3.3, 10.0 / 64.0);
    EXPECT_TRUE(found.points.front().improves);
    EXPECT_EQ(found.points.front().at[0], 9.0);
}

// The parameters depend on each other, and one of them is a factor.
TEST(PatternSearch, FindsTheMinimumOfTwo) {
    const SearchOutcome found = pattern_search(
        {{.name = "x", .least = -1.0, .most = 1.0},
         {.name = "y", .least = 0.01, .most = 100.0, .logarithmic = true}},
        {1.0, 100.0}, 1000, [](const std::vector<double>& at) {
            const double y = std::log10(at[1]);
            return (at[0] - 0.2) * (at[0] - 0.2) + (y - 0.5) * (y - 0.5) + 0.2 * (at[0] - 0.2) * (y - 0.5);
        });
    EXPECT_NEAR(found.best.at[0], 0.2, 0.05);
    EXPECT_NEAR(std::log10(found.best.at[1]), 0.5, 0.1);
}

TEST(PatternSearch, KeepsWholeNumbersWholeAndTriesNoneTwice) {
    const SearchOutcome found =
        pattern_search({{.name = "n", .least = 1.0, .most = 9.0, .whole = true}}, {2.0}, 100,
                       [](const std::vector<double>& at) { return std::abs(at[0] - 7.2); });
    EXPECT_EQ(found.best.at[0], 7.0);
    std::vector<double> tried;
    for (const SearchPoint& point : found.points) {
        EXPECT_EQ(point.at[0], std::round(point.at[0]));
        EXPECT_EQ(std::ranges::count(tried, point.at[0]), 0);
        tried.push_back(point.at[0]);
    }
}

TEST(PatternSearch, StaysWithinItsBudgetAndItsRanges) {
    int calls = 0;
    const SearchOutcome found =
        pattern_search({{.name = "x", .least = 0.0, .most = 1.0}, {.name = "y", .least = 0.0, .most = 1.0}},
                       {5.0, 0.5}, 7, [&](const std::vector<double>& at) {
                           ++calls;
                           for (const double value : at) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value;
                           return -at[0] - at[1];
                       });
    EXPECT_EQ(calls, 7);
    EXPECT_EQ(found.points.size(), 7U);
}

TEST(PatternSearch, BadRangesAreNamed) {
    const auto value = [](const std::vector<double>&) { return 0.0; };
    const auto search = [&](const SearchRange& range, int evaluations = 5) {
        return [=] { (void)pattern_search({range}, {0.5}, evaluations, value); };
    };
    expect_refused<std::invalid_argument>(search({.name = "x", .least = 1.0, .most = 1.0}), "x from 1 to 1");
    expect_refused<std::invalid_argument>(search({.name = "x", .least = 0.0, .most = NAN}), "x from 0");
    expect_refused<std::invalid_argument>(search({.name = "x", .logarithmic = true}), "begins above 0");
    expect_refused<std::invalid_argument>(search({.name = "x"}, 0), "0 evaluations");
}

// The calls of a measure, in their order.
struct Call {
    std::string view;
    float intensity;
};

TEST(Tuning, TheUnseenHalfIsMeasuredOnlyAfterTheSearch) {
    std::vector<Call> calls;
    const TuneOutcome outcome =
        tune(intensity_task(), four_views, [&](const ViewInfo& view, const Settings& settings) {
            calls.push_back({view.name, settings.own.intensity});
            // The halves have different minima: 1.5 and 0.5.
            const double aim = view.half == ViewHalf::tuning ? 1.5 : 0.5;
            return ViewMeasure{.rmse = 0.01 + std::abs(double{settings.own.intensity} - aim)};
        });
    EXPECT_NEAR(outcome.settings.own.intensity, 1.5F, 2.0F / 64.0F);
    const auto is_unseen = [](const Call& call) { return call.view == "b" || call.view == "d"; };
    const auto first_unseen = std::ranges::find_if(calls, is_unseen);
    ASSERT_EQ(calls.end() - first_unseen, 4);
    EXPECT_TRUE(std::all_of(first_unseen, calls.end(), is_unseen));
    EXPECT_EQ(outcome.search.points.size() * 2U, static_cast<std::size_t>(first_unseen - calls.begin()));
    for (auto call = first_unseen; call != calls.end(); ++call)
        EXPECT_TRUE(call->intensity == 0.1F || call->intensity == outcome.settings.own.intensity);
}

TEST(Tuning, EachViewHasItsErrorsBeforeAndAfter) {
    const TuneOutcome outcome =
        tune(intensity_task(), four_views, [](const ViewInfo& view, const Settings& settings) {
            const double offset = view.name == "d" ? 0.5 : 0.0;
            return ViewMeasure{.rmse = offset + std::abs(double{settings.own.intensity} - 1.0)};
        });
    ASSERT_EQ(outcome.views.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const double offset = i == 3 ? 0.5 : 0.0;
        EXPECT_EQ(outcome.views[i].view.name, four_views[i].name);
        EXPECT_NEAR(outcome.views[i].before.rmse, offset + 0.9, 1e-6);
        EXPECT_NEAR(outcome.views[i].after.rmse,
                    offset + std::abs(double{outcome.settings.own.intensity} - 1.0), 1e-6);
    }
}

// One view has errors a hundred times as large: the mean follows it, the ratios do not.
TEST(Tuning, TheObjectiveWeighsTheViews) {
    const auto measure = [](const ViewInfo& view, const Settings& settings) {
        const double x = double{settings.own.intensity};
        const bool large = view.name == "a";
        const double aim = large ? 1.8 : 0.4;
        return ViewMeasure{.rmse =
                               (large ? 100.0 : 1.0) * (1.0 + (large ? 1.0 : 3.0) * (x - aim) * (x - aim))};
    };
    TuneTask task = intensity_task();
    EXPECT_GT(tune(task, four_views, measure).settings.own.intensity, 1.6F);
    task.objective = TuneObjective::relative;
    EXPECT_LT(tune(task, four_views, measure).settings.own.intensity, 1.2F);
}

TEST(Tuning, TheLimitOfTimeHolds) {
    TuneTask task = intensity_task();
    task.copies = 10.0;
    const TuneOutcome outcome = tune(task, four_views, [](const ViewInfo&, const Settings& settings) {
        const double x = double{settings.own.intensity};
        return ViewMeasure{.rmse = 3.0 - x, .copies = 10.0 * x};
    });
    EXPECT_LE(outcome.settings.own.intensity, 1.0F);
    EXPECT_GT(outcome.settings.own.intensity, 0.9F);
    expect_refused<std::invalid_argument>(
        [&] {
            (void)tune(task, four_views, [](const ViewInfo&, const Settings&) {
                return ViewMeasure{.rmse = 1.0, .copies = 11.0};
            });
        },
        "limit of time");
}

TEST(Tuning, WhatCannotBeTunedIsNamed) {
    EXPECT_EQ(tuned_parameter("steps=2:8").whole, true);
    EXPECT_EQ(tuned_parameter("thickness=0.1:10:log").logarithmic, true);
    EXPECT_EQ(tuned_parameter("thickness=0.1:10:log").most, 10.0);
    for (const char* text : {"steps", "steps=", "steps=2", "steps=2:", "steps=:8", "steps=2:x",
                             "steps=2:8:lin", "", "steps=1:log"})
        expect_refused<std::invalid_argument>([&] { (void)tuned_parameter(text); },
                                              "expected NAME=LEAST:MOST");
    expect_refused<std::invalid_argument>([] { (void)tuned_parameter("magic=0:1"); }, "magic");
    expect_refused<std::invalid_argument>([] { (void)tuned_parameter("filter=0:1"); },
                                          "filter is not a number");
    expect_refused<std::invalid_argument>([] { (void)tuned_parameter("steps=8:2"); }, "steps from 8 to 2");
    expect_refused<std::invalid_argument>([] { (void)tuned_parameter("steps=0:8"); }, "steps");
    const auto measure = [](const ViewInfo&, const Settings&) { return ViewMeasure{.rmse = 1.0}; };
    expect_refused<std::invalid_argument>([&] { (void)tune({}, four_views, measure); }, "--parameter");
    expect_refused<std::invalid_argument>([&] { (void)tune(intensity_task(), {four_views[0]}, measure); },
                                          "no view of the unseen half");
    expect_refused<std::invalid_argument>([&] { (void)tune(intensity_task(), {four_views[1]}, measure); },
                                          "no view of the tuning half");
}

}  // namespace gloam::effect::test::tuning_test
