// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "module/spirv.hpp"
#include "subject/kernel_code.hpp"
#include "subject/lab.hpp"
#include "support/lab.hpp"

namespace gloam::subject::constant_kernel_test {

using Constants = module::Variant::Constants;

std::string module_of(const char* variant, Constants constants) {
    const Lab lab = test::make_lab(FIXTURES, module::variant(variant));
    const std::vector<Word> inputs{std::bit_cast<Word>(0.3F), std::bit_cast<Word>(0.7F)};
    const std::string text =
        constant_kernel_code(lab.source("wrong.glsl", "weight", SignatureOf<float(float, float)>::describe()),
                             constants, inputs, 1);
    return module::disassemble(
        lab.cache().compile({.name = "constants", .text = text}, lab.compile_options()));
}

TEST(ConstantCode, TheCompilerFoldsLiterals) {
    EXPECT_THAT(module_of("literals", Constants::literals),
                Not(AnyOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul"))));
    EXPECT_THAT(module_of("shipped", Constants::literals), AllOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul")));
}

TEST(ConstantCode, SpecializationConstantsAreLeftToTheDriver) {
    EXPECT_THAT(module_of("specialization", Constants::specialization),
                AllOf(HasSubstr("OpFDiv"), HasSubstr("OpFMul"), HasSubstr("SpecId 0"), HasSubstr("SpecId 1"),
                      Not(HasSubstr("SpecId 2"))));
}

// Broken kernels, with the body of main() and what the canaries and guards report: one word in, one out.
TEST(BrokenKernels, AreCaught) {
    constexpr std::size_t count = 100;
    const Lab lab = test::make_lab();
    const auto kernel = [&](const std::string& body) {
        const std::string text = fmt::format(
            "#version 450\n"
            "layout(local_size_x = 64) in;\n"
            "layout(push_constant) uniform KernelRun {{ uint count; uint row_length; uint canary; }};\n"
            "layout(std430, binding = 0) readonly buffer Inputs {{ uint inputs[]; }};\n"
            "layout(std430, binding = 1) buffer Outputs {{ uint outputs[]; }};\n"
            "layout(std430, binding = 2) buffer Faults {{ uint faults[]; }};\n"
            "void main() {{ uint i = gl_GlobalInvocationID.x; if (i >= count) return; {} }}\n",
            body);
        module::Spirv spirv = module::compile({.name = "broken kernel", .text = text}, {});
        return lab.core({{.spirv = std::move(spirv), .input_words = 1, .output_words = 1, .name = "broken"}});
    };
    const std::vector<Word> inputs(count, 7U);
    const std::string right = "outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = canary ^ i;";
    EXPECT_EQ(kernel(right).run(inputs, count).outputs, inputs);
    const std::pair<std::string, const char*> rows[] = {
        {"faults[0] += inputs[i] * 0u;", "did not finish for input 0"},
        {"if (i == 63u) return; " + right, "did not finish for input 63 of 100"},
        {"outputs[2u * i] = inputs[i]; outputs[2u * i + 1u] = 0x12345678u ^ i;", "canary"},
        {right + " if (i == 5u) outputs[2u * count + 3u] = 1u;", "wrote outside its outputs"}};
    for (const auto& [body, error] : rows)
        expect_error<backend::Fault>([&] { (void)kernel(body).run(inputs, count); }, {error});
    expect_error<std::invalid_argument>([&] { (void)kernel(right).run(inputs, 4); }, {"4 words, got 100"});
}

}  // namespace gloam::subject::constant_kernel_test
