// SPDX-License-Identifier: MIT
// Every equation of the catalogue, compiled strictly: the interpreter against the device.
#include "check/interpreted_kernel.hpp"
#include "check/own_function.hpp"
#include "check/run.hpp"
#include "interpreter/internal/code.hpp"
#include "interpreter/internal/opcodes.hpp"
#include "module/metamorphic.hpp"
#include "module/spirv.hpp"
#include "support/devices.hpp"
#include "support/entries.hpp"
#include "support/lab.hpp"
#include "support/random_function.hpp"

namespace gloam {

using catalogue::Entry;
using check::InterpretedKernel;
using check::Word;

namespace catalogue_test {

// Whether Vulkan leaves every operation of a program one result, but for flushing, NaN and the sign of zero.
bool has_one_result(const interpreter::internal::Code& code) {
    using interpreter::internal::extended;
    constexpr std::array several{SpvOpFDiv,
                                 SpvOpFRem,
                                 SpvOpFMod,
                                 SpvOpDot,
                                 SpvOpQuantizeToF16,
                                 SpvOpMatrixTimesVector,
                                 SpvOpVectorTimesMatrix,
                                 SpvOpMatrixTimesMatrix};
    constexpr std::array rounded{
        GLSLstd450RoundEven, GLSLstd450Trunc,    GLSLstd450FAbs,     GLSLstd450Floor,    GLSLstd450Ceil,
        GLSLstd450FMin,      GLSLstd450FMax,     GLSLstd450FClamp,   GLSLstd450Step,     GLSLstd450SAbs,
        GLSLstd450UMin,      GLSLstd450SMin,     GLSLstd450UMax,     GLSLstd450SMax,     GLSLstd450UClamp,
        GLSLstd450SClamp,    GLSLstd450FindILsb, GLSLstd450FindUMsb, GLSLstd450FindSMsb, GLSLstd450Ldexp};
    return std::ranges::all_of(code.instructions, [&](const interpreter::internal::Instruction& i) {
        if (i.op >= interpreter::internal::copy) return true;
        if (i.op >= extended) return std::ranges::find(rounded, i.op - extended) != rounded.end();
        return std::ranges::find(several, static_cast<SpvOp>(i.op)) == several.end();
    });
}

// Zeros, subnormals, infinities and NaN apart: devices may flush and lose signs.
bool is_usual(Word word) {
    const auto x = check::from_word<float>(word);
    return std::isnormal(x) && std::abs(x) > 1e-15F && std::abs(x) < 1e15F;
}

class CatalogueTest : public testing::TestWithParam<std::size_t> {
  protected:
    const Entry& entry_ = test::entries()[GetParam()];
};

// Bit for bit, where there is one result.
TEST_P(CatalogueTest, IsTheDevicesWhereThereIsOneResult) {
    const check::Lab lab = test::make_lab({}, shader::variant("strict"));
    const check::Question& c = entry_.question;
    const check::KernelCore kernel = lab.kernel(c.file, c.function, c.signature);
    const interpreter::Program program(kernel.module().spirv);
    const bool one_result = has_one_result(program.code());
    const auto scalars = c.signature.input_scalars();
    const std::size_t width = c.signature.output_words();
    std::size_t compared = 0;
    std::vector<check::ImageScenario> scenarios = c.scenarios;
    if (scenarios.empty()) scenarios.push_back({});
    for (const check::ImageScenario& scenario : scenarios) {
        numeric::Random random(1);
        const check::ImageSet images =
            scenario.make ? scenario.make(scenario.size, random) : check::ImageSet{};
        const check::Domain::Inputs inputs = c.domain.draw(512 / scenarios.size(), 1, scenario.size);
        const check::KernelCore::Result device = kernel.run(inputs.words, inputs.count(), images);
        const auto words = image_words(kernel.module().prototypes, images, c.function);
        InterpretedKernel<float> ours(program, kernel.module(), words);
        for (std::size_t i = 0; i < inputs.count(); ++i) {
            ours.run(inputs.row(i));
            bool usual = one_result;
            for (std::size_t k = 0; k < scalars.size(); ++k)
                usual = usual && (scalars[k] != shader::Scalar::float_ || is_usual(inputs.row(i)[k]));
            for (std::size_t w = 0; usual && w < width; ++w) {
                const Word got = device.outputs[i * width + w];
                if ((got | 0x80000000U) == 0x80000000U) continue;
                ASSERT_EQ(ours.output(w).bits(), got) << "input " << i << ", output " << w;
                ++compared;
            }
        }
    }
    RecordProperty("compared", static_cast<int>(compared));
}

// Whatever it is made of: the device's results are permitted, every input asked.
TEST_P(CatalogueTest, PermitsTheDevicesResults) {
    const check::Lab lab = test::make_lab({}, shader::variant("strict"));
    constexpr std::size_t inputs = 1024;
    const check::Answer result = check::run(lab, entry_.question, {.inputs = inputs});
    EXPECT_FALSE(result.failed()) << result;
    EXPECT_EQ(result.by_rules + result.recorded(), inputs);
}

INSTANTIATE_TEST_SUITE_P(Equations, CatalogueTest, test::entry_numbers(), test::entry_name);

}  // namespace catalogue_test

// Random functions whose operations have one legal result each: every device at hand, the module after each
// compiler, and modules changed without a change of meaning, all give what the interpreter gives.

namespace random_module_test {

constexpr std::size_t inputs_of_each = 64;

// A random function in a lab, compiled strictly.
struct Subject {
    Subject(std::uint64_t seed, shader::Variant variant, const std::shared_ptr<backend::Backend>& device)
        : text(test::random_function(seed)),
          lab({.variant = strict(std::move(variant)),
               .excerpts = shader::excerpts({file, text}, {}).functions},
              device),
          question(check::question_of(lab, file,
                                      check::own_functions(lab.options(), file, {name(seed)}).found.at(0),
                                      {check::range_from(test::random_function_range)})) {}

