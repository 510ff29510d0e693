// SPDX-License-Identifier: MIT
// The interpreter as a device: whole checks with no driver at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "check/constant_kernel.hpp"
#include "check/reproduction.hpp"
#include "support/lab.hpp"

namespace gloam::check {
namespace interpreter_device_test {

using testing::HasSubstr;

Lab lab_of(const std::string& variant = "shipped") {
    return Lab({.device = std::string(interpreter_name),
                .include_roots = {GLOAM_GLSL_DIR, FIXTURES},
                .variant = shader::variant(variant)});
}

TEST(InterpreterDevice, EvaluatesAFunction) {
    const Lab lab = lab_of();
    EXPECT_EQ(lab.info().name, "interpreter");
    EXPECT_TRUE(lab.info().float32.preserves_signed_zero_inf_nan);
    const Kernel<float(float, float)> weight(lab, "wrong.glsl", "weight");
    EXPECT_EQ(weight(1.0F, 2.0F), 0.75F);
    EXPECT_THROW((void)lab.device(), std::runtime_error);
}

TEST(InterpreterDevice, JudgesRightAndWrongFunctionsInEveryVariant) {
    const Domain domain{signed_log_uniform(1e-3, 10).and_special(), uniform(0.5, 8)};
    const auto exact = [](double distance, double radius) {
        const double x = distance / radius;
        return std::abs(distance) < radius ? 1.0 - x * x : 0.0;
    };
    for (const shader::Variant& variant : shader::variants()) {
        if (variant.relaxed) continue;  // the interpreter never rounds to half precision
        const Lab lab = lab_of(variant.name);
        const Budget budget{.ulp = 2, .absolute = 4e-7};
        const Answer right = compare<float(float, float)>(lab, "wrong.glsl", "weight", exact, domain, budget,
                                                          {.inputs = 1024});
        EXPECT_TRUE(right.passed()) << variant.name << right;
        EXPECT_EQ(right.differs, 0U) << variant.name;
        if (verdict_of(variant, {.reference = make_reference<float(float)>([](double x) { return x; })}) ==
            Verdict::rules)
            continue;  // a wrong shader is no wrong driver
        EXPECT_FALSE(compare<float(float, float)>(lab, "wrong.glsl", "weight_wrong_constant", exact, domain,
                                                  budget, {.inputs = 1024})
                         .passed())
            << variant.name;
    }
}

TEST(InterpreterDevice, GivesTheResultsOfTheDriverWhereThereIsOneResult) {
    const Lab ours = lab_of("strict");
    const Lab driver = test::make_lab(FIXTURES, shader::variant("strict"));
    const Kernel<float(glm::ivec2)> a(ours, "own.glsl", "own_mean");
    const Kernel<float(glm::ivec2)> b(driver, "own.glsl", "own_mean");
    const ImageSet images{
        {"own_depth",
         make_image<float>(
             {5, 4}, [](glm::ivec2 p) { return float(p.x) * 0.3F + float(p.y); }, Border::clamp)}};
    for (int x = 0; x < 5; ++x)
        EXPECT_EQ(a.with_images(images, {glm::ivec2(x, 1)}), b.with_images(images, {glm::ivec2(x, 1)}));
}

TEST(InterpreterDevice, ReportsAnAccessOutsideAnImage) {
    const Lab lab = lab_of();
    const KernelCore kernel =
        lab.kernel("two_pixels.glsl", "two_pixels", SignatureOf<float(glm::ivec2)>::describe());
    const ImageSet images{{"fetch", make_image<float>({3, 2}, [](glm::ivec2) { return 1.0F; })}};
    const std::vector<Word> inputs{0, 0, 2, 1, 2, 0};
    const KernelCore::Result result = kernel.run(inputs, 3, images);
    ASSERT_TRUE(result.fault);
    EXPECT_EQ(to_text(*result.fault), "fetch: pixel (3, 1) is outside the 3 x 2 image (2 times, at input 1)");
}

TEST(InterpreterDevice, StoresToImages) {
    const Lab lab = lab_of();
    const Lab driver = test::make_lab(FIXTURES);
    for (const Lab* one : {&lab, &driver}) {
        const Kernel<float(glm::ivec2, glm::ivec2)> store(*one, "stores.glsl", "store_at");
        const ImageSet images{
            {"store_value", make_image<glm::vec2>({3, 2}, [](glm::ivec2) { return glm::vec2(-1); })}};
        const std::vector<std::tuple<glm::ivec2, glm::ivec2>> inputs{{{0, 0}, {1, 0}}, {{2, 1}, {0, 0}}};
        ImageSet stored;
        (void)store(inputs, images, stored);
        const Image& image = stored.at("store_value");
        EXPECT_EQ(image.at<glm::vec2>({1, 0}), glm::vec2(0, 0));
        EXPECT_EQ(image.at<glm::vec2>({2, 1}), glm::vec2(2, 1));
        EXPECT_EQ(image.at<glm::vec2>({0, 0}), glm::vec2(-1));
    }
}

TEST(InterpreterDevice, AFailureIsShrunkAndReproduced) {
    const Lab lab = lab_of();
    const Question question{.file = "wrong.glsl",
                            .function = "identity_one_up",
                            .signature = SignatureOf<float(float)>::describe(),
                            .domain = {uniform(0.1, 100)},
                            .reference = make_reference<float(float)>([](double x) { return x; })};
    const Answer answer = run(lab, question, {.inputs = 64});
    ASSERT_FALSE(answer.passed());
    EXPECT_THAT(answer.story, HasSubstr("wrong.glsl"));
    const Reproduction all = reproduce(lab, question, {.inputs = 64}, *answer.worst);
    EXPECT_EQ(all.inputs, std::vector<Word>{to_word(1.0F)});
}

}  // namespace interpreter_device_test
}  // namespace gloam::check
