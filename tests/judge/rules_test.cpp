// SPDX-License-Identifier: MIT
// Verdicts by Vulkan's precision rules: permitted results pass, all others fail, and no tolerance is chosen
// by hand.
#include "judge/question.hpp"
#include "judge/run.hpp"
#include "numeric/numbers.hpp"
#include "subject/fixture_functions.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::judge::rules_test {

using namespace subject;

using numeric::Bounds;

class RulesTest : public testing::Test {
  protected:
    template <class Signature>
    Answer judged(const std::string& function, const Domain& domain) {
        return Function<Signature>(lab, "rules.glsl", function).check_rules(domain, {.inputs = 8192});
    }

    Lab lab = test::make_lab(FIXTURES);
    const Domain pairs{signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e3)};
};

TEST_F(RulesTest, ARightFunctionPassesAndIsBounded) {
    const Answer result = judged<float(float, float)>("quotient", pairs);
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_LE(result.fraction, 1.0);
    EXPECT_EQ(result.by_rules, 8192U);
    EXPECT_EQ(result.bounded, 2048U);  // every fourth one
    EXPECT_EQ(result.unbounded, 0U);
    EXPECT_GT(result.guarantee.ulp, 2.4);
    EXPECT_LE(result.guarantee.ulp, 5.0);
}

// Hundreds of floats are permitted for a power, and infinity for one that nearly overflows; a quotient is
// known to a few units in the last place, which rarely touch a power of two.
TEST_F(RulesTest, ATestOfTheExponentIsDecidedByTheBounds) {
    const std::pair<const char*, Values> rows[] = {{"power_or_one", uniform(60, 80)},
                                                   {"power_or_one", uniform(88.7, 88.75)},
                                                   {"exponent", log_uniform(3.5, 1e3)}};
    for (const auto& [function, values] : rows) {
        const Answer answer = judged<float(float)>(function, {values});
        EXPECT_TRUE(answer.passed()) << function << answer;
        EXPECT_EQ(answer.unbounded, 0U) << function;
        EXPECT_EQ(answer.bounded, 2048U) << function;
    }
    EXPECT_GT(judged<float(float)>("power_or_one", {uniform(60, 80)}).guarantee.ulp, 100.0);
    EXPECT_EQ(judged<float(float)>("exponent", {uniform(3.0 - 2e-7, 3.0 + 2e-7)}).outcome(),
              Outcome::not_judged)
        << "the quotient lies on either side of 1";
}

// After 65,536 iterations of one invocation, llvmpipe of Mesa 22.3 ends all loops of its group: no device
// gets such an input.
TEST_F(RulesTest, AnInputThatTakesLongDoesNotFailItsNeighbours) {
    const Answer result = run(lab,
                              {.file = "rules.glsl",
                               .function = "wrapped",
                               .signature = SignatureOf<float(float, int)>::describe(),
                               .domain = {uniform(-100.0, 100.0), integers(0, 3)},
                               .defined = false},
                              {.inputs = 18});
    EXPECT_EQ(result.outside(), 0U) << result;
    EXPECT_EQ(result.undefined, 1U);
    EXPECT_EQ(result.judged(), 17U);
}

// The interpreter runs the very module that the driver was given, so a wrong result needs a driver that is
// wrong: outputs are moved behind its back.
class TamperedTest : public RulesTest {
  protected:
    // What is said of a function's outputs, each float changed.
    template <class Change>
    static Answer changed(const char* variant, const std::string& function, const Domain::Inputs& inputs,
                          Change change) {
        const Lab other = test::make_lab(FIXTURES, module::variant(variant));
        const Signature signature = SignatureOf<float(float, float)>::describe();
        KernelCore::Result result =
            other.kernel("rules.glsl", function, signature).run(inputs.words, inputs.count());
        for (Word& word : result.outputs) word = to_word(change(from_word<float>(word)));
        return judge({.function = function, .signature = signature},
                     {.criterion = Criterion::rules, .modules = result.modules}, inputs, result.outputs);
    }
    // Moved by that many floats.
    static Answer moved(const char* variant, const std::string& function, const Domain& domain, int floats) {
        return changed(variant, function, domain.draw(4096, 1),
                       [floats](float got) { return numeric::step(got, floats); });
    }
};

TEST_F(TamperedTest, AQuotientMayBeTwoUlpOffAndNotFour) {
    const Domain positive{log_uniform(1e-3, 1e3), log_uniform(1e-3, 1e3)};
    const Domain::Inputs inputs = positive.draw(4096, 1, {1, 1});
    std::size_t powers = 0;  // quotients that are powers of two, as of equal numbers
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto row = inputs.row(i);
        int exponent = 0;
        if (std::frexp(double{from_word<float>(row[0])} / double{from_word<float>(row[1])}, &exponent) == 0.5)
            ++powers;
    }
    for (const char* variant : {"shipped", "strict", "optimized"}) {
        EXPECT_EQ(moved(variant, "quotient", positive, 2).forbidden, powers)
            << variant << ": above a power of two, two floats are four ULP";
        EXPECT_EQ(moved(variant, "quotient", positive, -1).forbidden, 0U) << variant;
        EXPECT_EQ(moved(variant, "quotient", positive, 3).forbidden, 4096U)
            << variant << ": 2.5 ULP end inside";
        EXPECT_EQ(moved(variant, "quotient", positive, 4).forbidden, 4096U) << variant;
        EXPECT_EQ(moved(variant, "quotient", positive, -4).forbidden, 4096U) << variant;
    }
}

