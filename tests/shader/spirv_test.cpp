// SPDX-License-Identifier: MIT
#include "shader/spirv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace gloam::shader {
namespace spirv_test {

using test::kernel;
using test::message_of;
using testing::HasSubstr;

Spirv module() {
    return compile(kernel("", "sqrt(float(gl_GlobalInvocationID.x))"), {});
}

// The words of the module with every instruction of that opcode left out.
Spirv without(const Spirv& module, std::uint32_t opcode) {
    Spirv result(module.begin(), module.begin() + 5);
    for (std::size_t at = 5; at < module.size();) {
        const std::size_t length = module[at] >> 16;
        if ((module[at] & 0xffffu) != opcode)
            result.insert(result.end(), module.begin() + static_cast<std::ptrdiff_t>(at),
                          module.begin() + static_cast<std::ptrdiff_t>(at + length));
        at += length;
    }
    return result;
}

std::string reason_against(const Spirv& module) {
    return message_of<std::runtime_error>([&] { validate(module); });
}

TEST(Spirv, ValidModulePasses) {
    EXPECT_EQ(reason_against(module()), "");
}

TEST(Spirv, ModuleWithoutReturnIsInvalid) {
    constexpr std::uint32_t op_return = 253;
    EXPECT_THAT(reason_against(without(module(), op_return)), HasSubstr("invalid SPIR-V: "));
}

TEST(Spirv, ModuleForOpenClIsInvalidForVulkan) {
    Spirv kernel = module();
    // OpCapability Shader (1) becomes OpCapability Kernel (6).
    for (std::size_t at = 5; at + 1 < kernel.size(); at += kernel[at] >> 16)
        if (kernel[at] == ((2u << 16) | 17u)) kernel[at + 1] = 6;
    EXPECT_THAT(reason_against(kernel), HasSubstr("Kernel"));
}

TEST(Spirv, NewerModuleIsInvalidForVulkan12) {
    Spirv newer = module();
    newer[1] = 0x00010600u;
    EXPECT_THAT(reason_against(newer), HasSubstr("invalid SPIR-V: "));
}

TEST(Spirv, GarbageIsRefusedEverywhere) {
    Spirv cut = module();
    cut.resize(cut.size() - 3);
    for (const Spirv& bad : {Spirv{}, Spirv{1, 2, 3}, cut}) {
        EXPECT_NE(reason_against(bad), "");
        EXPECT_THROW(static_cast<void>(disassemble(bad)), std::runtime_error);
        EXPECT_THROW(static_cast<void>(optimize(bad, Optimization::performance)), std::runtime_error);
    }
}

TEST(Spirv, NoOptimisationLeavesTheModuleAlone) {
    EXPECT_EQ(optimize(module(), Optimization::none), module());
}

TEST(Spirv, OptimisationShrinksTheModule) {
    for (const Optimization kind :
         {Optimization::performance, Optimization::size, Optimization::hoisting, Optimization::unrolling}) {
        const Spirv optimized = optimize(module(), kind);
        EXPECT_LT(optimized.size(), module().size());
        EXPECT_EQ(reason_against(optimized), "");
    }
}

TEST(Spirv, UnrollingAsksForItOnEveryLoop) {
    const Source source{"loop.comp",
                        "#version 450\nlayout(binding = 0) buffer B { float sum; };\n"
                        "void main() { for (int i = 0; i < 9; ++i) sum += 1.0; }\n"};
    const CompileOptions options{.stage = Stage::compute};
    const Spirv looped = compile(source, options);
    const Spirv unrolled = optimize(looped, Optimization::unrolling);
    EXPECT_EQ(reason_against(unrolled), "");
    EXPECT_THAT(disassemble(optimize(looped, Optimization::hoisting)), HasSubstr(" None"));
    EXPECT_THAT(disassemble(unrolled), HasSubstr(" Unroll"));
}

TEST(Spirv, DisassemblyNamesThings) {
    EXPECT_THAT(disassemble(module()), HasSubstr("OpEntryPoint GLCompute %main \"main\""));
}

}  // namespace spirv_test
}  // namespace gloam::shader
