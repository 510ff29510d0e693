// SPDX-License-Identifier: MIT
// Control flow, memory and what goes wrong. Undefined integers and endless loops:
// tests/tools/stories/faults.txt.
#include <glm/gtc/packing.hpp>

#include "interpreter/shader_run.hpp"

namespace gloam::program_test {

using interpreter::Error;
using interpreter::Machine;
using interpreter::Program;

module::Spirv compiled(const std::string& text, const char* variant = "shipped") {
    return module::compile({.name = "test", .text = text}, {.variant = module::variant(variant)});
}

Error error_in(const std::string& body, const std::vector<Word>& inputs) {
    Machine<float> machine{Program(compiled(test::row_shader(4, 1, body)))};
    return test::error_of([&] { (void)test::interpreted(machine, inputs, 1); });
}

TEST(Program, LoopsWithPhisExchangeTheirValuesAtOnce) {
    const std::string body =
        "uint a = word(0); uint b = word(1);\n"
        "for (uint n = 0u; n < word(2); ++n) { uint t = a; a = b; b = t; }\n"
        "put(0u, a); put(1u, b);\n";
    const Program program(compiled(test::row_shader(4, 2, body), "optimized"));
    const Rows rows{.inputs = {5, 9, 3, 0, 5, 9, 4, 0}, .input_words = 4, .output_words = 2};
    EXPECT_EQ(test::rounded_correctly(program, rows), (std::vector<Word>{9, 5, 5, 9}));
}

TEST(Program, FloatsOf16BitsAreConstantsAndLieInBuffers) {
    const std::string text =
        "#version 450\n#extension GL_EXT_shader_16bit_storage : require\n"
        "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n"
        "layout(local_size_x = 1) in;\n"
        "layout(std430, binding = 0) readonly buffer In { float16_t a; f16vec3 v; float f; float16_t rest[]; "
        "};\n"
        "layout(std430, binding = 1) buffer Out { f16vec2 two; float16_t one; float16_t last; };\n"
        "void main() { two = f16vec2(a + 0.333hf, v.z); one = rest[1] * v.x; last = float16_t(f); }\n";
    const auto pair = [](float low, float high) { return glm::packHalf2x16({low, high}); };
    const std::vector<Word> in{pair(1.5F, 0.0F),          0,
                               pair(2.0F, 3.0F),          pair(-4.25F, 0.0F),
                               std::bit_cast<Word>(0.1F), pair(7.0F, -0.375F)};
    for (const char* variant : {"shipped", "optimized"}) {
        Machine<float> machine(Program(compiled(text, variant)));
        const auto out = test::interpreted(machine, in, 2);
        EXPECT_EQ(out[0].bits(), pair(1.8330078125F, -4.25F)) << variant;  // 0.333 has 11 bits
        EXPECT_EQ(out[1].bits(), pair(-0.75F, 0.1F)) << variant;
    }
}

TEST(Program, MatricesInBuffersLieAsTheirLayoutSays) {
    const std::string text =
        "#version 450\nlayout(local_size_x = 1) in;\n"
        "layout(std430, binding = 0) readonly buffer In { layout(row_major) mat2x3 m; layout(column_major) "
        "mat2x3 n; vec3 v; };\n"
        "layout(std430, binding = 1) buffer Out { float o[]; };\n"
        "void main() { o[0] = m[1].y; o[1] = n[1].y; o[2] = (m * vec2(1.0, 10.0)).z; o[3] = v.z; o[4] = "
        "float(o.length()); "
        "vec3 column = m[0]; o[5] = column.z; }\n";
    std::vector<Word> inputs;
    for (int k = 0; k < 20; ++k) inputs.push_back(std::bit_cast<Word>(static_cast<float>(k)));
    Machine<float> machine{Program(compiled(text))};
    const auto got = test::interpreted(machine, inputs, 6);
    // Row-major: rows of two at words 0, 2, 4. Column-major: columns at words 8 and 12.
    const std::vector<float> want{3.0F, 13.0F, 54.0F, 18.0F, 6.0F, 4.0F};
    for (std::size_t k = 0; k < want.size(); ++k) EXPECT_EQ(got[k].number(), want[k]) << k;
}

TEST(Program, SpecializationConstantsTakeTheirValues) {
    const std::string text =
        "#version 450\nlayout(local_size_x = 1) in;\n"
        "layout(constant_id = 3) const uint n = 4u; layout(constant_id = 5) const float f = 0.5;\n"
        "const uint twice = n * 2u + 1u;\n"
        "layout(std430, binding = 1) buffer Out { uint o[]; };\n"
        "void main() { uint a[n]; for (uint k = 0u; k < n; ++k) a[k] = k; o[0] = a[n - 1u]; o[1] = twice; "
        "o[2] = floatBitsToUint(f * 2.0); }\n";
    const module::Spirv module = compiled(text);
    const std::vector<interpreter::Constant> constants{{3, 9}, {5, std::bit_cast<Word>(4.0F)}};
    for (const bool given : {false, true}) {
        Machine<float> machine{given ? Program(module, constants) : Program(module)};
        const auto got = test::interpreted(machine, {}, 3);
        EXPECT_EQ(got[0].bits(), given ? 8U : 3U);
        EXPECT_EQ(got[1].bits(), given ? 19U : 9U);
        EXPECT_EQ(got[2].number(), given ? 8.0F : 1.0F);
    }
}

TEST(Program, AtomicsOfOneInvocationAreReadsAndWrites) {
    const std::string text =
        "#version 450\nlayout(local_size_x = 1) in; shared uint s;\n"
        "layout(std430, binding = 1) buffer Out { uint o[]; };\n"
        "void main() { s = 5u; o[0] = atomicAdd(s, 3u); o[1] = atomicMax(o[2], 9u); o[3] = atomicCompSwap(s, "
        "8u, 4u);\n"
        "barrier(); o[4] = s; o[5] = atomicExchange(o[6], 1u) + atomicAnd(o[2], 8u) + atomicXor(s, 1u); o[7] "
        "= s; }\n";
    Machine<float> machine{Program(compiled(text))};
    const std::vector<Word> outputs{0, 0, 2, 0, 0, 0, 70, 0};
    machine.bind(0, 1, outputs);
    for (int again = 0; again < 2; ++again) {  // each run begins with what was bound
        machine.run();
        std::vector<Word> got;
        for (std::size_t k = 0; k < outputs.size(); ++k) got.push_back(machine.read(0, 1, k).bits());
        EXPECT_EQ(got, (std::vector<Word>{5, 2, 8, 8, 4, 70 + 9 + 4, 1, 5}));
    }
}

TEST(Program, AnIndexOutsideIsAnErrorThatSaysWhere) {
    const Error array = error_in("uint a[3] = uint[3](1u, 2u, 3u); put(0u, a[word(0)]);\n", {3, 0, 0, 0});
    EXPECT_EQ(array.kind(), Error::Kind::out_of_bounds);
    EXPECT_THAT(array.what(), AllOf(HasSubstr("element 3 of 3"), HasSubstr("main")));
    const Error buffer = error_in("put(7u, 1u);\n", {0, 0, 0, 0});
    EXPECT_EQ(buffer.kind(), Error::Kind::out_of_bounds);
    EXPECT_THAT(buffer.what(), HasSubstr("word 7 of the 1"));
    const Error vector = error_in("vec3 v = vec3(1.0); put(0u, v[int(word(0))]);\n", {0xffffffffU, 0, 0, 0});
    EXPECT_EQ(vector.kind(), Error::Kind::out_of_bounds);
}

// An operation tells each scalar of its result, and nothing that lies behind it.
TEST(Program, AnOperationTellsItsResultsAndNoMore) {
    struct Case {
        const char* statements;  // v is (3, 4), m has the columns (3, 4), (3, 4), (5, 6)
        const char* operation;   // how its name begins: newer compilers take ModfStruct for Modf
        std::vector<double> results;
    };
    for (const Case& c : {
             Case{"r = length(v);", "GLSL.std.450 Length", {5}},
             Case{"r = distance(v, vec2(0));", "GLSL.std.450 Distance", {5}},
             Case{"r = dot(v, vec2(1, 2));", "OpDot", {11}},
             Case{"r = determinant(mat2(v, v.yx));", "GLSL.std.450 Determinant", {-7}},
             Case{"r = length(m * vec3(1, 0, 1));", "OpMatrixTimesVector", {8, 10}},
             Case{"r = length(v * m);", "OpVectorTimesMatrix", {25, 25, 39}},
             Case{"mat2 p = m * mat2x3(1); r = p[0].x;", "OpMatrixTimesMatrix", {3, 4, 3, 4}},
             Case{"r = outerProduct(v, v)[1].x;", "OpOuterProduct", {9, 12, 12, 16}},
             Case{"r = inverse(mat2(v, 1, 1))[0].x;", "GLSL.std.450 MatrixInverse", {-1, 4, 1, -3}},
             Case{"r = any(lessThan(v, vec2(1))) ? 0 : 1;", "OpAny", {0}},
             Case{"r = all(lessThan(v, vec2(9))) ? 0 : 1;", "OpAll", {1}},
             Case{"vec2 w; r = length(modf(v + 0.5, w)) + w.y;", "GLSL.std.450 Modf", {0.5, 0.5, 3, 4}},
             Case{"uint k; r = float(uaddCarry(word(0), ~0u, k) + k);", "OpIAddCarry", {0x403fffff, 1}},
         }) {
        const Program program(compiled(test::row_shader(
            4, 1,
            "vec2 v = vec2(number(0), number(1)); mat3x2 m = mat3x2(v, v, 5, 6); float r;\n" +
                std::string(c.statements) + " put(0u, r);\n")));
        Machine<double> machine(program);
        const auto inputs = std::bit_cast<std::array<Word, 4>>(std::array{3.0F, 4.0F, 3.0F, 4.0F});
        machine.bind(0, 0, inputs);
        machine.bind(0, 1, std::span(inputs).first(1));
        machine.set_invocation({0, 0, 0});
        std::vector<double> results;
        machine.run([&](const interpreter::Step<double>& step) {
            if (!step.operation().starts_with(c.operation)) return;
            for (const auto& result : step.results)
                results.push_back(result.is_number() ? result.number() : result.bits());
        });
        EXPECT_EQ(results, c.results) << c.statements;
    }
}

TEST(Program, AnInstructionThatIsNotKnownIsNamed) {
    const std::string text =
        "#version 450\nlayout(local_size_x = 1) in;\nlayout(r32ui, binding = 0) uniform uimage2DMS i;\n"
        "layout(std430, binding = 1) buffer Out { uint o[]; };\n"
        "uint odd(uint x) { return uint(imageSamples(i)) + x; }\nvoid main() { o[0] = odd(o[1]); }\n";
    const Error error = test::error_of([&] { (void)Program(compiled(text)); });
    EXPECT_EQ(error.kind(), Error::Kind::unknown_instruction);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("textureSamples"), HasSubstr("in odd")));
}

TEST(Program, WhatIsNoModuleIsRefused) {
    EXPECT_THROW((void)Program({1, 2, 3}), Error);
    module::Spirv cut = compiled("#version 450\nlayout(local_size_x = 1) in; void main() {}\n");
    EXPECT_THROW((void)Program(cut, {}, "other"), Error);
    cut.resize(cut.size() - 1);
    EXPECT_THROW((void)Program{cut}, Error);
}

TEST(Program, AMissingBufferIsNamed) {
    Machine<float> machine{Program(compiled(test::row_shader(4, 1, "put(0u, word(0));\n")))};
    expect_error<Error>([&] { machine.run(); }, {"binding 0"});
}

}  // namespace gloam::program_test