// (x - y) + c is exact but for one rounding; (x + c) - y loses the last digits of c. A quotient of half
// precision has its own rules.
TEST_F(TamperedTest, SumsHaveEveryOrderUnlessTheyArePrecise) {
    struct Row {
        const char* variant;
        const char* function;
        Domain domain;
        int floats;
        bool forbidden;
    };
    const Domain close{uniform(1000, 1001), uniform(1000, 1001)};
    const Domain ones{log_uniform(0.1, 10), log_uniform(0.1, 10)};
    const Row rows[] = {{"strict", "difference", pairs, 0, false},
                        {"shipped", "sum", close, 256, false},
                        {"strict", "sum", close, 0, false},
                        {"strict", "sum", close, 256, true},
                        {"shipped", "sum", {constant(1000.75F), constant(1000.25F)}, 1 << 20, true},
                        {"relaxed", "quotient", ones, 1000, false},
                        {"strict", "quotient", ones, 1000, true}};
    for (const auto& [variant, function, domain, floats, forbidden] : rows)
        EXPECT_EQ(moved(variant, function, domain, floats).forbidden, forbidden ? 4096U : 0U)
            << variant << " " << function << " " << floats;
    for (const char* variant : {"strict", "shipped"})
        EXPECT_GT(moved(variant, "difference", pairs, 2).forbidden, 3900U) << "one operation has one order";
}

TEST_F(TamperedTest, AFailureTellsWhatWasPermitted) {
    const Answer answer = moved("shipped", "quotient", {constant(6.0F), constant(2.0F)}, 9);
    ASSERT_TRUE(answer.worst);
    EXPECT_TRUE(answer.worst->forbidden);
    EXPECT_THAT(describe(SignatureOf<float(float, float)>::describe(), answer),
                AllOf(HasSubstr("permitted [2.99999"), HasSubstr("Vulkan's precision rules")));
}

// Each half is one of the two beside 1.0003.
TEST_F(TamperedTest, AFailureHasEachOutcome) {
    const Domain input{constant(1.0003F), constant(0.0F)};
    const Answer answer = moved("strict", "half_of", input, 100);
    ASSERT_TRUE(answer.worst);
    const Sample& one = *answer.worst;
    EXPECT_EQ(one.outcomes,
              (std::vector<Sample::Outcome>{{Bounds::point(1.0)}, {Bounds::point(1.0 + 0x1p-10)}}));
    EXPECT_EQ(one.permitted, (Sample::Outcome{{.low = 1.0, .high = 1.0 + 0x1p-10, .nan = false}}));
    EXPECT_THAT(describe(SignatureOf<float(float, float)>::describe(), answer),
                HasSubstr("permitted 1 (0x1p+0); or 1.00097656 (0x1.004p+0)\n"));
    EXPECT_THAT(moved("strict", "quotient", input, 9).worst->outcomes, IsEmpty()) << "there is one";
}

TEST_F(TamperedTest, OfManyOutcomesNeighboursAreMergedButNotAroundAForbiddenResult) {
    const Answer answer = moved("strict", "whole_power", {constant(9.0F), constant(0.0F)}, 1);
    ASSERT_TRUE(answer.worst) << answer;
    const auto got = static_cast<double>(from_word<float>(answer.worst->got.front()));
    const Bounds all = answer.worst->permitted.front();
    EXPECT_TRUE(all.contains(got));
    EXPECT_EQ(answer.worst->outcomes.size(), Sample::most_outcomes);
    EXPECT_GT(all.high - all.low, Sample::most_outcomes);
    for (double permitted = all.low; permitted <= all.high; ++permitted)
        EXPECT_TRUE(std::ranges::any_of(answer.worst->outcomes, [=](const Sample::Outcome& outcome) {
            return outcome.front().contains(permitted);
        })) << permitted;
    for (const Sample::Outcome& outcome : answer.worst->outcomes)
        EXPECT_FALSE(outcome.front().contains(got)) << outcome.front().low << " " << outcome.front().high;
}

TEST_F(TamperedTest, WhatIsForbiddenFailsHoweverWideTheBudgetIs) {
    const Signature signature = SignatureOf<float(float, float)>::describe();
    const Domain::Inputs inputs = pairs.draw(256, 1);
    KernelCore::Result result =
        lab.kernel("rules.glsl", "quotient", signature).run(inputs.words, inputs.count());
    for (Word& word : result.outputs) word += 8;
    const Question question{
        .signature = signature,
        .reference = make_reference<float(float, float)>([](double x, double y) { return x / y; }),
        .budget = {.ulp = 1000}};
    EXPECT_EQ(judge(question, {}, inputs, result.outputs).outside(), 0U)
        << "without modules nothing is asked of the rules";
    const Answer answer = judge(question, {.modules = result.modules}, inputs, result.outputs);
    EXPECT_EQ(answer.outside(), 256U);
    EXPECT_EQ(answer.forbidden, 256U);
}

