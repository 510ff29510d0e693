// SPDX-License-Identifier: MIT
// Every equation of the catalogue, compiled strictly: the interpreter against the device.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "check/interpreted_kernel.hpp"
#include "check/run.hpp"
#include "interpreter/internal/code.hpp"
#include "interpreter/internal/opcodes.hpp"
#include "support/entries.hpp"
#include "support/lab.hpp"

namespace gloam {
namespace catalogue_test {

using catalogue::Entry;
using check::InterpretedKernel;
using check::Word;

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
        const auto words = image_words(kernel.module().images, images, c.function);
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
}  // namespace gloam
