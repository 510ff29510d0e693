// SPDX-License-Identifier: MIT
// A check says "ok" only if enough inputs were judged: the counts of answers, and what the judge counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check/judge.hpp"
#include "support/lab.hpp"

namespace gloam::check {
namespace outcome_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Answer answer_of(const ClassCount& ordinary, const ClassCount& nan = {}) {
    Answer answer;
    answer.classes.front() = ordinary;
    answer.classes.back() = nan;
    return answer;
}

TEST(OutcomeTest, EnoughJudgedInputsAreOk) {
    const Answer answer = answer_of({.inputs = 100, .recorded = 74, .open = 1});
    EXPECT_EQ(answer.judged(), 25U);
    EXPECT_EQ(answer.outcome(), Outcome::ok);
    EXPECT_THAT(answer.not_judged_because(), IsEmpty());
}

TEST(OutcomeTest, TooFewAreNotJudged) {
    const Answer answer = answer_of({.inputs = 100, .recorded = 70, .open = 6});
    EXPECT_EQ(answer.outcome(), Outcome::not_judged);
    EXPECT_EQ(answer.not_judged_because(), "24 of 100 inputs could be judged, expected 25 % at least");
    EXPECT_EQ(answer_of({.inputs = 9, .recorded = 9}).not_judged_because(),
              "the device promises nothing for any of its inputs");
    EXPECT_EQ(answer_of({.inputs = 9, .open = 9}).not_judged_because(), "every result would pass");
    EXPECT_EQ(Answer{}.not_judged_because(), "there are no inputs");
}

TEST(OutcomeTest, EachClassThatTheDevicePromisesNeedsAJudgedInput) {
    const Answer open = answer_of({.inputs = 100}, {.inputs = 5, .recorded = 3, .open = 2});
    EXPECT_EQ(open.not_judged_because(), "every result would pass for its nan inputs");
    const Answer recorded = answer_of({.inputs = 100}, {.inputs = 5, .recorded = 5});
    EXPECT_EQ(recorded.outcome(), Outcome::ok);
    EXPECT_THAT(recorded.not_promised(), ElementsAre(InputClass::nan));
}

TEST(OutcomeTest, AFailureCountsHoweverFewWereJudged) {
    EXPECT_EQ(answer_of({.inputs = 100, .outside = 1, .recorded = 99}).outcome(), Outcome::failed);
    Answer fault = answer_of({.inputs = 4, .recorded = 4});
    fault.fault = "pixel (-1, 0)";
    EXPECT_EQ(fault.outcome(), Outcome::failed);
    EXPECT_EQ((Answer{.error = "gone", .reason = Reason::crash}).outcome(), Outcome::failed);
    EXPECT_EQ((Answer{.error = "no text", .reason = Reason::unsupported}).not_judged_because(), "no text");
}

// By the rules alone it is known of some inputs that any result would pass, and assumed of as many others.
TEST(OutcomeTest, ByTheRulesTheShareIsThatOfTheBoundedInputs) {
    Answer answer = answer_of({.inputs = 1000, .recorded = 200, .open = 30});
    answer.verdict = Verdict::rules;
    answer.bounded = 40;
    EXPECT_EQ(answer.judged(), 200U) << "a quarter of the 800 that are not recorded";
    EXPECT_EQ(answer.outcome(), Outcome::not_judged);
}

// The outputs of an identity, judged without a device.
template <class T>
Answer judged(const Codomain& codomain, const std::function<bool(std::span<const Word>)>& promised) {
    const Question question{.signature = SignatureOf<T(float)>::describe(),
                            .reference = make_reference<T(float)>([](double x) { return T(x); }),
                            .codomain = codomain,
                            .promised = promised};
    Domain::Inputs inputs{.width = 1};
    for (const float x : {1.0F, 2.0F, 0.0F, 4.0F}) {
        inputs.words.push_back(to_word(x));
        inputs.branch.push_back(false);
    }
    std::vector<Word> outputs;
    for (const Word word : inputs.words) outputs.push_back(to_word(T(from_word<float>(word))));
    return judge(question, {}, inputs, outputs);
}

bool nothing(std::span<const Word>) {
    return false;
}

TEST(OutcomeTest, AnInputIsJudgedIfSomeResultWouldFail) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(judged<float>({}, {}).judged(), 4U) << "by the budget";
    EXPECT_EQ(judged<float>({0.0, infinity}, nothing).judged(), 4U) << "by the codomain";
    EXPECT_EQ(judged<float>({}, nothing).judged(), 1U) << "a zero is an edge";
    EXPECT_EQ(judged<float>({}, nothing).open(), 3U);
    EXPECT_EQ(judged<bool>({0.0, 0.5}, nothing).judged(), 1U) << "a codomain is not of bools";
    EXPECT_EQ(judged<int>({0.0, 9.0}, nothing).judged(), 4U);
}