// Where a NaN or an infinity meets an operation, and where SignedZeroInfNanPreserve binds none of them or
// all.
TEST_F(TamperedTest, SpecialsAreJudgedByInstruction) {
    struct Row {
        const char* function;
        float x;
        float got;
        bool forbidden;
    };
    for (const auto& [function, x, got, forbidden] :
         {Row{"abs_is_number", nan, 1.0F, false},  // no wording lists FAbs, the first no comparison
          {"abs_is_number", nan, 0.0F, false},
          {"abs_is_number", nan, 0.5F, true},
          {"abs_is_number", -2.0F, 0.0F, true},
          {"least", infinity, 7.0F, false},  // nor FMin
          {"least", 5.0F, 7.0F, true},
          {"half_of", infinity, 7.0F, false},  // nor PackHalf2x16
          {"half_of", 1e6F, 7.0F, true},
          {"is_infinite", infinity, 0.0F, false},
          {"is_infinite", 1.0F, 1.0F, true},
          {"scaled", infinity, 7.0F, false},  // nor any other extended instruction
          {"scaled", 8.0F, 7.0F, true},
          {"whole_part", infinity, 7.0F, false},
          {"whole_part", 8.5F, 7.0F, true},
          {"packed", infinity, 7.0F, false},
          {"packed", 1.0F, 7.0F, true},
          {"beside", infinity, 7.0F, false},
          {"beside", 3.0F, 1.0F, true},
          {"facing", infinity, 7.0F, false},
          {"facing", 2.0F, 7.0F, true},
          {"difference", infinity, 7.0F, true},  // all list OpFSub
          {"difference", infinity, infinity, false},
          {"quotient", 1.0F, 5.0F, true},  // a division by zero is an infinity
          {"quotient", 1.0F, infinity, false},
          {"quotient", 1.0F, -infinity, false},
          {"quotient", 0.0F, 5.0F, false}}) {
        Domain::Inputs inputs;
        inputs.add(std::vector{to_word(x), to_word(0.0F)});
        const Answer answer = changed("strict", function, inputs, [got](float) { return got; });
        EXPECT_EQ(answer.forbidden, forbidden ? 1U : 0U) << function << " " << x << " " << got;
    }
}

TEST_F(RulesTest, AnUndecidedBranchPermitsBothSidesAndIntegersInReach) {
    EXPECT_TRUE((judged<float(float)>("branch", {uniform(0, 9).and_near({3.0})}).passed()));
    EXPECT_TRUE((judged<int(float)>("whole", {uniform(0, 300).and_near({3.0, 6.0, 99.0})}).passed()));
}

TEST_F(RulesTest, EveryVariantIsAskedTheRulesAndSomeTheRulesAlone) {
    const Question question = question_with<float(float, float)>(
        "rules.glsl", "quotient", pairs, [](double x, double y) { return x / y; }, {.ulp = 2.5});
    for (const module::Variant& variant : module::variants()) {
        const Lab other = test::make_lab(FIXTURES, variant);
        const Answer result = run(other, question, {.inputs = 512});
        EXPECT_TRUE(result.passed()) << variant.name << result;
        EXPECT_EQ(result.differs, 0U) << variant.name;
        const bool constants = variant.constants != module::Variant::Constants::none;
        EXPECT_EQ(result.inputs(), constants ? 64U : 512U) << variant.name;
        EXPECT_EQ(result.by_rules, result.inputs()) << variant.name;
        EXPECT_EQ(result.criterion, variant.strict ? Criterion::rules : Criterion::budget) << variant.name;
        Question wrong = question;
        wrong.reference =
            make_reference<float(float, float)>([](double x, double y) { return 1.001 * x / y; });
        // A wrong shader is no wrong driver.
        EXPECT_EQ(run(other, wrong, {.inputs = 512}).failed(), result.criterion == Criterion::budget)
            << variant.name;
    }
}

TEST(FractionOfWidth, IsMeasuredFromTheExactResultToItsSide) {
    struct Row {
        double got, exact, fraction;
        Bounds bounds = {1.0, 4.0, false};
    };
    for (const auto& [got, exact, fraction, bounds] :
         {Row{2, 2, 0}, Row{3, 2, 0.5}, Row{1.5, 2, 0.5}, Row{5, 2, 1.5},
          Row{1, 9, 0, Bounds::point(1)},  // inside, wherever the exact result is
          Row{2, 1, infinity, Bounds::point(1)}, Row{nan, 2, infinity}, Row{nan, 2, 0, {1.0, 4.0, true}},
          Row{2, nan, infinity, Bounds::only_nan()}})
        EXPECT_EQ(fraction_of_width(got, exact, bounds), fraction) << got << " beside " << exact;
}

}  // namespace gloam::judge::rules_test
