// SPDX-License-Identifier: MIT
#include "module/spirv.hpp"
#include "module/metamorphic.hpp"
#include "module/reflection.hpp"
#include "module/support.hpp"

namespace gloam::shader::spirv_test {

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

TEST(Spirv, FloatConstantsAreFiniteAndThereOnce) {
    const Spirv module = compile(
        kernel("const float edge = 0.5;\n",
               "float(gl_GlobalInvocationID.x) < edge ? -1e-3 : 0.5 + uintBitsToFloat(0x7f800000u) * 3.0"),
        {});
    EXPECT_EQ(float_constants(module), (std::vector<float>{0.5F, -1e-3F, 3.0F}));
}

TEST(Spirv, ModuleWithoutReturnIsInvalid) {
    constexpr std::uint32_t op_return = 253;
    EXPECT_THAT(reason_against(without(module(), op_return)), HasSubstr("invalid SPIR-V: "));
}

TEST(Spirv, NewerModuleIsInvalidForVulkan12) {
    Spirv newer = module();
    newer[1] = 0x00010600u;
    EXPECT_THAT(reason_against(newer), HasSubstr("invalid SPIR-V: "));
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

std::vector<std::string> arithmetic() {
    std::istringstream text(
        "OpFNegate OpFAdd OpFSub OpFMul OpFDiv OpFMod OpVectorTimesScalar OpMatrixTimesScalar "
        "OpVectorTimesMatrix OpMatrixTimesVector OpMatrixTimesMatrix OpOuterProduct OpDot");
    return {std::istream_iterator<std::string>(text), {}};
}

// One of each kind of float operation, in functions, on structs, vectors and matrices.
const Source everything = kernel(R"(
struct Pair { float a; vec3 b; };
layout(std430, binding = 1) buffer In { uint words[]; };
Pair halves(Pair p) { p.a *= 0.5; p.b = p.b * 0.5; return p; }
mat3 grow(mat3 m, vec3 v) { return 2.0 * m * m + outerProduct(v, v); }
float all_of(float x, vec3 v, mat3 m) {
    Pair p = halves(Pair(x, v));
    vec3 w = m * v + v * m - grow(m, v)[1] * -p.a;
    float y = mod(x, 3.0) / dot(w, p.b) + sqrt(abs(x));
    int i = int(words[1]) * 3 + int(y);
    return y > 0.5 ? y : float(i);
})",
                                 "all_of(uintBitsToFloat(words[0]), vec3(words[1]), mat3(float(words[2])))");

const Source integers{"integers",
                      "#version 450\nlayout(local_size_x = 1) in;\n"
                      "layout(std430, binding = 0) buffer Out { uint result[]; };\n"
                      "void main() { result[0] = result[1] * 3u + result[2]; }\n"};

std::set<std::string> arithmetic_results(const Disassembly& module) {
    std::set<std::string> ids;
    for (const std::string& opcode : arithmetic()) ids.merge(module.results(opcode));
    return ids;
}

std::multiset<std::string> each_once(const std::set<std::string>& ids) {
    return {ids.begin(), ids.end()};
}

TEST(NoContraction, IsOnEveryFloatArithmeticResultAndNothingElse) {
    const Spirv plain = compile(everything, {});
    for (const std::string& opcode : arithmetic())
        EXPECT_FALSE(Disassembly(plain).results(opcode).empty())
            << opcode << " is missing in the test's shader";
    const Spirv strict = with_no_contraction(plain);
    EXPECT_NO_THROW(validate(strict));
    const Disassembly module(strict);
    EXPECT_EQ(module.decorated("NoContraction"), each_once(arithmetic_results(module)));
}

TEST(NoContraction, KeepsThatOfPreciseAndChangesNothingTwice) {
    Source source = kernel("", "result[5] / result[6] - p");
    source.text.replace(source.text.find("result[gl"), 0,
                        "precise float p = float(gl_LocalInvocationIndex) * 2.0 + 1.0; ");
    const Spirv plain = compile(source, {});
    EXPECT_EQ(Disassembly(plain).decorated("NoContraction").size(), 2u);
    const Spirv once = with_no_contraction(plain);
    EXPECT_EQ(Disassembly(once).decorated("NoContraction"), each_once(arithmetic_results(Disassembly(once))));
    EXPECT_EQ(Disassembly(once).decorated("NoContraction").size(), 4u);
    EXPECT_EQ(with_no_contraction(once), once);
}

TEST(NoContraction, LeavesAModuleWithoutFloatOperationsAlone) {
    const Spirv plain = compile(integers, {});
    EXPECT_EQ(with_no_contraction(plain), plain);
    EXPECT_EQ(with_relaxed_precision(plain), plain);
}

TEST(RelaxedPrecision, IsOnEveryFloatResultButConstantsAndBitPatterns) {
    const Spirv relaxed = with_relaxed_precision(compile(everything, {}));
    EXPECT_NO_THROW(validate(relaxed));
    const Disassembly module(relaxed);
    std::set<std::string> expected;
    for (const char* type : {"%float", "%v3float", "%mat3v3float"}) expected.merge(module.of_type(type));
    for (const char* given : {"OpConstant", "OpConstantComposite", "OpBitcast"})
        for (const std::string& id : module.results(given)) expected.erase(id);
    EXPECT_GT(expected.size(), 30u);
    EXPECT_THAT(module.decorated("RelaxedPrecision"), testing::ElementsAreArray(expected));
    EXPECT_FALSE(module.results("OpBitcast").empty());
}

TEST(RelaxedPrecision, ChangesNothingTwice) {
    const Spirv once = with_relaxed_precision(compile(everything, {}));
    EXPECT_EQ(with_relaxed_precision(once), once);
}

TEST(RelaxedPrecision, LeavesDoublesAlone) {
    const Source doubles =
        kernel("layout(std430, binding = 1) buffer In { double d; };", "float(d * d + 0.5LF)");
    const Disassembly module(with_relaxed_precision(compile(doubles, {})));
    EXPECT_EQ(module.decorated("RelaxedPrecision"), each_once(module.results("OpFConvert")));
    EXPECT_FALSE(module.results("OpFConvert").empty());
}

TEST(Spirv, WhatIsNoModuleIsRefusedEverywhere) {
    const std::function<void(const Spirv&)> readers[] = {
        [](const Spirv& m) { validate(m); },
        [](const Spirv& m) { (void)disassemble(m); },
        [](const Spirv& m) { (void)optimize(m, Optimization::performance); },
        [](const Spirv& m) { (void)opengl_text(m, Language::es310, 0); },
        [](const Spirv& m) { (void)reflect(m); },
        [](const Spirv& m) { (void)float_constants(m); },
        [](const Spirv& m) { (void)with_no_contraction(m); },
        [](const Spirv& m) { (void)with_relaxed_precision(m); },
        [](const Spirv& m) { (void)metamorphic(m, 1, {0}); }};
    Spirv cut = module();
    cut.resize(cut.size() - 3);
    Spirv stuck = module();
    stuck[5] &= 0xffffu;  // an instruction of no words
    for (std::size_t i = 0; i < std::size(readers); ++i) {
        for (const Spirv& bad : {Spirv{}, Spirv{1, 2, 3}, cut, stuck}) {
            const std::string message = message_of<std::runtime_error>([&] { readers[i](bad); });
            EXPECT_NE(message, "") << i;
            if (i > 4) {
                EXPECT_THAT(message, HasSubstr("no SPIR-V module")) << i;
            }
        }
    }
}

ModuleInterface interface_of(const std::string& text) {
    return reflect(compile({.name = "text", .text = "#version 450\n" + text}, {}));
}

TEST(Reflection, ImagesSayHowTheyAreUsed) {
    const ModuleInterface all = interface_of(R"(
layout(local_size_x = 8, local_size_y = 4) in;
layout(binding = 2, rgba16ui) uniform readonly uimage2D read;
layout(binding = 0, r32f) uniform writeonly image2D written;
layout(set = 1, binding = 1, rgba32f) uniform image2D both;
layout(binding = 3) uniform sampler2D sampled;
layout(binding = 4) uniform usampler2D sampled_integers;
void main() {
    imageStore(written, ivec2(0), vec4(imageLoad(read, ivec2(0))) + texelFetch(sampled, ivec2(0), 0) +
                                      vec4(texelFetch(sampled_integers, ivec2(0), 0)));
    imageStore(both, ivec2(0), imageLoad(both, ivec2(1)));
})");
    ASSERT_EQ(all.bindings.size(), 5U);
    EXPECT_EQ(all.local_size, (std::array<std::uint32_t, 3>{8, 4, 1}));
    const std::vector<std::string> names{"written", "read", "sampled", "sampled_integers", "both"};
    const std::vector<std::string> formats{"r32f", "rgba16ui", "", "", "rgba32f"};
    const std::vector<std::string> texels{"float", "uint", "float", "uint", "float"};
    const std::vector<std::pair<bool, bool>> access{
        {false, true}, {true, false}, {true, false}, {true, false}, {true, true}};
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(all.bindings[i].name, names[i]);
        EXPECT_EQ(all.bindings[i].format, formats[i]);
        EXPECT_EQ(all.bindings[i].texel, texels[i]) << names[i];
        EXPECT_EQ(std::pair(all.bindings[i].reads, all.bindings[i].writes), access[i]) << names[i];
    }
    EXPECT_EQ(all.bindings[2].type, BindingType::sampled_image);
    EXPECT_EQ(all.bindings[4].set, 1U);
    EXPECT_FALSE(all.push_constants);
}

