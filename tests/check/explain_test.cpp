// SPDX-License-Identifier: MIT
// One input, operation by operation.
#include <rapidcheck.h>

#include <cmath>

#include "check/explain.hpp"
#include "check/run.hpp"
#include "check/signature.hpp"
#include "support/lab.hpp"
#include "support/matchers.hpp"

namespace gloam::check::explain_test {

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

// Which lines and branches inputs reach.

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

struct Mixed {
    bool flag;
    glm::vec3 position;
    int count;
    glm::mat2 matrix;
    unsigned bits;
};

template <class T>
T round_trip(const T& value) {
    std::vector<Word> words;
    append_words(value, words);
    std::span<const Word> rest = words;
    T back = take_words<T>(rest);
    RC_ASSERT(rest.empty());
    return back;
}

TEST(Scalars, ValuesSurviveAsWords) {
    EXPECT_TRUE(rc::check("any bit pattern of a float", [](unsigned bits) {
        RC_ASSERT(std::bit_cast<unsigned>(round_trip(std::bit_cast<float>(bits))) == bits);
    }));
    EXPECT_TRUE(
        rc::check("a structure, member by member", [](bool flag, int count, unsigned bits, short x, short y) {
            const Mixed mixed{flag, glm::vec3(x, y, 1), count, glm::mat2(x, y, y, x), bits};
            const Mixed back = round_trip(mixed);
            RC_ASSERT(back.flag == flag && back.count == count && back.bits == bits);
            RC_ASSERT(back.position == mixed.position && back.matrix == mixed.matrix);
        }));
}

TEST(Scalars, TypesAreThoseOfGlsl) {
    EXPECT_EQ(shader::to_glsl(type_of<glm::mat4x3>()), "mat4x3");
    EXPECT_EQ(shader::to_glsl(type_of<glm::uvec2>()), "uvec2");
    EXPECT_EQ(type_of<double>(), type_of<float>())
        << "references calculate in double what the shader has in float";
    EXPECT_EQ(word_count<Mixed>(), 10U);
    EXPECT_EQ(scalars_of(type_of<Mixed>()).size(), 10U);
    EXPECT_EQ(scalars_of(type_of<Mixed>()).front(), shader::Scalar::bool_);
}

}  // namespace gloam::check::explain_test