    static constexpr const char* file = "random.glsl";
    static std::string name(std::uint64_t seed) { return "random_" + std::to_string(seed); }
    static shader::Variant strict(shader::Variant variant) {
        variant.strict = true;
        return variant;
    }

    [[nodiscard]] check::Answer answer() const {
        return check::run(lab, question, {.inputs = inputs_of_each});
    }

    std::string text;
    check::Lab lab;
    check::Question question;
};

class RandomModule : public testing::TestWithParam<int> {
  protected:
    [[nodiscard]] static std::vector<std::uint64_t> seeds() {
        std::vector<std::uint64_t> all(6);
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = static_cast<std::uint64_t>(GetParam()) * 1000U + i;
        return all;
    }
};

TEST_P(RandomModule, MeansTheSameToEveryDevice) {
    for (const gpu::DeviceInfo& info : test::devices_at_hand()) {
        const auto device = std::make_shared<gpu::Device>(gpu::DeviceOptions{.device = info.name});
        for (const std::uint64_t seed : seeds()) {
            const Subject subject(seed, shader::variant("strict"), device);
            const check::Answer answer = subject.answer();
            ASSERT_TRUE(answer.passed()) << info.name << "\n" << answer << subject.text;
        }
    }
}

// A module after a compiler's steps means what the module before them means.
TEST_P(RandomModule, MeansTheSameWhenItIsOptimised) {
    for (const std::uint64_t seed : seeds()) {
        for (const char* variant : {"strict | spirv-opt -O", "strict | spirv-opt -Os"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Answer answer = subject.answer();
            EXPECT_TRUE(answer.passed()) << variant << "\n" << answer << subject.text;
        }
    }
}

// The outputs of a module, rounded correctly.
std::vector<Word> outputs_of(const Subject& subject, check::KernelModule module, const shader::Spirv& spirv) {
    module.spirv = spirv;
    const check::Domain::Inputs inputs = subject.question.domain.draw(inputs_of_each, 1);
    return subject.lab.core(std::move(module)).run(inputs.words, inputs.count()).outputs;
}

// Each change of its own, and all of a seed together, in modules with variables and in those without.
TEST_P(RandomModule, MeansTheSameToTheBitWhenItIsChangedWithoutAChangeOfMeaning) {
    std::vector<std::size_t> together(shader::metamorphic_changes);
    for (std::size_t i = 0; i < together.size(); ++i) together[i] = i;
    for (const std::uint64_t seed : seeds()) {
        for (const char* variant : {"strict", "optimized"}) {
            const Subject subject(seed, shader::variant(variant), check::interpreter());
            const check::Question& q = subject.question;
            const check::KernelModule module = subject.lab.kernel(q.file, q.function, q.signature).module();
            const std::vector<Word> want = outputs_of(subject, module, module.spirv);
            for (std::size_t i = 0; i <= together.size(); ++i) {
                const auto changed =
                    shader::metamorphic(module.spirv, seed, i < together.size() ? std::vector{i} : together);
                ASSERT_NO_THROW(shader::validate(changed.module))
                    << variant << ", seed " << seed << " " << testing::PrintToString(changed.changes);
                EXPECT_EQ(outputs_of(subject, module, changed.module), want)
                    << variant << ", seed " << seed << " " << testing::PrintToString(changed.changes);
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomModule, testing::Range(1, 5));

}  // namespace random_module_test

}  // namespace gloam
