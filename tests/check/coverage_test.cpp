// SPDX-License-Identifier: MIT
// Which lines and branches inputs reach.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check/measure_coverage.hpp"
#include "support/lab.hpp"

namespace gloam::check {
namespace coverage_test {

using testing::AnyOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class CoverageTest : public testing::Test {
  protected:
    Coverage of(const Domain& domain, const shader::Variant& variant = {}) {
        const Lab lab = test::make_lab(FIXTURES, variant);
        const Question question{.file = "branches.glsl",
                                .function = "branches",
                                .signature = SignatureOf<float(float, int)>::describe(),
                                .domain = domain};
        return measure_coverage(lab, question, {.inputs = 4096});
    }

    // "line", or "line way".
    static std::vector<std::string> missed(const Coverage& coverage) {
        std::vector<std::string> all;
        for (const Coverage::Point& point : coverage.points)
            if (!point.reached)
                all.push_back(std::to_string(point.line) + (point.way.empty() ? "" : " ") + point.way);
        return all;
    }
};

TEST_F(CoverageTest, EveryWayThatInputsGoIsReached) {
    const Coverage all = of({uniform(-300, 300), integers(0, 40)});
    EXPECT_THAT(missed(all), IsEmpty());
    EXPECT_TRUE(all.is_complete());
    EXPECT_LT(all.inputs, 4096U) << "nothing is left to be reached";
}

TEST_F(CoverageTest, WhatNoInputReachesIsToldWithItsLine) {
    const Coverage some = of({uniform(0.5, 90), integers(1, 2)});
    // glslang 15 gives a switch its own line; earlier versions give it that of the branch before it.
    EXPECT_THAT(missed(some), AnyOf(ElementsAre("14", "20", "6 true", "11 true", "13 true", "18 case 40"),
                                    ElementsAre("14", "20", "6 true", "11 true", "13 true",
                                                "12 case 40, branch 2 of the line")));
    EXPECT_EQ(some.inputs, 4096U);
    EXPECT_THAT(to_text(some), HasSubstr("never true: float sum = x < 0.0 ? 1.0 : 0.0;"));
    EXPECT_THAT(to_text(some), HasSubstr("not reached: sum += 10.0;"));
}

// An optimizer removes some branches and copies others; the report must be about the source.
TEST_F(CoverageTest, IsTheSameInEveryVariant) {
    const Domain domain{uniform(0.5, 90), integers(1, 2)};
    EXPECT_EQ(missed(of(domain, shader::variant("optimized"))), missed(of(domain)));
}

TEST_F(CoverageTest, IsPartOfAnAnswerWhereItIsAskedFor) {
    const Lab lab = test::make_lab(FIXTURES);
    const Question question{.file = "branches.glsl",
                            .function = "branches",
                            .signature = SignatureOf<float(float, int)>::describe(),
                            .domain = {uniform(0.5, 90), integers(1, 2)}};
    EXPECT_FALSE(run(lab, question, {.inputs = 64}).coverage);
    ASSERT_TRUE(run(lab, question, {.inputs = 64, .coverage = true}).coverage);
}

}  // namespace coverage_test
}  // namespace gloam::check
