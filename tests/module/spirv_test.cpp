// SPDX-License-Identifier: MIT
#include "module/spirv.hpp"
#include "module/reflection.hpp"
#include "module/support.hpp"

namespace gloam::module::spirv_test {

Spirv module() {
    return compile(kernel("", "sqrt(float(gl_GlobalInvocationID.x))"), {});
}

std::string reason_against(const Spirv& module) {
    return message_of<std::runtime_error>([&] { validate(module); });
}

TEST(Spirv, FloatConstantsAreFiniteAndThereOnce) {
    const Spirv module = compile(
        kernel("const float edge = 0.5;\n",
               "float(gl_GlobalInvocationID.x) < edge ? -1e-3 : 0.5 + uintBitsToFloat(0x7f800000u) * 3.0"),
        {});
    EXPECT_EQ(float_constants(module), (std::vector<float>{-1e-3F, 0.5F, 3.0F}));
}

TEST(Spirv, NewerModuleIsInvalidForVulkan12) {
    Spirv newer = module();
    newer[1] = 0x00010600u;
    EXPECT_THAT(reason_against(newer), HasSubstr("invalid SPIR-V: "));
}

TEST(Spirv, UnrollingAsksForItOnEveryLoop) {
    const source::Source source{"loop.comp",
                                "#version 450\nlayout(binding = 0) buffer B { float sum; };\n"
                                "void main() { for (int i = 0; i < 9; ++i) sum += 1.0; }\n"};
    const CompileOptions options{.stage = source::Stage::compute};
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
const source::Source everything =
    kernel(R"(
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
    source::Source source = kernel("", "result[5] / result[6] - p");
    source.text.replace(source.text.find("result[gl"), 0,
                        "precise float p = float(gl_LocalInvocationIndex) * 2.0 + 1.0; ");
    const Spirv plain = compile(source, {});
    EXPECT_EQ(Disassembly(plain).decorated("NoContraction").size(), 2u);
    const Spirv once = with_no_contraction(plain);
    EXPECT_EQ(Disassembly(once).decorated("NoContraction"), each_once(arithmetic_results(Disassembly(once))));
    EXPECT_EQ(Disassembly(once).decorated("NoContraction").size(), 4u);
    EXPECT_EQ(with_no_contraction(once), once);
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

TEST(RelaxedPrecision, LeavesDoublesAlone) {
    const source::Source doubles =
        kernel("layout(std430, binding = 1) buffer In { double d; };", "float(d * d + 0.5LF)");
    const Disassembly module(with_relaxed_precision(compile(doubles, {})));
    EXPECT_EQ(module.decorated("RelaxedPrecision"), each_once(module.results("OpFConvert")));
    EXPECT_FALSE(module.results("OpFConvert").empty());
}

TEST(Spirv, AnInterfaceHasSizesThatAreKnown) {
    const auto reflected = [](const std::string& head) { return reflect(compile(kernel(head, "1.0"), {})); };
    const std::string size = "layout(constant_id = 0) const int N = 2;\n";
    for (const char* block : {"layout(std430, binding = 1) buffer B", "layout(push_constant) uniform B"})
        EXPECT_THAT(message_of<std::runtime_error>(
                        [&] { (void)reflected(size + block + " { float x[N * 2]; float y; };"); }),
                    HasSubstr("array x: its size is an expression on specialization constants"));
    EXPECT_EQ(reflected(size + "shared float x[N * 2];").bindings.size(), 1u);
    const ModuleInterface nodes = reflected(
        "#extension GL_EXT_buffer_reference : require\nlayout(buffer_reference) buffer Node;\n"
        "layout(buffer_reference) buffer Node { Node next; };\n"
        "layout(push_constant) uniform P { Node first; float y; };");
    EXPECT_EQ(nodes.push_constants.value().size, 12u);
}

TEST(Spirv, WhatIsNoModuleIsRefusedEverywhere) {
    const std::function<void(const Spirv&)> readers[] = {
        [](const Spirv& m) { validate(m); },
        [](const Spirv& m) { (void)disassemble(m); },
        [](const Spirv& m) { (void)optimize(m, Optimization::performance); },
        [](const Spirv& m) { (void)opengl_text(m, source::Language::es310, 0); },
        [](const Spirv& m) { (void)reflect(m); },
        [](const Spirv& m) { (void)float_constants(m); },
        [](const Spirv& m) { (void)with_no_contraction(m); },
        [](const Spirv& m) { (void)with_relaxed_precision(m); }};
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

}  // namespace gloam::module::spirv_test
