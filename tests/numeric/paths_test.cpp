// SPDX-License-Identifier: MIT
#include "numeric/paths.hpp"
#include "numeric/interval.hpp"
#include "numeric/random.hpp"
#include "numeric/rearranged.hpp"
#include "support/test.hpp"

namespace gloam::numeric::paths_test {

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
        while (Interval(1.0) <= x) x = x * Interval(0.5);
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

TEST(Paths, WholeNumbersAreOneWayWhereTheWaysWouldBeTooMany) {
    const auto runs_with = [](int floors, int comparisons) {
        int runs = 0;
        EXPECT_EQ(Paths::explore(float32, 64,
                                 [&] {
                                     ++runs;
                                     for (int i = 0; i < floors; ++i) (void)floor(Interval::within(0.5, 1.5));
                                     for (int i = 0; i < comparisons; ++i) (void)Paths::choose(2);
                                 }),
                  Paths::Outcome::complete);
        return runs;
    };
    EXPECT_EQ(runs_with(2, 1), 8);
    EXPECT_EQ(runs_with(6, 0), 16) << "the others are intervals";
    EXPECT_EQ(runs_with(1, 6), 16 + 64) << "begun again without the ways of the first";
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

// The bounds contain every order of evaluation; a single operation has one order.

Rearranged leaf(float x) {
    return Rearranged(Interval::input(x));
}

class RearrangedTest : public testing::Test {
  protected:
    float drawn() {
        const double size = std::exp2(random.uniform(-12, 12));
        return static_cast<float>(random.below(2) == 0 ? size : -size);
    }
    Random random{3};
};

TEST_F(RearrangedTest, EveryOrderOfASumIsInside) {
    for (int n = 0; n < 2000; ++n) {
        std::array<float, 4> terms{drawn(), drawn(), drawn(), drawn()};
        if (n % 2 == 0) terms[3] = -terms[0];
        const Rearranged sum = ((leaf(terms[0]) + leaf(terms[1])) + leaf(terms[2])) + leaf(terms[3]);
        std::ranges::sort(terms);
        do {
            const float chain = ((terms[0] + terms[1]) + terms[2]) + terms[3];
            const float pairs = (terms[0] + terms[1]) + (terms[2] + terms[3]);
            ASSERT_TRUE(sum.interval().bounds().contains(chain)) << n;
            ASSERT_TRUE(sum.interval().bounds().contains(pairs)) << n;
        } while (std::ranges::next_permutation(terms).found);
    }
}

TEST_F(RearrangedTest, DistributedAndContractedProductsAreInside) {
    for (int n = 0; n < 5000; ++n) {
        const float a = drawn();
        const float b = drawn();
        const float c = n % 2 == 0 ? -b * (1.0F + 0x1p-20F) : drawn();
        const Bounds product = (leaf(a) * (leaf(b) + leaf(c))).interval().bounds();
        ASSERT_TRUE(product.contains(a * b + a * c));
        ASSERT_TRUE(product.contains(std::fma(a, b, a * c)));
        ASSERT_TRUE(product.contains(std::fma(a, c, a * b)));
        ASSERT_TRUE(product.contains(a * (b + c)));
        const Bounds sum = (leaf(a) * leaf(b) + leaf(a) * leaf(c)).interval().bounds();
        ASSERT_TRUE(sum.contains(a * (b + c)));
        const Bounds quotient = ((leaf(a) + leaf(b)) / leaf(c)).interval().bounds();
        ASSERT_TRUE(quotient.contains(a / c + b / c));
        ASSERT_TRUE(quotient.contains((a + b) * (1.0F / c)));
    }
}

TEST_F(RearrangedTest, WhatIsExactInEveryOrderStaysAPoint) {
    const Rearranged x = (leaf(3.0F) + leaf(0.5F)) * leaf(4.0F) - leaf(7.25F);
    EXPECT_EQ(x.interval().bounds(), Bounds::point(6.75));
    const Rearranged y = (leaf(3.0F) + leaf(0.1F)) * leaf(4.0F) - leaf(7.25F);
    EXPECT_LT(y.interval().low(), y.interval().high());
}

TEST_F(RearrangedTest, APartialProductMayUnderflowAlthoughTheResultIsExact) {
    const Rearranged scale = leaf(0x1p-64F);
    const Interval small = ((leaf(0x1p24F) * scale) * scale).interval();
    EXPECT_TRUE(small.bounds().contains(0x1p-104));
    EXPECT_TRUE(small.bounds().contains(0.0)) << "2^-64 2^-64 is subnormal, and may be flushed";
    EXPECT_FALSE(small.bounds().contains(0x1p-90));
    EXPECT_TRUE(((leaf(0x1p24F) * leaf(0x1p-32F)) * leaf(0x1p-32F)).interval().bounds().is_point());
}

TEST_F(RearrangedTest, WhatMayOverflowInSomeOrderIsAnything) {
    EXPECT_TRUE((leaf(3e38F) + leaf(-3e38F) + leaf(3e38F)).interval().bounds().is_anything());
}

TEST(Paths, EndWithTheFirstThatIsEnough) {
    int runs = 0;
    const auto outcome = Paths::explore(float32, 100, [&] {
        ++runs;
        if (Paths::choose(10) == 3) throw Paths::Enough{};
    });
    EXPECT_EQ(outcome, Paths::Outcome::enough);
    EXPECT_EQ(runs, 4);
}

}  // namespace gloam::numeric::paths_test
