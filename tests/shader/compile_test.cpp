// SPDX-License-Identifier: MIT
#include "shader/compile.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <thread>

#include "shader/spirv.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace compile_test {

using test::fixture;
using test::kernel;
using test::with_fixtures;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(Compile, MakesAModuleForVulkan12) {
    const Spirv module = compile(kernel("", "1.0"), {});
    ASSERT_GT(module.size(), 5u);
    EXPECT_EQ(module[0], 0x07230203u);
    EXPECT_EQ(module[1], 0x00010500u);  // SPIR-V 1.5
    EXPECT_NO_THROW(validate(module));
    EXPECT_THAT(disassemble(module), AllOf(HasSubstr("OpEntryPoint GLCompute"), HasSubstr("OpStore")));
}

TEST(Compile, KeepsNames) {
    const Source source = kernel("float named_function(float named_parameter) { return named_parameter; }",
                                 "named_function(2.0)");
    EXPECT_THAT(disassemble(compile(source, {})),
                AllOf(HasSubstr("named_function"), HasSubstr("named_parameter")));
}

TEST(Compile, ServesEveryStage) {
    const Source vertex{"v", "#version 450\nvoid main() { gl_Position = vec4(0.0); }\n"};
    const Source fragment{
        "f", "#version 450\nlayout(location = 0) out vec4 c;\nvoid main() { c = gl_FragCoord; }\n"};
    EXPECT_THAT(disassemble(compile(vertex, {.stage = Stage::vertex})), HasSubstr("OpEntryPoint Vertex"));
    EXPECT_THAT(disassemble(compile(fragment, {.stage = Stage::fragment})),
                HasSubstr("OpEntryPoint Fragment"));
    EXPECT_THROW(static_cast<void>(compile(vertex, {.stage = Stage::fragment})), CompileError);
}

TEST(Compile, IncludesNeedNoExtensionLine) {
    EXPECT_NO_THROW(static_cast<void>(
        compile(kernel("#include \"math/hypot.glsl\"", "fx_hypot(3.0, 4.0)"), with_fixtures())));
}

TEST(Compile, IncludesBearAnExtensionLine) {
    const Source source =
        kernel("#extension GL_GOOGLE_include_directive : require\n#include \"math/hypot.glsl\"",
               "fx_hypot(3.0, 4.0)");
    EXPECT_NO_THROW(static_cast<void>(compile(source, with_fixtures())));
}

TEST(Compile, IncludesLookInTheFolderOfTheSource) {
    Source source = kernel("#include \"neighbour.glsl\"", "fx_cube(2.0)");
    EXPECT_THROW(static_cast<void>(compile(source, with_fixtures())), CompileError);
    source.name = fixture("math/kernel.comp").string();
    EXPECT_NO_THROW(static_cast<void>(compile(source, {})));
}

TEST(Compile, UnreachedFunctionsMayCallPrototypes) {
    EXPECT_NO_THROW(static_cast<void>(compile(kernel("#include \"fetch.glsl\"", "1.0"), with_fixtures())));
}

TEST(Compile, OptimisesWhenAsked) {
    const Source source = kernel(
        "#include \"math/square.glsl\"\n"
        "layout(std430, binding = 1) buffer In { float value[]; };",
        "fx_square(value[0]) + 0.0 * value[1] * float(1 + 2)");
    const Spirv plain = compile(source, with_fixtures());
    const Spirv fast = compile(source, with_fixtures(Optimization::performance));
    const Spirv small = compile(source, with_fixtures(Optimization::size));
    EXPECT_THAT(disassemble(plain), HasSubstr("OpFunctionCall"));
    EXPECT_THAT(disassemble(fast), Not(HasSubstr("OpFunctionCall")));
    EXPECT_LT(fast.size(), plain.size());
    EXPECT_LT(small.size(), plain.size());
    EXPECT_NO_THROW(validate(fast));
    EXPECT_NO_THROW(validate(small));
}

TEST(Compile, IsTheSameEveryTimeInEveryThread) {
    const Source source = kernel("#include \"math/hypot.glsl\"", "fx_hypot(3.0, 4.0)");
    const CompileOptions options = with_fixtures(Optimization::performance);
    const Spirv expected = compile(source, options);
    std::array<Spirv, 4> results;
    {
        std::vector<std::jthread> threads;
        for (Spirv& result : results)
            threads.emplace_back([&] {
                for (int i = 0; i < 5; ++i) result = compile(source, options);
            });
    }
    for (const Spirv& result : results) EXPECT_EQ(result, expected);
}

TEST(Compile, TakesHlsl) {
    const std::string text =
        "RWStructuredBuffer<float> result : register(u3);\n[numthreads(4, 1, 1)]\nvoid main(uint3 id : "
        "SV_DispatchThreadID) { result[id.x] = ";
    EXPECT_THAT(disassemble(compile_hlsl({"h", text + "frac(1.5f); }\n"}, Stage::compute)),
                AllOf(HasSubstr("Binding 3"), HasSubstr("StorageBuffer")));
    EXPECT_THAT(test::message_of<CompileError>(
                    [&] { (void)compile_hlsl({"h", text + "no_such; }\n"}, Stage::compute); }),
                HasSubstr("h:3: "));
    EXPECT_THAT(test::message_of<CompileError>([&] {
                    (void)compile_hlsl({"h", "cbuffer B { float y; };\n" + text + "y; }\n"}, Stage::compute);
                }),
                HasSubstr("uniform buffers"));
}

TEST(Compile, NamesItsTools) {
    EXPECT_THAT(compiler_version(),
                AllOf(HasSubstr("glslang "), HasSubstr("SPIRV-Tools "), HasSubstr("SPIRV-Cross ")));
}

}  // namespace compile_test
}  // namespace gloam::shader
