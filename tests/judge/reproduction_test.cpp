// SPDX-License-Identifier: MIT
#include "judge/reproduction.hpp"
#include "subject/fixture_functions.hpp"

namespace gloam::judge::reproduction_test {

using namespace subject;

using numeric::Bounds;

// 1e-4 too large.
Question wrong_weight() {
    return question_with<float(float, float)>("wrong.glsl", "weight_wrong_constant",
                                              {uniform(-10, 10), uniform(0.5, 8)}, exact_weight,
                                              {.ulp = 2, .absolute = 4e-7});
}

TEST(Reproduction, AFailureComesWithItsSimplestInputAndAShaderOfItsOwn) {
    const Lab lab = test::make_lab(FIXTURES);
    const RunOptions options{.inputs = 1000};
    const Answer result = run(lab, wrong_weight(), options);
    ASSERT_FALSE(result.passed());
    const Reproduction all = reproduce(lab, wrong_weight(), options, *result.worst);
    EXPECT_EQ(all.inputs, (std::vector<Word>{0U, to_word(1.0F)}));  // at the centre, radius 1
    ASSERT_TRUE(all.failure);
    EXPECT_EQ(all.failure->inputs, all.inputs);
    ASSERT_EQ(all.outcomes.size(), 1U);
    EXPECT_EQ(all.failure->permitted, all.outcomes.front());
    const Bounds allowed = all.outcomes.front().at(0);
    EXPECT_FALSE(allowed.contains(static_cast<double>(from_word<float>(all.failure->got[0]))));
    EXPECT_TRUE(allowed.contains(1.0));

    EXPECT_EQ(all.glsl.find("#include"), std::string::npos);
    EXPECT_TRUE(all.glsl.starts_with("#version 450\n"));
    EXPECT_FALSE(module::compile({.name = "alone", .text = all.glsl}, {}).empty());
    EXPECT_EQ(all.spirv.at(0), 0x07230203U);
    EXPECT_THAT(all.assembly, HasSubstr("OpEntryPoint GLCompute"));
}

TEST(Reproduction, InputsThatAreConstantsStayConstants) {
    for (const char* variant : {"literals", "specialization"}) {
        const Lab lab = test::make_lab(FIXTURES, module::variant(variant));
        const Answer result = run(lab, wrong_weight(), {});
        ASSERT_FALSE(result.passed()) << variant;
        const Reproduction all = reproduce(lab, wrong_weight(), {}, *result.worst);
        EXPECT_EQ(all.inputs, (std::vector<Word>{0U, to_word(1.0F)})) << variant;
        EXPECT_EQ(all.specialized, std::string(variant) == "specialization");
        EXPECT_EQ(all.glsl.find("constant_id") != std::string::npos, all.specialized) << all.glsl;
    }
}

TEST(Reproduction, WhatPassesIsRefused) {
    const Lab lab = test::make_lab(FIXTURES);
    Question right = wrong_weight();
    right.function = "weight";
    const Sample passing{.inputs = {to_word(0.5F), to_word(1.0F)}};
    expect_error<std::invalid_argument>([&] { (void)reproduce(lab, right, {}, passing); }, {"does not fail"});
    expect_error<std::invalid_argument>([&] { (void)reproduce_fault(lab, right, {}); },
                                        {"no access falls outside"});
    const Sample elsewhere{.scenario = "3 x 3", .inputs = passing.inputs};
    expect_error<std::invalid_argument>([&] { (void)reproduce(lab, right, {}, elsewhere); },
                                        {"no images \"3 x 3\""});
}

// A sum over the pixel and its right neighbour: at the right border it reads outside.
Question two_pixels() {
    const auto sum = [](const ImageSet& images, glm::ivec2 pixel) {
        const Image& image = images.at("fetch");
        return image.at<double>(pixel) + image.at<double>(pixel + glm::ivec2(1, 0));
    };
    const auto make = [](glm::ivec2 size, numeric::Random&) {
        return ImageSet{{"fetch", make_image<float>(size, [](glm::ivec2 p) { return p.x + 10 * p.y; })}};
    };
    Question question =
        question_with<float(glm::ivec2)>("two_pixels.glsl", "two_pixels", {image_pixel()}, sum, {.ulp = 1});
    question.scenarios = {{.name = "3 x 2", .size = {3, 2}, .make = make}};
    return question;
}

TEST(Reproduction, AnAccessOutsideAnImageIsAFaultInEveryVariant) {
    for (const char* variant : {"shipped", "literals", "specialization"})
        EXPECT_THAT(
            run(test::make_lab(FIXTURES, module::variant(variant)), two_pixels(), {.inputs = 50}).fault,
            HasSubstr("is outside the 3 x 2 image"))
            << variant;
}

Question identity_within(const Budget& budget) {
    return {.signature = SignatureOf<float(float)>::describe(),
            .reference = make_reference<float(float)>([](double x) { return x; }),
            .budget = budget};
}

TEST(AllowedOutcomes, AreTheBudgetAroundTheReference) {
    constexpr double ulp = 0x1p-24;  // between 0.5 and 1
    constexpr float tiny = 1e-30F;
    const Codomain unit{.low = 0.0, .high = 1.0};
    const auto nothing = [](std::span<const Word>) { return false; };
    const std::tuple<Budget, std::function<bool(std::span<const Word>)>, float, Bounds> rows[] = {
        {{.ulp = 2, .absolute = 1e-9}, {}, 0.75F, {0.75 - 2 * ulp, 0.75 + 2 * ulp, false}},
        {{.ulp = 2, .absolute = 1e-9}, {}, 1.0F, {1.0 - 2 * ulp, 1.0, false}},  // the codomain's end
        {{.ulp = 2, .absolute = 1e-9}, {}, tiny, {0.0, static_cast<double>(tiny) + 1e-9, false}},
        {{.ulp = 2, .backward_ulp = 3}, {}, 0.75F, {0.75 - 5 * ulp, 0.75 + 5 * ulp, false}},
        {{.ulp = 2}, nothing, 0.75F, {0.0, 1.0, false}},
        {{.ulp = 2}, {}, NAN, Bounds::only_nan()},
        {{.ulp = 2}, {}, INFINITY, Bounds::point(INFINITY)}};
    for (const auto& [budget, promised, x, bounds] : rows) {
        Question question = identity_within(budget);
        if (std::isfinite(x)) question.codomain = unit;
        question.promised = promised;
        const Sample sample{.inputs = {to_word(x)}, .want = {static_cast<double>(x)}};
        EXPECT_EQ(allowed_outcomes(question, {}, sample).at(0).at(0), bounds) << x;
    }
}

// One that the rules permit fails by what the function documents for it.
TEST(AllowedOutcomes, AreThoseOfTheRulesWhereTheyForbidTheResult) {
    const Question question = identity_within({.ulp = 0});
    Sample sample{.inputs = {to_word(0.75F)},
                  .want = {0.75},
                  .permitted = {{.low = 0.5, .high = 1.0, .nan = false}},
                  .outcomes = {}};
    EXPECT_EQ(allowed_outcomes(question, {}, sample), (std::vector<Sample::Outcome>{{Bounds::point(0.75)}}));
    sample.forbidden = true;
    EXPECT_EQ(allowed_outcomes(question, {}, sample), (std::vector<Sample::Outcome>{sample.permitted}));
    sample.outcomes = {{Bounds::point(0.5)}, {Bounds::point(1.0)}};
    EXPECT_EQ(allowed_outcomes(question, {}, sample), sample.outcomes);
}

}  // namespace gloam::judge::reproduction_test
