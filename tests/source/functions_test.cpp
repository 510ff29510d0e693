// SPDX-License-Identifier: MIT
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::source::functions_test {

using namespace module;

std::vector<Function> functions_of(const std::string& text) {
    return functions({"text", "#version 450\n" + text}, with_fixtures());
}

// What a text is about, the text, and its functions as prototypes().
struct Case {
    const char* name;
    const char* text;
    std::vector<std::string> prototypes;
};
const std::vector<Case> cases{
    {"HaveTheTypesNamesAndDirectionsOfTheText",
     "#include \"types.glsl\"\n",
     {"void fx_nothing()", "bool fx_scalars(bool a, int b, uint c, float d)",
      "ivec3 fx_vectors(bvec2 a, ivec3 b, uvec4 c, vec2 d)",
      "mat4x3 fx_matrices(mat2 a, mat3 b, mat4 c, mat2x4 d)",
      "FxOuter fx_structures(FxInner inner, float scale, out FxInner result, inout uvec2 state, float)",
      "float fx_overload(float x)", "float fx_overload(vec2 x)"}},
    {"PrototypesAreKnownByTheirCalls",
     "#include \"fetch.glsl\"\n",
     {"float fx_square(float x)", "float fx_twice(ivec2 pixel)", "? float fx_fetch_depth(ivec2)",
      "float fx_gather(ivec2 pixel, inout vec3 normal)",
      "? void fx_fetch_pair(ivec2, out float, inout vec3)"}},
    {"PrototypeHasItsOwnTypesNotThoseOfTheArguments",
     "float get(float a, vec2 b);\nfloat f(int i) { return get(i, ivec2(i)); }\n",
     {"float f(int i)", "? float get(float, vec2)"}},
    {"OutputPrototypeHasItsOwnTypes",
     "void get(out int a);\nfloat f() { float x; get(x); return x; }\n",
     {"float f()", "? void get(out int)"}},
    {"PrototypeOverloadsAreSeparate",
     "float get(float a);\nfloat get(vec2 a);\nfloat f() { return get(1.0) + get(vec2(1.0)); }\n",
     {"float f()", "? float get(float)", "? float get(vec2)"}},
    {"DeclaredThenDefinedIsDefined",
     "float later(float a);\nfloat f() { return later(1.0); }\nfloat later(float b) { return b; }\n",
     {"float f()", "float later(float b)"}},
    {"CallsInsideAnyStatementAreSeen",
     "bool a(); int b(); vec4 c(int i); float d(vec4 v);\n"
     "float f() {\n"
     "    for (int i = 0; a(); ++i) {\n"
     "        switch (b()) { case 0: break; default: return d(c(i)); }\n"
     "    }\n"
     "    return 0.0;\n}\n",
     {"float f()", "? bool a()", "? int b()", "? vec4 c(int)", "? float d(vec4)"}},
    {"OtherDeclarationsAreNotTakenForFunctions",
     "const float scale = max(1.0, 2.0), other[2] = float[](1.0, 2.0);\n"
     "layout(std430, binding = 0) buffer Block { float x[]; } block;\n"
     "layout(binding = 1) uniform sampler2D image;\n"
     "struct S { float a; } state;\n"
     "float table[int(max(2.0, 3.0))];\n"
     "float f(float x) { { x += scale; } return x; }\n",
     {"float f(float x)"}},
    {"PrototypesWithArraysAndQualifiersAreMatchedWithTheirDefinitions",
     "float get(const in float[2] a, vec2 b[3]);\n"
     "float[2] pair(int i);\nvoid set(out float[2] a);\n"
     "float get(const in float a[2], vec2[3] b) { return a[0] + b[0].x; }\n"
     "float f() { float a[2] = pair(1); set(a); return get(a, vec2[3](vec2(0), vec2(0), "
     "vec2(0))); }\n",
     {"float get(float[2] a, vec2[3] b)", "float f()", "? float[2] pair(int)", "? void set(out float[2])"}},
    {"MacrosDoNotReachWhatIsAddedToTheText",
     "float get(float a);\nfloat f() { return get(1.0); }\n"
     "#define float int\n#define main other\n#define gloam_result +\n",
     {"float f()", "? float get(float)"}},
    {"BuiltInFunctionsAreNotListed",
     "float f(float x) { memoryBarrier(); return sin(x) + dot(vec2(x), vec2(1.0)); }\n",
     {"float f(float x)"}},
    {"MainIsOneOfThemWhereThereIsOne",
     "float f() { return 1.0; }\nvoid main() { f(); }\n",
     {"float f()", "void main()"}},
    {"PreprocessorHasRun",
     "#define REAL vec2\n#if 0\nfloat off() { return 1.0; }\n#endif\nREAL f(REAL x) { return x; }\n",
     {"vec2 f(vec2 x)"}},
    // The size of such an array is known only when the pipeline is made.
    {"ATableSizedByASpecializationConstantStandsInNoWay",
     "layout(constant_id = 0) const int half_size = 2;\nfloat table[2 * half_size];\n"
     "float f(float x) { return x * table[0]; }\n",
     {"float f(float x)"}},
    {"ATextWithoutFunctionsHasNone", "const float x = 1.0;\n", {}}};

TEST(Functions, AreThoseOfTheText) {
    for (const auto& [name, text, wanted] : cases) EXPECT_EQ(prototypes(functions_of(text)), wanted) << name;
}

// 4^7 scalars.
TEST(Functions, DeeplyNestedStructuresAreOversized) {
    std::string text = "struct S0 { float a; };\n";
    for (int i = 1; i <= 7; ++i) {
        const std::string inner = "S" + std::to_string(i - 1);
        text +=
            "struct S" + std::to_string(i) + " { " + inner + " a; " + inner + " b; " + inner + " c[2]; };\n";
    }
    const auto found = functions_of(text + "float f(S3 s, S7 t) { return s.a.a.a.a; }\n");
    EXPECT_EQ(scalar_count(found[0].parameters[0].type), 64U);
    EXPECT_EQ(found[0].parameters[1].type.scalar, Scalar::oversized);
}

}  // namespace gloam::source::functions_test