TEST(Reflection, BlocksSayWhereTheirMembersLie) {
    const ModuleInterface all = interface_of(R"(
struct Inner { vec2 a; uint b; };
layout(binding = 4, std430) readonly buffer Values { float first; Inner inner[3]; vec4 rest[]; } values;
layout(push_constant) uniform Parameters { mat4 m; vec2 v; ivec2 size; float f; } parameters;
layout(binding = 5, std430) buffer Out { vec4 result; };
void main() {
    result = parameters.m * vec4(parameters.v, parameters.size) * parameters.f +
             values.rest[0] * values.inner[1].a.x + values.first;
})");
    ASSERT_TRUE(all.push_constants);
    const std::vector<LaidOut>& members = all.push_constants->members;
    ASSERT_EQ(members.size(), 4U);
    EXPECT_EQ(members[0].columns, 4U);
    EXPECT_EQ(members[0].size, 64U);
    EXPECT_EQ(members[1].offset, 64U);
    EXPECT_EQ(members[2].type, "int");
    EXPECT_EQ(members[2].size, 8U);
    EXPECT_EQ(members[3].offset, 80U);
    EXPECT_EQ(all.push_constants->size, 84U);
    ASSERT_EQ(all.bindings.size(), 2U);
    ASSERT_TRUE(all.bindings[0].block);
    EXPECT_EQ(all.bindings[0].block->name, "Values");
    EXPECT_TRUE(all.bindings[0].reads && !all.bindings[0].writes);
    EXPECT_TRUE(all.bindings[1].writes);
    const std::vector<LaidOut>& values = all.bindings[0].block->members;
    EXPECT_EQ(values[1].type, "Inner");
    EXPECT_EQ(values[1].stride, 16U);
    EXPECT_EQ(values[1].size, 48U);
    EXPECT_EQ(values[1].members[1].offset, 8U);
    EXPECT_THAT(values[1].sizes, ElementsAre(3U));
    EXPECT_EQ(values[2].offset, 64U);
    EXPECT_THAT(values[2].sizes, ElementsAre(0U));
}

TEST(Reflection, ConstantsHaveTheValueOfTheText) {
    const ModuleInterface all = interface_of(R"(
layout(constant_id = 9) const float length = -0.0;
layout(constant_id = 2) const bool on = true;
layout(binding = 0) buffer Out { float result; };
void main() { if (on) result = length; })");
    ASSERT_EQ(all.constants.size(), 2U);
    EXPECT_EQ(all.constants[0].name, "on");
    EXPECT_EQ(all.constants[0].type, "bool");
    EXPECT_EQ(all.constants[0].bits, 1U);
    EXPECT_EQ(all.constants[1].id, 9U);
    EXPECT_EQ(all.constants[1].bits, 0x80000000U);
}

}  // namespace gloam::shader::spirv_test
