// SPDX-License-Identifier: MIT
// Every equation of the catalogue on the device, over its whole domain.
#include <gtest/gtest.h>

#include "support/entries.hpp"
#include "support/lab.hpp"

namespace gloam::catalogue {
namespace sweep_test {

constexpr std::size_t inputs_per_equation = 65'536;
constexpr std::size_t strict_inputs = 512;
constexpr std::size_t hlsl_inputs = 256;

class Sweep : public testing::TestWithParam<std::size_t> {
  protected:
    // Of a built-in function the rules may permit every result: determinant(), for example.
    void expect_ok(const check::Answer& result) const {
        const bool is_ours = entry_.description.file.starts_with("gloam/");
        EXPECT_TRUE(is_ours ? result.passed() : !result.failed()) << entry_.description.id << ": " << result;
    }
    const Entry& entry_ = test::entries()[GetParam()];
};

TEST_P(Sweep, StaysWithinItsBudget) {
    const check::Lab lab = test::make_lab();
    const check::Answer result = check::run(lab, entry_.question, {.inputs = inputs_per_equation});
    expect_ok(result);
    EXPECT_EQ(result.inputs(), inputs_per_equation);
}

// Each operation rounded on its own: the narrowest bounds of Vulkan's rules, which budgets may hide errors
// inside.
TEST_P(Sweep, IsPermittedWhenStrict) {
    const check::Lab lab = test::make_lab({}, shader::variant("strict"));
    const check::Answer result = check::run(lab, entry_.question, {.inputs = strict_inputs});
    expect_ok(result);
    EXPECT_EQ(result.verdict, check::Verdict::rules);
    EXPECT_EQ(result.by_rules, strict_inputs);
}

// SPIRV-Cross and glslang of Debian 12 do not agree on the exponent of ldexp in HLSL, and frexp crashes
// glslang's HLSL front end. With other versions the two may compile, and must then be right.
bool may_be_lost_in_hlsl(const std::string& equation) {
    return equation == "BUILTIN-frexp" || equation == "BUILTIN-ldexp";
}

TEST_P(Sweep, IsTheSameEquationInHlsl) {
    const check::Lab lab = test::make_lab({}, shader::variant("hlsl"));
    const std::string& id = entry_.description.id;
    try {
        const check::Answer result = check::run(lab, entry_.question, {.inputs = hlsl_inputs});
        expect_ok(result);
    } catch (const shader::CompileError& error) {
        EXPECT_TRUE(may_be_lost_in_hlsl(id)) << id << ": " << error.what();
    }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Sweep, test::entry_numbers(), test::entry_name);

}  // namespace sweep_test

}  // namespace gloam::catalogue