// A device that need not keep NaN is asked only for numbers, and "is not NaN" is always right for these.
TEST(OutcomeTest, BothAnswersOfAPredicateMustBeJudged) {
    const auto judged_below = [](float limit, bool nan) {
        const Question question{
            .signature = SignatureOf<bool(float)>::describe(),
            .reference = make_reference<bool(float)>([=](double x) { return std::isnan(x) || x > limit; })};
        Domain::Inputs inputs{.width = 1};
        std::vector<Word> outputs;
        for (const float x : {1.0F, 2.0F, 3.0F, std::nanf("")}) {
            inputs.words.push_back(to_word(x));
            inputs.branch.push_back(false);
            outputs.push_back(std::isnan(x) || x > limit ? 1 : 0);
        }
        return judge(question, {.nan = nan}, inputs, outputs);
    };
    EXPECT_EQ(judged_below(9.0F, true).outcome(), Outcome::ok);
    EXPECT_EQ(judged_below(2.5F, false).outcome(), Outcome::ok);
    EXPECT_EQ(judged_below(0.0F, true).outcome(), Outcome::ok) << "its inputs have one answer";
    EXPECT_EQ(judged_below(9.0F, false).not_judged_because(),
              "no input could be judged whose result is true: a function that is always false would pass");
}

class OutcomeByRules : public testing::Test {
  protected:
    template <class Signature>
    Answer judged(const char* function, const Domain& domain) {
        return check_rules<Signature>(test::make_lab(FIXTURES), "rules.glsl", function, domain,
                                      {.inputs = 600});
    }
};

TEST_F(OutcomeByRules, WhatVulkanLeavesUndefinedIsNotJudged) {
    const Answer undefined = judged<float(float)>("sine", {uniform(10, 20)});
    EXPECT_EQ(undefined.outcome(), Outcome::not_judged);
    EXPECT_EQ(undefined.not_judged_because(), "every result would pass");
    const Answer defined = judged<float(float)>("sine", {uniform(-3, 3)});
    EXPECT_EQ(defined.outcome(), Outcome::ok) << defined;
    EXPECT_EQ(defined.judged(), 600U);
    const Answer both = judged<float(float)>("sine", {uniform(-3, 3).and_value(1e30F)});
    EXPECT_EQ(both.outcome(), Outcome::ok) << both;
    EXPECT_THAT(both.not_promised(), ElementsAre(InputClass::huge)) << "no failure of the check";
}

TEST_F(OutcomeByRules, TheyJudgeWhereNothingElseIsPromised) {
    const Question question{.file = "rules.glsl",
                            .function = "reciprocal",
                            .signature = SignatureOf<float(float)>::describe(),
                            .domain = {uniform(1, 2)},
                            .reference = make_reference<float(float)>([](double x) { return 1.0 / x; }),
                            .promised = nothing};
    const Answer few = run(test::make_lab(FIXTURES), question, {.inputs = 512});
    EXPECT_EQ(few.judged(), 512U);
    const Answer many = run(test::make_lab(FIXTURES), question, {.inputs = 65'536});
    EXPECT_EQ(many.outcome(), Outcome::not_judged) << "the rules were asked for some inputs only";
}

}  // namespace outcome_test
}  // namespace gloam::check
