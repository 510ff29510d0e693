// SPDX-License-Identifier: MIT
// Checks that are prepared for another program: what it may know before the shader has run.
#include "check/prepared_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/lab.hpp"

namespace gloam::check {
namespace prepared_check_test {

using testing::HasSubstr;
using testing::IsEmpty;

Lab interpreter() {
    return Lab({.device = std::string(interpreter_name), .include_roots = {FIXTURES}});
}

Question weight_question() {
    return {.file = "wrong.glsl",
            .function = "weight",
            .signature = SignatureOf<float(float, float)>::describe(),
            .domain = Domain{signed_log_uniform(1e-3, 10).and_special(), uniform(0.5, 8)},
            .reference = make_reference<float(float, float)>([](double distance, double radius) {
                const double x = distance / radius;
                return std::abs(x) < 1.0 ? 1.0 - x * x : 0.0;
            }),
            .budget = {.ulp = 2, .absolute = 4e-7}};
}

std::size_t count(const PreparedCheck& prepared, Criterion criterion) {
    std::size_t found = 0;
    for (const PreparedScenario& scenario : prepared.scenarios)
        found += static_cast<std::size_t>(
            std::ranges::count(scenario.expectations, criterion, &Expectation::criterion));
    return found;
}

TEST(PreparedCheckTest, HasTheKernelAndAnExpectationForEachInput) {
    const PreparedCheck prepared = prepare(interpreter(), weight_question(), {.inputs = 300});
    EXPECT_THAT(prepared.kernel, HasSubstr("#version 300 es"));
    EXPECT_THAT(prepared.kernel, HasSubstr("float weight(float"));
    EXPECT_THAT(prepared.unsupported, IsEmpty());
    ASSERT_EQ(prepared.scenarios.size(), 1U);
    EXPECT_EQ(prepared.scenarios.front().inputs.count(), 300U);
    EXPECT_EQ(prepared.scenarios.front().expectations.size(), 300U);
    EXPECT_EQ(prepared.row_words, 2U);  // the output and the canary
    EXPECT_EQ(prepared.targets, 1U);
}

TEST(PreparedCheckTest, DoesNotJudgeNaNAndInfinityAndHasNoNegativeZero) {
    const PreparedCheck prepared = prepare(interpreter(), weight_question(), {.inputs = 300});
    const PreparedScenario& scenario = prepared.scenarios.front();
    for (std::size_t i = 0; i < scenario.inputs.count(); ++i) {
        const auto distance = from_word<float>(scenario.inputs.row(i)[0]);
        EXPECT_EQ(scenario.expectations[i].criterion == Criterion::recorded, !std::isfinite(distance))
            << distance;
        EXPECT_FALSE(distance == 0.0F && std::signbit(distance));
    }
    EXPECT_GT(count(prepared, Criterion::recorded), 5U);
    EXPECT_GT(count(prepared, Criterion::budget), 200U);
}

TEST(PreparedCheckTest, WithoutAPromiseOnlyZerosAndTheCodomainAreJudged) {
    Question question = weight_question();
    question.promised = [](std::span<const Word>) { return false; };
    const PreparedCheck prepared = prepare(interpreter(), question, {.inputs = 300});
    EXPECT_EQ(count(prepared, Criterion::budget), 0U);
    EXPECT_GT(count(prepared, Criterion::edge), 0U);
    EXPECT_GT(count(prepared, Criterion::codomain), 200U);
}

TEST(PreparedCheckTest, AResultThatAllowsNothingFurtherIsLeftOut) {
    Question question = weight_question();
    const auto most_wants = [&question] {
        const PreparedCheck prepared = prepare(interpreter(), question, {.inputs = 300});
        std::size_t most = 0;
        for (const Expectation& expectation : prepared.scenarios.front().expectations)
            most = std::max(most, expectation.wants.size());
        return most;
    };
    EXPECT_EQ(most_wants(), 1U);
    question.budget = {.ulp = 0, .absolute = 0, .backward_ulp = 1};
    EXPECT_GT(most_wants(), 2U);
    EXPECT_LE(most_wants(), 9U);  // the input, each of two moved both ways, both moved in four ways
}

TEST(PreparedCheckTest, NeedsAReference) {
    Question question = weight_question();
    question.reference = {};
    EXPECT_THROW((void)prepare(interpreter(), question), std::invalid_argument);
}

}  // namespace prepared_check_test
}  // namespace gloam::check
