// SPDX-License-Identifier: MIT
#include "shader/decorate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "disassembly.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace decorate_test {

using test::Disassembly;
using test::kernel;
using test::message_of;

constexpr std::array arithmetic{"OpFNegate",
                                "OpFAdd",
                                "OpFSub",
                                "OpFMul",
                                "OpFDiv",
                                "OpFMod",
                                "OpVectorTimesScalar",
                                "OpMatrixTimesScalar",
                                "OpVectorTimesMatrix",
                                "OpMatrixTimesVector",
                                "OpMatrixTimesMatrix",
                                "OpOuterProduct",
                                "OpDot"};

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
    for (const char* opcode : arithmetic) ids.merge(module.results(opcode));
    return ids;
}

std::multiset<std::string> each_once(const std::set<std::string>& ids) {
    return {ids.begin(), ids.end()};
}

TEST(NoContraction, IsOnEveryFloatArithmeticResultAndNothingElse) {
    const Spirv plain = compile(everything, {});
    for (const char* opcode : arithmetic)
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

TEST(RelaxedPrecision, TheWordsInMemoryStayWords) {
    const Disassembly module(with_relaxed_precision(compile(everything, {})));
    const auto relaxed = module.decorated("RelaxedPrecision");
    for (const std::string& id : module.of_type("%uint")) EXPECT_EQ(relaxed.count(id), 0u) << id;
    for (const std::string& id : module.results("OpVariable")) EXPECT_EQ(relaxed.count(id), 0u) << id;
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

TEST(Decorate, RefusesWhatIsNoModule) {
    Spirv cut = compile(integers, {});
    cut.resize(cut.size() - 3);
    Spirv stuck = compile(integers, {});
    stuck[5] &= 0xffffu;  // an instruction of no words
    for (const Spirv& bad : {Spirv{}, Spirv{1, 2, 3, 4, 5, 6}, cut, stuck}) {
        const auto no_module = testing::HasSubstr("no SPIR-V module");
        EXPECT_THAT(message_of<std::runtime_error>([&] { (void)with_no_contraction(bad); }), no_module);
        EXPECT_THAT(message_of<std::runtime_error>([&] { (void)with_relaxed_precision(bad); }), no_module);
    }
}

}  // namespace decorate_test
}  // namespace gloam::shader
