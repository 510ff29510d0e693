// SPDX-License-Identifier: MIT
#include "numeric/paths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "numeric/interval.hpp"

namespace gloam::numeric {
namespace paths_test {

using testing::ElementsAre;

std::vector<std::string> all_paths(std::size_t most, Paths::Outcome& outcome, const auto& body) {
    std::vector<std::string> paths;
    outcome = Paths::explore(float32, most, [&] { paths.push_back(body()); });
    return paths;
}

TEST(Paths, VisitsEverySequenceOfChoicesOnce) {
    Paths::Outcome outcome{};
    const auto paths = all_paths(100, outcome, [] {
        std::string path = std::to_string(Paths::choose(3));
        if (path == "1") path += std::to_string(Paths::choose(2));
        return path;
    });
    EXPECT_THAT(paths, ElementsAre("0", "10", "11", "2"));
    EXPECT_EQ(outcome, Paths::Outcome::complete);
}

TEST(Paths, SaysThatThereAreTooMany) {
    Paths::Outcome outcome{};
    const auto paths = all_paths(5, outcome, [] {
        for (int i = 0; i < 3; ++i) (void)Paths::choose(2);
        return std::string();
    });
    EXPECT_EQ(paths.size(), 5U);
    EXPECT_EQ(outcome, Paths::Outcome::too_many);
}

TEST(Paths, StopsWhereAnythingIsPermitted) {
    Paths::Outcome outcome{};
    (void)all_paths(100, outcome, []() -> std::string {
        if (Paths::choose(2) == 1) throw Paths::Undetermined{};
        return {};
    });
    EXPECT_EQ(outcome, Paths::Outcome::undetermined);
}

TEST(Paths, ALoopThatNothingEndsPermitsAnything) {
    const auto halvings = [] {
        Interval x = Interval::within(1.0, std::numeric_limits<double>::infinity());
        while (x >= Interval(1.0)) x = x * Interval(0.5);
    };
    EXPECT_EQ(Paths::explore(float32, 1000, halvings), Paths::Outcome::undetermined);
}

TEST(Paths, PutsTheOuterExplorationBack) {
    std::vector<std::size_t> outer;
    Paths::explore(float32, 10, [&] {
        outer.push_back(Paths::choose(2));
        Paths::explore(float16, 10, [] {
            (void)Paths::choose(3);
            EXPECT_EQ(Paths::format(), float16);
        });
        EXPECT_EQ(Paths::format(), float32);
    });
    EXPECT_THAT(outer, ElementsAre(0U, 1U));
}

TEST(Paths, ErrorsPassThroughAndLeaveNothingBehind) {
    EXPECT_THROW(Paths::explore(float16, 10, [] { throw std::runtime_error("inside"); }), std::runtime_error);
    EXPECT_EQ(Paths::format(), float32);
    EXPECT_THROW((void)Paths::choose(2), std::logic_error);
}

TEST(Paths, AnOpenComparisonOutsideAnExplorationIsAnError) {
    const Interval wide = Interval::within(0.0, 2.0);
    EXPECT_THROW((void)(wide < Interval(1.0)), std::logic_error);
    EXPECT_TRUE(wide < Interval(3.0));
}

TEST(Paths, ThreadsExploreApart) {
    Paths::explore(float32, 4, [] {
        std::thread([] { EXPECT_THROW((void)Paths::choose(2), std::logic_error); }).join();
    });
}

// What a function of the library looks like.
template <class T>
T unit_interval(T x) {
    if (x >= T(1)) return T(1);
    if (x > T(0)) return x;
    return T(0);
}

std::vector<Bounds> outcomes_of(const Interval& x) {
    std::vector<Bounds> outcomes;
    Paths::explore(float32, 10, [&] { outcomes.push_back(unit_interval(x).bounds()); });
    return outcomes;
}

TEST(Paths, RunsBothSidesOfABranch) {
    EXPECT_THAT(outcomes_of(Interval::within(0.25, 0.5)), ElementsAre(Bounds{0.25, 0.5, false}));
    EXPECT_THAT(outcomes_of(Interval::within(0.5, 2.0)),
                ElementsAre(Bounds::point(1.0), Bounds{0.5, 2.0, false}));
    EXPECT_THAT(outcomes_of(Interval::within(-1.0, 0.5)),
                ElementsAre(Bounds{-1.0, 0.5, false}, Bounds::point(0.0)));
    EXPECT_THAT(outcomes_of(Interval::within(Bounds::only_nan())), ElementsAre(Bounds::point(0.0)));
}

TEST(Paths, ConversionsToIntegersTakeEachInReach) {
    std::vector<int> integers;
    Paths::explore(float32, 10, [&] { integers.push_back(to_integer<int>(Interval::within(-1.5, 2.25))); });
    EXPECT_THAT(integers, ElementsAre(-1, 0, 1, 2));
    for (const Bounds& bounds :
         {Bounds{0.0, 1e6, false}, Bounds{0.0, 1e300, false}, Bounds{0.0, 1.0, true}}) {
        EXPECT_EQ(Paths::explore(float32, 10, [&] { (void)to_integer<int>(Interval::within(bounds)); }),
                  Paths::Outcome::undetermined);
    }
}

}  // namespace paths_test
}  // namespace gloam::numeric
