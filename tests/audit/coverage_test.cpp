// SPDX-License-Identifier: MIT
// Which lines and branches inputs reach.
#include "audit/audit.hpp"
#include "support/lab.hpp"

namespace gloam::check::coverage_test {

class CoverageTest : public testing::Test {
  protected:
    static Question question(const Domain& domain) {
        return {.file = "branches.glsl",
                .function = "branches",
                .signature = SignatureOf<float(float, int)>::describe(),
                .domain = domain};
    }
    static Coverage of(const Domain& domain, const shader::Variant& variant = {}) {
        return measure_coverage(test::make_lab(FIXTURES, variant), question(domain), {.inputs = 4096});
    }
    const Domain few_{uniform(0.5, 90), integers(1, 2)};

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
    const Coverage some = of(few_);
    // glslang 15 gives a switch its own line; earlier versions give it that of the branch before it.
    EXPECT_THAT(missed(some), AnyOf(ElementsAre("10", "16", "2 true", "7 true", "9 true", "14 case 40"),
                                    ElementsAre("10", "16", "2 true", "7 true", "9 true",
                                                "8 case 40, branch 2 of the line")));
    EXPECT_EQ(some.inputs, 4096U);
    EXPECT_THAT(to_text(some), HasSubstr("never true: float sum = x < 0.0 ? 1.0 : 0.0;"));
    EXPECT_THAT(to_text(some), HasSubstr("not reached: sum += 10.0;"));
}

// An optimizer removes some branches and copies others; the report must be about the source.
TEST_F(CoverageTest, IsTheSameInEveryVariant) {
    EXPECT_EQ(missed(of(few_, shader::variant("optimized"))), missed(of(few_)));
}

}  // namespace gloam::check::coverage_test
