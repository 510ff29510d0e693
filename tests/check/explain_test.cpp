// SPDX-License-Identifier: MIT
// One input, operation by operation.
#include "check/explain.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gloam::check {
namespace explain_test {

using testing::HasSubstr;

const shader::CompileOptions options{.include_roots = {FIXTURES}, .variant = shader::variant("strict")};

TEST(Explain, TellsWhereTheErrorEnters) {
    const std::vector<Word> input{to_word(1.0F), to_word(1e-4F)};
    const Explanation all = explain(options, "own.glsl", "own_root", input);
    std::vector<std::string> operations;
    for (const ExplainedStep& step : all.steps) operations.push_back(step.operation);
    EXPECT_THAT(operations, testing::ElementsAre("OpFMul", "OpFSub", "GLSL.std.450 Sqrt", "OpFSub"));
    EXPECT_THAT(all.steps[0].file, HasSubstr("own.glsl"));
    EXPECT_EQ(all.steps[0].function, "own_root");
    EXPECT_EQ(all.steps[0].line, 11U);
    EXPECT_EQ(all.steps[3].line, 12U);
    ASSERT_EQ(all.worst, 3U) << "the difference of what is nearly equal";
    EXPECT_GT(all.steps[3].ulps, 100.0);
    EXPECT_EQ(all.steps[3].local, 0.0) << "which is exact in itself";
    EXPECT_NEAR(all.steps[3].inherited(), all.steps[3].error, 1e-30);
}

TEST(Explain, KeepsTheThreeValuesApart) {
    const std::vector<Word> input{to_word(1.0F), to_word(3.0F)};
    const ExplainedStep step = explain(options, "rules.glsl", "quotient", input).steps.back();
    EXPECT_EQ(step.value, 1.0F / 3.0F);
    EXPECT_EQ(step.exact, 1.0 / 3.0);
    EXPECT_EQ(step.local, static_cast<double>(1.0F / 3.0F) - 1.0 / 3.0);
    EXPECT_LT(step.permitted.low, step.exact);
    EXPECT_GT(step.permitted.high, step.exact);
    EXPECT_LT(step.permitted.high - step.permitted.low, 1e-6);
}

TEST(Explain, SaysWhatItExpected) {
    EXPECT_THAT([] { (void)explain(options, "rules.glsl", "quotient", std::vector<Word>{1}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("takes 2 values, got 1")));
    EXPECT_THAT([] { (void)explain(options, "rules.glsl", "none", std::vector<Word>{}); },
                testing::ThrowsMessage<std::invalid_argument>(HasSubstr("no function none")));
}

}  // namespace explain_test
}  // namespace gloam::check
