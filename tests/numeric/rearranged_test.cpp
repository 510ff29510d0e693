// SPDX-License-Identifier: MIT
// The bounds contain every order of evaluation; a single operation has one order.
#include "numeric/rearranged.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/paths.hpp"
#include "numeric/random.hpp"

namespace gloam::numeric {
namespace rearranged_test {

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

TEST_F(RearrangedTest, OneOperationHasOneOrder) {
    for (int n = 0; n < 1000; ++n) {
        const float a = drawn();
        const float b = drawn();
        EXPECT_EQ((leaf(a) + leaf(b)).interval().bounds(),
                  (Interval::input(a) + Interval::input(b)).bounds());
        EXPECT_EQ((leaf(a) * leaf(b)).interval().bounds(),
                  (Interval::input(a) * Interval::input(b)).bounds());
        EXPECT_EQ((leaf(a) / leaf(b)).interval().bounds(),
                  (Interval::input(a) / Interval::input(b)).bounds());
    }
}

TEST_F(RearrangedTest, WhatIsExactInEveryOrderStaysAPoint) {
    const Rearranged x = (leaf(3.0F) + leaf(0.5F)) * leaf(4.0F) - leaf(7.25F);
    EXPECT_EQ(x.interval().bounds(), Bounds::point(6.75));
    const Rearranged y = (leaf(3.0F) + leaf(0.1F)) * leaf(4.0F) - leaf(7.25F);
    EXPECT_LT(y.interval().low(), y.interval().high());
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

}  // namespace rearranged_test
}  // namespace gloam::numeric
