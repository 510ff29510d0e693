// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shader/compile.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace functions_test {

using test::fixture;
using test::message_of;
using test::with_fixtures;
using testing::ElementsAre;

std::vector<Function> functions_of(const std::string& text) {
    return functions({"text", "#version 450\n" + text}, with_fixtures());
}

std::vector<std::string> prototypes(const std::vector<Function>& functions) {
    std::vector<std::string> texts;
    for (const Function& function : functions)
        texts.push_back((function.defined ? "" : "? ") + to_glsl(function));
    return texts;
}

TEST(Functions, HaveTheTypesNamesAndDirectionsOfTheText) {
    EXPECT_THAT(
        prototypes(functions_of("#include \"types.glsl\"\n")),
        ElementsAre(
            "void fx_nothing()",                                     //
            "bool fx_scalars(bool a, int b, uint c, float d)",       //
            "ivec3 fx_vectors(bvec2 a, ivec3 b, uvec4 c, vec2 d)",   //
            "mat4x3 fx_matrices(mat2 a, mat3 b, mat4 c, mat2x4 d)",  //
            "FxOuter fx_structures(FxInner inner, float scale, out FxInner result, inout uvec2 state, float)",
            "float fx_overload(float x)",  //
            "float fx_overload(vec2 x)"));
}

TEST(Functions, StructuresHaveTheirMembers) {
    const std::vector<Function> found = functions_of("#include \"types.glsl\"\n");
    const Function& function = found.at(4);
    EXPECT_EQ(to_glsl(function.result), "FxOuter { FxInner inner; mat3x2 map; bvec4 flags; }");
    EXPECT_EQ(to_glsl(function.result.members.at(0).type), "FxInner { vec2 uv; uint seed; }");
    EXPECT_EQ(function.parameters.at(0).type, function.result.members.at(0).type);
    EXPECT_EQ(function.parameters.at(4).name, "");
    EXPECT_TRUE(is_supported(function.result));
}

TEST(Functions, PrototypesAreKnownByTheirCalls) {
    EXPECT_THAT(prototypes(functions_of("#include \"fetch.glsl\"\n")),
                ElementsAre("float fx_square(float x)",                         //
                            "float fx_twice(ivec2 pixel)",                      //
                            "? float fx_fetch_depth(ivec2)",                    //
                            "float fx_gather(ivec2 pixel, inout vec3 normal)",  //
                            "? void fx_fetch_pair(ivec2, out float, inout vec3)"));
}

TEST(Functions, PrototypeHasItsOwnTypesNotThoseOfTheArguments) {
    EXPECT_THAT(prototypes(functions_of(
                    "float get(float a, vec2 b);\nfloat f(int i) { return get(i, ivec2(i)); }\n")),
                ElementsAre("float f(int i)", "? float get(float, vec2)"));
}

TEST(Functions, OutputPrototypeHasItsOwnTypes) {
    EXPECT_THAT(prototypes(functions_of("void get(out int a);\nfloat f() { float x; get(x); return x; }\n")),
                ElementsAre("float f()", "? void get(out int)"));
}

TEST(Functions, PrototypeOverloadsAreSeparate) {
    EXPECT_THAT(
        prototypes(functions_of(
            "float get(float a);\nfloat get(vec2 a);\nfloat f() { return get(1.0) + get(vec2(1.0)); }\n")),
        ElementsAre("float f()", "? float get(float)", "? float get(vec2)"));
}

TEST(Functions, DeclaredThenDefinedIsDefined) {
    EXPECT_THAT(
        prototypes(functions_of(
            "float later(float a);\nfloat f() { return later(1.0); }\nfloat later(float b) { return b; }\n")),
        ElementsAre("float f()", "float later(float b)"));
}

TEST(Functions, CallsInsideAnyStatementAreSeen) {
    EXPECT_THAT(prototypes(functions_of("bool a(); int b(); vec4 c(int i); float d(vec4 v);\n"
                                        "float f() {\n"
                                        "    for (int i = 0; a(); ++i) {\n"
                                        "        switch (b()) { case 0: break; default: return d(c(i)); }\n"
                                        "    }\n"
                                        "    return 0.0;\n}\n")),
                ElementsAre("float f()", "? bool a()", "? int b()", "? vec4 c(int)", "? float d(vec4)"));
}

