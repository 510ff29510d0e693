// SPDX-License-Identifier: MIT
// Anybody's shader file: no reference, no C++ signature.
#include "check/own_function.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/lab.hpp"

namespace gloam::check {
namespace own_function_test {

using testing::ElementsAre;

class OwnFunctionTest : public testing::Test {
  protected:
    shader::Function function(const std::string& name) const {
        for (const shader::Function& own : own_functions(lab.compile_options(), "own.glsl"))
            if (own.name == name) return own;
        ADD_FAILURE() << name;
        return {};
    }
    Lab lab = test::make_lab(FIXTURES);
};

TEST_F(OwnFunctionTest, AreThoseOfTheFileItselfThatCanBeDrawnFor) {
    std::vector<std::string> names;
    for (const shader::Function& own : own_functions(lab.compile_options(), "own.glsl"))
        names.push_back(own.name);
    EXPECT_THAT(names, ElementsAre("own_root", "own_scaled", "own_mean"));
}

TEST_F(OwnFunctionTest, AreJudgedByTheRulesInEveryVariant) {
    for (const shader::Variant& variant : shader::variants()) {
        const Lab other({.device = lab.options().device,
                         .include_roots = lab.options().include_roots,
                         .variant = variant});
        for (const shader::Function& own : own_functions(other.compile_options(), "own.glsl")) {
            const Answer result = run(other, question_of(other, "own.glsl", own, {}), {.inputs = 256});
            EXPECT_TRUE(result.passed()) << variant.name << " " << own.name << "\n" << result;
            EXPECT_EQ(result.verdict, Verdict::rules);
            EXPECT_GT(result.by_rules, 0U);
        }
    }
}

TEST_F(OwnFunctionTest, DrawFromTheirRanges) {
    const Question question =
        question_of(lab, "own.glsl", function("own_root"), {{"p", {2, 3}}, {"q", {0, 1}}});
    const Domain::Inputs inputs = question.domain.draw(100, 1);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        EXPECT_GE(from_word<float>(inputs.row(i)[0]), 2.0F);
        EXPECT_LE(from_word<float>(inputs.row(i)[0]), 3.0F);
        EXPECT_LE(from_word<float>(inputs.row(i)[1]), 1.0F);
    }
    const Answer result = run(lab, question, {.inputs = 512});
    EXPECT_TRUE(result.passed()) << result;
    EXPECT_EQ(result.unbounded, 0U);
    EXPECT_GT(result.guarantee.ulp, 10.0) << "it cancels";
}

TEST_F(OwnFunctionTest, RangesAreNamesAndNumbers) {
    const auto [name, range] = range_from("x=-0.5:1e3");
    EXPECT_EQ(name, "x");
    EXPECT_EQ(range.low, -0.5);
    EXPECT_EQ(range.high, 1000.0);
    for (const char* wrong : {"", "x", "x=1", "x=2:1", "=0:1", "x=a:1", "x=0:1:2", "x=nan:1"})
        EXPECT_THROW((void)range_from(wrong), std::invalid_argument) << wrong;
}

}  // namespace own_function_test
}  // namespace gloam::check
