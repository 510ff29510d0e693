// SPDX-License-Identifier: MIT
// The interpreter as a device: whole checks with no driver at all.
#include "subject/fixture_functions.hpp"
#include "support/test_name.hpp"

namespace gloam::judge::devices_test {

using namespace subject;

KernelCore two_pixels(const Lab& lab) {
    return lab.kernel("two_pixels.glsl", "two_pixels", SignatureOf<float(glm::ivec2)>::describe());
}

// Whole checks on each device: on none at all, through compute shaders, and through fragment shaders.

class EachDevice : public testing::TestWithParam<const char*> {
  protected:
    static bool has_compute() {
        const auto opengl = backend::gl::device_name_from(GetParam());
        return !opengl || backend::gl::has_compute(opengl->version);
    }
    void SetUp() override {
        try {
            lab.emplace(LabOptions{.device = GetParam(), .include_roots = {GLOAM_GLSL_DIR, FIXTURES}});
        } catch (const backend::gl::Unavailable& error) {
            GTEST_SKIP() << error.what();
        }
    }
    std::optional<Lab> lab;
};
class OpenGlDevice : public EachDevice {};

TEST_P(OpenGlDevice, SaysWhoItIs) {
    EXPECT_EQ(lab->info().name, GetParam());
    EXPECT_THAT(lab->info().api_version, HasSubstr("OpenGL"));
    EXPECT_FALSE(lab->info().float32.preserves_signed_zero_inf_nan);
    EXPECT_THROW((void)lab->device(), std::runtime_error);
}

TEST_P(EachDevice, JudgesARightAndAWrongFunction) {
    const Domain domain{signed_log_uniform(1e-3, 10), uniform(0.5, 8)};
    const Budget budget{.ulp = 2, .absolute = 4e-7};
    // More inputs than a row of the targets holds.
    for (const auto& [name, right] : {std::pair{"weight", true}, {"weight_wrong_constant", false}}) {
        const Answer answer = Function<float(float, float)>(*lab, "wrong.glsl", name)
                                  .compare(exact_weight, domain, budget, {.inputs = 3000});
        EXPECT_EQ(answer.passed(), right) << answer;
        EXPECT_GT(answer.largest.absolute, 0.0);
        EXPECT_THAT(answer.story, HasSubstr(right ? "" : "wrong.glsl"));
    }
}

// Of structures, matrices and out parameters: rows that no single draw can write.
TEST_P(EachDevice, EveryTypeArrivesBitByBit) {
    const Function<glm::mat4(glm::mat4, Out<glm::mat3>, Out<glm::ivec4>)> mirrored(*lab, "opengl.glsl",
                                                                                   "mirrored");
    std::vector<std::tuple<glm::mat4>> inputs;
    for (int i = 0; i < 1500; ++i) {
        glm::mat4 m;
        for (int k = 0; k < 16; ++k) m[k / 4][k % 4] = std::ldexp(1.0F + float(i) / 4096.0F, k - 8);
        inputs.emplace_back(m);
    }
    const auto outputs = mirrored(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const glm::mat4& m = std::get<0>(inputs[i]);
        const auto& [transposed, corner, signs] = outputs[i];
        EXPECT_EQ(transposed, glm::transpose(m));
        EXPECT_EQ(corner, glm::mat3(m));
        EXPECT_EQ(signs, glm::ivec4(-1, 2, -3, 4)) << i;
    }
}

TEST_P(EachDevice, ServesImagesAndReportsAnAccessOutside) {
    const KernelCore kernel = two_pixels(*lab);
    const std::vector<Word> inputs{0, 0, 2, 1, 2, 0};
    const auto value = [](glm::ivec2 p) { return float(1 + p.x + 10 * p.y); };
    const ImageSet inside{{"fetch", make_image<float>({3, 2}, value, Border::clamp)}};
    const Lab other({.include_roots = {FIXTURES}}, interpreter_backend());
    EXPECT_EQ(kernel.run(inputs, 3, inside).outputs, two_pixels(other).run(inputs, 3, inside).outputs);
    const KernelCore::Result result = kernel.run(inputs, 3, {{"fetch", make_image<float>({3, 2}, value)}});
    ASSERT_TRUE(result.fault);
    EXPECT_THAT(to_text(*result.fault),
                AnyOf("fetch: pixel (3, 1) is outside the 3 x 2 image (2 times, at input 1)",
                      "fetch: pixel (3, 0) is outside the 3 x 2 image (2 times, at input 2)"));
}

// Section 4.7.1 of GLSL 4.60 and of GLSL ES 3.20 has precisions, and none for sin().
TEST_P(OpenGlDevice, AsksTheRulesWhereTheLanguageHasThem) {
    const backend::gl::Version version = backend::gl::device_name_from(GetParam())->version;
    const bool rules = version == backend::gl::Version{backend::gl::Api::gl, 4, 5} ||
                       version == backend::gl::Version{backend::gl::Api::es, 3, 2};
    const Answer quotient = Function<float(float)>(*lab, "rules.glsl", "reciprocal")
                                .check_rules({uniform(1, 2)}, {.inputs = 600});
    EXPECT_EQ(quotient.by_rules, rules ? quotient.inputs() : 0U);
    EXPECT_EQ(quotient.outcome(), rules ? Outcome::ok : Outcome::not_judged);
    const Answer sine =
        Function<float(float)>(*lab, "opengl.glsl", "sine").check_rules({uniform(-3, 3)}, {.inputs = 600});
    EXPECT_EQ(sine.outcome(), Outcome::not_judged);
    EXPECT_THAT(sine.not_judged_because(), HasSubstr("no precision rules"));
}

TEST_P(OpenGlDevice, SpecialInputsAreRecordedOnly) {
    const auto same = [](double x) { return x; };
    const Answer answer = Function<float(float)>(*lab, "opengl.glsl", "same")
                              .compare(same, {uniform(1, 2).and_special()}, {}, {.inputs = 600});
    EXPECT_TRUE(answer.passed()) << answer;
    EXPECT_GT(answer.recorded(), 0U);
    EXPECT_EQ(answer.judged(), answer.inputs() - answer.recorded());
    EXPECT_THAT(answer.not_promised(), ElementsAre(InputClass::infinite, InputClass::nan));
}

// The sign of a zero may be lost, so the function is given +0, and the result is judged.
TEST_P(OpenGlDevice, NegativeZeroIsJudgedAsZero) {
    const auto check = [&](double result) {
        return Function<float(float)>(*lab, "opengl.glsl", "same")
            .compare([=](double) { return result; }, {constant(-0.0F)}, {}, {.inputs = 8});
    };
    EXPECT_TRUE(check(0.0).passed()) << check(0.0);
    EXPECT_EQ(check(42.0).outside(), 8U);
}

TEST_P(EachDevice, WhatTheVersionLacksIsUnsupported) {
    const auto kernel = [&] { return Function<unsigned(unsigned)>(*lab, "opengl.glsl", "reversed_bits"); };
    if (has_compute()) {
        EXPECT_EQ(kernel()(1U), 0x80000000U);
    } else {
        EXPECT_THAT(kernel, ThrowsMessage<backend::Unsupported>(AllOf(HasSubstr("reversed_bits is no GLSL 3"),
                                                                      HasSubstr("bitfieldReverse"))));
    }
}

TEST_P(OpenGlDevice, RunsTextsOfChangedModules) {
    const auto changed = [] {
        return Lab({.device = GetParam(),
                    .include_roots = {FIXTURES},
                    .variant = module::variant("shipped | spirv-opt -O")});
    };
    if (!has_compute()) {
        EXPECT_THAT(changed, ThrowsMessage<std::invalid_argument>(HasSubstr("those with compute shaders")));
        return;
    }
    const Lab other = changed();
    const Function<unsigned(unsigned)> reversed(other, "opengl.glsl", "reversed_bits");
    EXPECT_NE(reversed.core().module().text,
              Function<unsigned(unsigned)>(*lab, "opengl.glsl", "reversed_bits").core().module().text);
    EXPECT_EQ(reversed(0xf0U), 0x0f000000U);
}

TEST_P(OpenGlDevice, HasTheVariantShippedOnly) {
    expect_error<std::invalid_argument>(
        [] { const Lab strict({.device = GetParam(), .variant = module::variant("strict")}); },
        {"have the variant shipped only"});
}

const auto opengl_devices = testing::Values("gl:llvmpipe-4.5", "gl:llvmpipe-3.3", "es:llvmpipe-3.2",
                                            "es:llvmpipe-3.1", "es:llvmpipe-3.0", "es:softpipe-3.0");
const auto name_of_device = [](const auto& info) { return test::test_name(info.param); };
INSTANTIATE_TEST_SUITE_P(All, OpenGlDevice, opengl_devices, name_of_device);
INSTANTIATE_TEST_SUITE_P(All, EachDevice, opengl_devices, name_of_device);
INSTANTIATE_TEST_SUITE_P(Interpreter, EachDevice, testing::Values("interpreter"), name_of_device);

}  // namespace gloam::judge::devices_test
