// SPDX-License-Identifier: MIT
// Every kind of failure that the judge can report, from a shader broken on purpose.
#include <fmt/format.h>

#include "module/steps.hpp"
#include "subject/fixture_functions.hpp"

namespace gloam::judge::judge_test {

using namespace subject;

class JudgeTest : public testing::Test {
  protected:
    Lab lab = test::make_lab(FIXTURES);
    const Domain domain = Domain{signed_log_uniform(1e-3, 10).and_special(), uniform(0.5, 8)}.tied(0, 1);
    const Budget budget{.ulp = 2, .absolute = 4e-7};

    Answer weight(const std::string& function, const RunOptions& options = {}) {
        return Function<float(float, float)>(lab, "wrong.glsl", function)
            .compare(exact_weight, domain, budget, options);
    }

    static const ClassCount& count(const Answer& result, InputClass input_class) {
        return result.classes.at(static_cast<std::size_t>(input_class));
    }
};

TEST_F(JudgeTest, ARightFunctionPasses) {
    const Answer result = weight("weight");
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_EQ(result.inputs(), 65'536U);
    EXPECT_GT(count(result, InputClass::branch).inputs, 1000U);
    EXPECT_GT(count(result, InputClass::nan).inputs, 10U);
    EXPECT_GT(count(result, InputClass::subnormal).inputs, 10U);
}

TEST_F(JudgeTest, AWrongFunctionFailsInTheClassOfItsFault) {
    struct Row {
        const char* function;
        InputClass input_class;
        bool alone;  // no ordinary input fails
    };
    for (const auto& [function, input_class, alone] :
         {Row{"weight_wrong_constant", InputClass::ordinary, false},
          {"weight_swapped", InputClass::ordinary, false},
          {"weight_poisoned", InputClass::nan, true},
          {"weight_wrong_at_branch", InputClass::branch, true}}) {
        if (input_class == InputClass::nan && !lab.info().float32.preserves_signed_zero_inf_nan) continue;
        const Answer result = weight(function);
        EXPECT_FALSE(result.passed()) << function;
        EXPECT_GT(count(result, input_class).outside, 0U) << function;
        EXPECT_EQ(count(result, InputClass::ordinary).outside == 0U, alone) << function;
        if (input_class != InputClass::nan) continue;
        EXPECT_EQ(count(result, InputClass::nan).outside, count(result, InputClass::nan).inputs);
        EXPECT_THAT(result.story, AllOf(HasSubstr("nan"), HasSubstr("0x7fc00000")));
    }
    EXPECT_NEAR(weight("weight_wrong_constant").largest.absolute, 1e-4, 1e-6);
}

TEST_F(JudgeTest, OneUlpTooMuchFailsAndOneUlpAllowedPasses) {
    const auto check = [&](double ulp) {
        return Function<float(float)>(lab, "wrong.glsl", "identity_one_up")
            .compare([](double x) { return x; }, {uniform(1.1, 1.9)}, {.ulp = ulp});
    };
    EXPECT_TRUE(check(1.0).passed());
    const Answer strict = check(0.999);
    EXPECT_EQ(strict.outside(), strict.inputs());
    EXPECT_EQ(strict.largest.ulp, 1.0);
}

TEST_F(JudgeTest, DiscreteResultsMustBeEqualOrMeetTheBackwardBudget) {
    const auto above = [](double x, double limit) { return x > limit; };
    const Domain at_limit = Domain{uniform(0.1, 0.9), uniform(0.1, 0.9)}.tied(0, 1);
    const auto check = [&](int backward_ulp) {
        return Function<bool(float, float)>(lab, "wrong.glsl", "at_least")
            .compare(above, at_limit, {.backward_ulp = backward_ulp});
    };
    EXPECT_THAT(check(0).story, HasSubstr("got  true"));
    EXPECT_FALSE(check(0).passed()) << "x >= limit differs from x > limit where they are equal";
    EXPECT_TRUE(check(1).passed()) << "and meets it one ULP beside";
    EXPECT_FALSE(
        Function<int(float)>(lab, "wrong.glsl", "off_by_one")
            .compare([](double x) { return int(std::floor(x)); }, {uniform(-5, 5)}, {.backward_ulp = 4})
            .passed());
}

// A count is meant exactly: the end of a range is not swallowed by the backward budget.
TEST_F(JudgeTest, SmallWholeNumbersAreNotMoved) {
    const auto above = [](double x, double limit) { return x > limit; };
    for (const float end : {0.0F, 1.0F, -3.0F, 256.0F}) {
        const Domain at_end{constant(end), constant(end)};
        const Answer result = Function<bool(float, float)>(lab, "wrong.glsl", "at_least")
                                  .compare(above, at_end, {.backward_ulp = 4}, {.inputs = 8});
        EXPECT_EQ(result.outside(), 8U) << end;
    }
}

TEST_F(JudgeTest, TheCodomainHoldsWhereNothingElseIsPromisedAlsoForIntegers) {
    Question question = question_with<float(float)>("wrong.glsl", "identity_one_up", {uniform(0, 2)},
                                                    [](double x) { return x; });
    question.promised = make_predicate<float(float)>([](float) { return false; });
    EXPECT_EQ(run(lab, question).outcome(), Outcome::not_judged);
    question.codomain = {-1, 3};
    EXPECT_TRUE(run(lab, question).passed());
    question.codomain = {0, 1};
    const Answer outside = run(lab, question);
    EXPECT_TRUE(outside.failed());
    EXPECT_THAT(outside.story, HasSubstr("the worst result is outside the codomain [0, 1]\n"));
    Question whole = question_with<int(float)>("wrong.glsl", "off_by_one", {uniform(0, 1.5)},
                                               [](double x) { return std::floor(x) + 1.0; });
    whole.codomain = {1, 2};
    EXPECT_TRUE(run(lab, whole).passed());
    whole.promised = question.promised;
    whole.codomain = {0, 1};
    EXPECT_FALSE(run(lab, whole).passed());
}

// What a function documents for zero, infinity and NaN is judged where its accuracy is not promised, in every
// verdict.
TEST_F(JudgeTest, TheEdgesHoldWhereNothingElseIsPromised) {
    if (!lab.info().float32.preserves_signed_zero_inf_nan) GTEST_SKIP() << "the device does not keep NaN";
    for (const auto& [function, right] : {std::pair{"inverse", true}, {"inverse_wrong_at_zero", false}}) {
        Question question = question_with<float(float)>(
            "wrong.glsl", function, {log_uniform(0.01, 100).and_special()},
            [](double x) { return x > 0.0 && std::isfinite(x) ? 1.0 / x : 0.0; }, {.ulp = 2.5});
        question.promised = make_predicate<float(float)>([](float x) { return x >= 0.01F && x <= 100.0F; });
        const Answer result = run(lab, question, {.inputs = 4096});
        EXPECT_EQ(result.passed(), right) << result;
        EXPECT_EQ(count(result, InputClass::ordinary).outside, 0U) << function;
    }
}

TEST_F(JudgeTest, TheWorstInputIsPrintedInDecimalAndHexadecimalAndExplainedLineByLine) {
    const Answer result = Function<float(float)>(lab, "wrong.glsl", "identity_one_up")
                              .compare([](double x) { return x; }, {uniform(0.5, 0.5)}, {}, {.inputs = 4});
    EXPECT_THAT(result.story, AllOf(HasSubstr("0.5 (0x3f000000)"), HasSubstr("0.50000006 (0x3f000001)")));
    const Answer wrong = weight("weight_wrong_constant");
    EXPECT_THAT(wrong.story, AllOf(HasSubstr("in double the function gives"), HasSubstr("not the rounding"),
                                   HasSubstr("the worst input, operation by operation"),
                                   testing::ContainsRegex("wrong.glsl:[0-9]+ weight_wrong_constant +OpF")));
    EXPECT_EQ(weight("weight").story, "");
}

TEST_F(JudgeTest, TheWorstInputIsExplainedWithItsImages) {
    const auto make = [](glm::ivec2 size, numeric::Random& random) {
        return ImageSet{{"own_depth", make_image<float>(
                                          size, [&](glm::ivec2) { return static_cast<float>(random.unit()); },
                                          Border::clamp)}};
    };
    Question question = question_with<float(glm::ivec2)>("own.glsl", "own_mean", {image_pixel()},
                                                         [](glm::ivec2) { return 7.0; });
    question.scenarios = {{.name = "4 x 3", .size = {4, 3}, .make = make}};
    EXPECT_THAT(run(lab, question, {.inputs = 64}).story,
                testing::ContainsRegex("own.glsl:[0-9]+ own_mean +OpFAdd"));
}

TEST_F(JudgeTest, AnExplanationIsBounded) {
    const Function<float(float, float)> angle(lab, "wrong.glsl", "angle");
    EXPECT_THAT(to_text(angle.explain(-0.0F, -1.0F), 8),
                testing::ContainsRegex(R"(\[-3\.14.*\] or \[3\.14|\[3\.14.*\] or \[-3\.14)"));
    Sample unmeasured{.fraction = 2.0};
    EXPECT_THAT(error_text(unmeasured), HasSubstr("not measured"));
    unmeasured.error.ulp = 3.0;
    EXPECT_EQ(error_text(unmeasured), "3 ulp, 0 absolute");
    const Explanation all =
        Function<float(float, float)>(lab, "wrong.glsl", "weight_wrong_constant").explain(0.3F, 0.7F);
    const std::string whole = to_text(all, all.steps.size());
    const std::string bounded = to_text(all, 2);
    EXPECT_GT(all.steps.size(), 2U);
    EXPECT_THAT(whole, Not(HasSubstr(" operations)")));
    EXPECT_THAT(bounded, HasSubstr(fmt::format("(2 of {} operations)", all.steps.size())));
    EXPECT_THAT(bounded, HasSubstr("most of the error"));
    EXPECT_LT(bounded.size(), whole.size());
}

TEST_F(JudgeTest, ADomainThatDoesNotFitTheFunctionIsRefused) {
    const Function<float(float, float)> weight(lab, "wrong.glsl", "weight");
    const auto whole = [](numeric::Random&) { return 1; };
    const std::pair<Domain, std::string> rows[] = {
        {{}, "the domain has 0 entries, weight takes 2 inputs"},
        {{uniform(0, 1), unit_vector(3)}, "weight: entry 2 of the domain draws 3 numbers"},
        {{integers(0, 1), uniform(0, 1)}, "weight: entry 1 of the domain draws integers"},
        {{uniform(0, 1), made_by<int>(whole)}, "draws integers, the parameter is float radius"}};
    for (const auto& [domain, message] : rows)
        expect_error<std::invalid_argument>([&] { (void)weight.compare(exact_weight, domain); }, {message});
    const Function<int(int)> negated(lab, "types.glsl", "negate_int");
    expect_error<std::invalid_argument>([&] { (void)negated.check_rules({uniform(0, 1)}); },
                                        {"draws floats, the parameter is int i"});
}

// A check says "ok" only if enough inputs were judged: the counts of answers, and what the judge counts.

Answer answer_of(const ClassCount& ordinary, const ClassCount& nan = {}) {
    Answer answer;
    answer.classes.front() = ordinary;
    answer.classes.back() = nan;
    return answer;
}

TEST(OutcomeTest, CountsDecide) {
    struct Row {
        ClassCount ordinary;
        ClassCount nan;
        Outcome outcome;
        std::string because;
    };
    using enum Outcome;
    const Row rows[] = {
        {{.inputs = 100, .recorded = 74, .open = 1}, {}, ok, ""},
        {{.inputs = 100, .recorded = 70, .open = 6},
         {},
         not_judged,
         "24 of 100 inputs could be judged, expected 25 % at least"},
        {{.inputs = 9, .recorded = 9}, {}, not_judged, "the device promises nothing for any of its inputs"},
        {{.inputs = 9, .open = 9}, {}, not_judged, "every result would pass"},
        {{}, {}, not_judged, "there are no inputs"},
        {{.inputs = 100},
         {.inputs = 5, .recorded = 3, .open = 2},
         not_judged,
         "every result would pass for its nan inputs"},
        {{.inputs = 100}, {.inputs = 5, .recorded = 5}, ok, ""},
        {{.inputs = 100, .outside = 1, .recorded = 99}, {}, failed, ""}};
    for (const auto& [ordinary, nan, outcome, because] : rows) {
        EXPECT_EQ(answer_of(ordinary, nan).outcome(), outcome) << because;
        EXPECT_EQ(answer_of(ordinary, nan).not_judged_because(), because);
    }
    EXPECT_EQ(answer_of({.inputs = 100, .recorded = 74, .open = 1}).judged(), 25U);
    EXPECT_THAT(answer_of({.inputs = 100}, {.inputs = 5, .recorded = 5}).not_promised(),
                ElementsAre(InputClass::nan));
    Answer fault = answer_of({.inputs = 4, .recorded = 4});
    fault.fault = "pixel (-1, 0)";
    EXPECT_EQ(fault.outcome(), failed);
    EXPECT_EQ((Answer{.error = "gone", .reason = Reason::crash}).outcome(), failed);
    EXPECT_EQ((Answer{.error = "no text", .reason = Reason::unsupported}).not_judged_because(), "no text");
    Answer endless;
    for (int i = 0; i < 4; ++i) endless.add_undefined(InputClass::ordinary, NoResult::too_long, "any words");
    EXPECT_THAT(endless.not_judged_because(), EndsWith("; it takes too long: any words"));
}

// Whatever their words are.
TEST(OutcomeTest, ErrorsSayOfWhichKindTheyAre) {
    using interpreter::Error;
    EXPECT_EQ(base::reason_of(backend::DeviceLost("x")), Reason::device_lost);
    EXPECT_EQ(base::reason_of(backend::Hang("x")), Reason::hang);
    EXPECT_EQ(base::reason_of(backend::OutOfMemory("x")), Reason::out_of_memory);
    EXPECT_EQ(base::reason_of(std::bad_alloc()), Reason::out_of_memory);
    EXPECT_EQ(base::reason_of(backend::Unsupported("x")), Reason::unsupported);
    EXPECT_EQ(base::reason_of(backend::Fault("x")), Reason::error);
    EXPECT_EQ(base::reason_of(module::StepUnavailable("x")), Reason::unsupported);
    EXPECT_EQ(base::reason_of(module::StepError("x")), Reason::error);
    EXPECT_EQ(base::reason_of(module::Unchanged()), Reason::unchanged);
    EXPECT_EQ(base::reason_of(Error(Error::Kind::unknown_instruction, "x")), Reason::unsupported);
    EXPECT_EQ(base::reason_of(Error(Error::Kind::race, "x")), Reason::race);
    EXPECT_EQ(base::reason_of(Error(Error::Kind::divergent_barrier, "x")), Reason::divergent);
    EXPECT_EQ(base::reason_of(std::runtime_error("crash")), Reason::error);
}

// By the rules alone it is known of some inputs that any result would pass, and assumed of as many others.
TEST(OutcomeTest, ByTheRulesTheShareIsThatOfTheBoundedInputs) {
    Answer answer = answer_of({.inputs = 1000, .recorded = 200, .open = 30});
    answer.criterion = Criterion::rules;
    answer.bounded = 40;
    EXPECT_EQ(answer.judged(), 200U) << "a quarter of the 800 that are not recorded";
    EXPECT_EQ(answer.outcome(), Outcome::not_judged);
}

// Right outputs of a function for some inputs, judged without a device.
template <class T, class Result>
Answer judged(Question question, const std::vector<float>& xs, Result result,
              const JudgeOptions& options = {}) {
    question.signature = SignatureOf<T(float)>::describe();
    question.reference = make_reference<T(float)>(result);
    Domain::Inputs inputs;
    std::vector<Word> outputs;
    for (const float x : xs) {
        inputs.add(std::vector{to_word(x)});
        outputs.push_back(to_word(T(result(x))));
    }
    return judge(question, options, inputs, outputs);
}
template <class T>
Answer judged(const Codomain& codomain, const std::function<bool(std::span<const Word>)>& promised) {
    return judged<T>({.codomain = codomain, .promised = promised}, {1, 2, 0, 4},
                     [](double x) { return T(x); });
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
    const auto judged_below = [](float limit, bool keeps_nan) {
        const auto above = [=](double x) { return std::isnan(x) || x > limit; };
        return judged<bool>({}, {1, 2, 3, nan}, above, {.nan = keeps_nan});
    };
    EXPECT_EQ(judged_below(9.0F, true).outcome(), Outcome::ok);
    EXPECT_EQ(judged_below(2.5F, false).outcome(), Outcome::ok);
    EXPECT_EQ(judged_below(0.0F, true).outcome(), Outcome::ok) << "its inputs have one answer";
    EXPECT_EQ(judged_below(9.0F, false).not_judged_because(),
              "no input could be judged whose result is true: a function that is always false would pass");
}

TEST(OutcomeByRules, WhatVulkanLeavesUndefinedIsNotJudged) {
    const Lab lab = test::make_lab(FIXTURES);
    const Function<float(float)> sine(lab, "rules.glsl", "sine");
    const auto sine_in = [&](const Values& values) { return sine.check_rules({values}, {.inputs = 600}); };
    const Answer undefined = sine_in(uniform(10, 20));
    EXPECT_EQ(undefined.outcome(), Outcome::not_judged);
    EXPECT_EQ(undefined.not_judged_because(), "every result would pass");
    const Answer defined = sine_in(uniform(-3, 3));
    EXPECT_EQ(defined.outcome(), Outcome::ok) << defined;
    EXPECT_EQ(defined.judged(), 600U);
    const Answer both = sine_in(uniform(-3, 3).and_value(1e30F));
    EXPECT_EQ(both.outcome(), Outcome::ok) << both;
    EXPECT_THAT(both.not_promised(), ElementsAre(InputClass::huge)) << "no failure of the check";
}

TEST(OutcomeByRules, TheyJudgeWhereNothingElseIsPromised) {
    Question question = question_with<float(float)>("rules.glsl", "reciprocal", {uniform(1, 2)},
                                                    [](double x) { return 1.0 / x; });
    question.promised = nothing;
    const Answer few = run(test::make_lab(FIXTURES), question, {.inputs = 512});
    EXPECT_EQ(few.judged(), 512U);
    const Answer many = run(test::make_lab(FIXTURES), question, {.inputs = 65'536});
    EXPECT_EQ(many.outcome(), Outcome::not_judged) << "the rules were asked for some inputs only";
}

}  // namespace gloam::judge::judge_test