TEST(Functions, OtherDeclarationsAreNotTakenForFunctions) {
    EXPECT_THAT(prototypes(functions_of("const float scale = max(1.0, 2.0), other[2] = float[](1.0, 2.0);\n"
                                        "layout(std430, binding = 0) buffer Block { float x[]; } block;\n"
                                        "layout(binding = 1) uniform sampler2D image;\n"
                                        "struct S { float a; } state;\n"
                                        "float table[int(max(2.0, 3.0))];\n"
                                        "float f(float x) { { x += scale; } return x; }\n")),
                ElementsAre("float f(float x)"));
}

TEST(Functions, PrototypesWithArraysAndQualifiersAreMatchedWithTheirDefinitions) {
    EXPECT_THAT(prototypes(functions_of(
                    "float get(const in float[2] a, vec2 b[3]);\n"
                    "float[2] pair(int i);\nvoid set(out float[2] a);\n"
                    "float get(const in float a[2], vec2[3] b) { return a[0] + b[0].x; }\n"
                    "float f() { float a[2] = pair(1); set(a); return get(a, vec2[3](vec2(0), vec2(0), "
                    "vec2(0))); }\n")),
                ElementsAre("float get(float[2] a, vec2[3] b)", "float f()", "? float[2] pair(int)",
                            "? void set(out float[2])"));
}

TEST(Functions, MacrosDoNotReachWhatIsAddedToTheText) {
    EXPECT_THAT(prototypes(functions_of("float get(float a);\nfloat f() { return get(1.0); }\n"
                                        "#define float int\n#define main other\n#define gloam_result +\n")),
                ElementsAre("float f()", "? float get(float)"));
}

TEST(Functions, BuiltInFunctionsAreNotListed) {
    EXPECT_THAT(prototypes(functions_of(
                    "float f(float x) { memoryBarrier(); return sin(x) + dot(vec2(x), vec2(1.0)); }\n")),
                ElementsAre("float f(float x)"));
}

TEST(Functions, MainIsOneOfThemWhereThereIsOne) {
    EXPECT_THAT(prototypes(functions_of("float f() { return 1.0; }\nvoid main() { f(); }\n")),
                ElementsAre("float f()", "void main()"));
}

TEST(Functions, OtherTypesAreListedAsUnsupported) {
    const auto found = functions_of(
        "struct S { float a[3]; dvec2 b; };\n"
        "float f(float[4] a, float b[2][3], sampler2D c, double d, S s) { return a[0]; }\n"
        "float[2] g(vec3 v[2]) { return float[2](1.0, 2.0); }\n");
    EXPECT_THAT(prototypes(found),
                ElementsAre("float f(float[4] a, float[2][3] b, sampler2D c, double d, S s)",
                            "float[2] g(vec3[2] v)"));
    for (const Parameter& parameter : found[0].parameters)
        EXPECT_FALSE(is_supported(parameter.type)) << parameter.name;
    EXPECT_EQ(to_glsl(found[0].parameters[4].type), "S { float[3] a; dvec2 b; }");
    EXPECT_EQ(found[1].result.scalar, Scalar::unsupported);
}

TEST(Functions, ATextWithoutFunctionsHasNone) {
    EXPECT_TRUE(functions_of("const float x = 1.0;\n").empty());
}

TEST(Functions, PreprocessorHasRun) {
    EXPECT_THAT(
        prototypes(functions_of(
            "#define REAL vec2\n#if 0\nfloat off() { return 1.0; }\n#endif\nREAL f(REAL x) { return x; }\n")),
        ElementsAre("vec2 f(vec2 x)"));
}

TEST(Functions, ErrorsNameTheirPlace) {
    EXPECT_EQ(
        message_of<CompileError>([] { static_cast<void>(functions_of("#include \"broken/outer.glsl\"\n")); }),
        fixture("broken/inner.glsl").string() + ":9: 'not_declared' : undeclared identifier");
    EXPECT_THROW(static_cast<void>(functions({"text", "float f() { return 1.0; }\n"}, {})), CompileError);
}

}  // namespace functions_test
}  // namespace gloam::shader
