// SPDX-License-Identifier: MIT
// Which lines and branches inputs reach.
#include "audit/audit.hpp"
#include "support/lab.hpp"

namespace gloam::audit::coverage_test {

using namespace judge;
using namespace subject;

Coverage of(const Domain& domain, const module::Variant& variant = {}) {
    const Question question{.file = "branches.glsl",
                            .function = "branches",
                            .signature = SignatureOf<float(float, int)>::describe(),
                            .domain = domain};
    return measure_coverage(test::make_lab(FIXTURES, variant), question, {.inputs = 4096});
}

Domain few() {
    return {uniform(0.5, 90), integers(1, 2)};
}

TEST(CoverageTest, EveryWayThatInputsGoIsReached) {
    const Coverage all = of({uniform(-300, 300), integers(0, 40)});
    EXPECT_THAT(missed(all), IsEmpty());
    EXPECT_TRUE(all.is_complete());
    EXPECT_LT(all.inputs, 4096U) << "nothing is left to be reached";
}

TEST(CoverageTest, WhatNoInputReachesIsToldWithItsLine) {
    const Coverage some = of(few());
    const auto at = [](const std::string& place) { return StartsWith("branches.glsl:" + place + ": "); };
    // glslang 15 gives a switch its own line; earlier versions give it that of the branch before it.
    EXPECT_THAT(missed(some),
                ElementsAre(at("10"), at("16"), at("2: never true"), at("7: never true"), at("9: never true"),
                            AnyOf(at("14: never case 40"), at("8: never case 40, branch 2 of the line"))));
    EXPECT_EQ(some.inputs, 4096U);
    EXPECT_THAT(to_text(some), HasSubstr("never true: float sum = x < 0.0 ? 1.0 : 0.0;"));
    EXPECT_THAT(to_text(some), HasSubstr("not reached: sum += 10.0;"));
}

// An optimizer removes some branches and copies others; the report must be about the source.
TEST(CoverageTest, IsTheSameInEveryVariant) {
    EXPECT_EQ(missed(of(few(), module::variant("optimized"))), missed(of(few())));
}

}  // namespace gloam::audit::coverage_test
