// SPDX-License-Identifier: MIT
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::shader::functions_test {

std::vector<Function> functions_of(const std::string& text) {
    return functions({"text", "#version 450\n" + text}, with_fixtures());
}

std::vector<std::string> prototypes(const std::vector<Function>& functions) {
    std::vector<std::string> texts;
    for (const Function& function : functions)
        texts.push_back((function.defined ? "" : "? ") + to_glsl(function));
    return texts;
}

// What a text is about, the text, and its functions; "? " stands before those without a body.
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
};

class FunctionsOf : public testing::TestWithParam<Case> {};

TEST_P(FunctionsOf, AText) {
    EXPECT_EQ(prototypes(functions_of(GetParam().text)), GetParam().prototypes);
}

INSTANTIATE_TEST_SUITE_P(Texts, FunctionsOf, testing::ValuesIn(cases),
                         [](const auto& info) { return info.param.name; });

Type vector(Scalar scalar, int rows) {
    return {.scalar = scalar, .rows = rows};
}

Type array_of(Type element, std::vector<std::uint32_t> sizes) {
    element.sizes = std::move(sizes);
    return element;
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

TEST(Functions, OtherTypesAreListedAsUnsupported) {
    const auto found = functions_of(
        "struct S { float a[3]; dvec2 b; };\n"
        "float f(sampler2DMS a, double b[2][3], S s, sampler2D d[2]) { return 1.0; }\n");
    EXPECT_THAT(prototypes(found),
                ElementsAre("float f(sampler2DMS a, double[2][3] b, S s, sampler2D[2] d)"));
    for (const std::size_t sampler : {0, 3}) EXPECT_FALSE(is_supported(found[0].parameters[sampler].type));
    EXPECT_EQ(to_glsl(found[0].parameters[2].type), "S { float[3] a; double b; }");
}

TEST(Functions, HalvesHaveTheirTypes) {
    const std::string text = "float16_t f(f16vec3 a, f16mat2 b, float16_t[2] c)";
    const auto found = functions_of("#extension GL_EXT_shader_explicit_arithmetic_types : require\n" + text +
                                    " { return c[0]; }\n");
    EXPECT_THAT(prototypes(found), ElementsAre(text));
    EXPECT_TRUE(is_supported(found[0].result));
    EXPECT_EQ(found[0].parameters[0].type.scalar, Scalar::float16_);
    EXPECT_EQ(found[0].other_number, "");
}

// By its parameters, its result, what it calculates with and what it calls.
TEST(Functions, NumbersThatAreNotJudgedAreNamed) {
    const auto found = functions_of(
        "#extension GL_EXT_shader_explicit_arithmetic_types : require\n"
        "struct S { float a[3]; u8vec2 b; };\n"
        "float f(dmat2x3 a) { return 1.0; }\nint64_t g() { return 1l; }\nS h(S s) { return s; }\n"
        "float i(float x) { return float(double(x)); }\nfloat j(float x) { return i(x); }\n"
        "float k(float x) { return x; }\n");
    std::vector<std::string> numbers;
    for (const Function& function : found) numbers.push_back(function.other_number);
    EXPECT_THAT(numbers, ElementsAre("double", "int64_t", "uint8_t", "double", "double", ""));
    EXPECT_FALSE(is_supported(found[0].parameters[0].type));
    EXPECT_FALSE(is_supported(found[2].result));
}

// The size of such an array is known only when the pipeline is made.
TEST(Functions, ATableSizedByASpecializationConstantStandsInNoWay) {
    const auto found = functions_of(
        "layout(constant_id = 0) const int half_size = 2;\nfloat table[2 * half_size];\n"
        "float f(float x) { return x * table[0]; }\n");
    EXPECT_THAT(prototypes(found), ElementsAre("float f(float x)"));
}

TEST(Functions, SamplersHaveNoScalars) {
    const auto found = functions_of(
        "#define TEX isampler2D\nfloat f(highp TEX a, sampler3D b, sampler2DArray c) { return 1.0; }\n");
    EXPECT_THAT(prototypes(found), ElementsAre("float f(isampler2D a, sampler3D b, sampler2DArray c)"));
    for (const Parameter& parameter : found[0].parameters) {
        EXPECT_EQ(parameter.type.scalar, Scalar::sampler);
        EXPECT_TRUE(is_supported(parameter.type));
        EXPECT_EQ(scalar_count(parameter.type), 0U);
    }
    EXPECT_TRUE(is_sampler_type("usamplerCubeArray"));
    EXPECT_TRUE(is_sampler_type("sampler2DShadow"));
    for (const char* name :
         {"isampler2DShadow", "samplerCubeShadow", "sampler2DArrayShadow", "sampler1D", "sampler2DMS"})
        EXPECT_FALSE(is_sampler_type(name)) << name;
}

TEST(Functions, ArraysHaveTheirSizes) {
    const auto found = functions_of(
        "struct S { float a[3]; };\n"
        "float[2] f(float[4] a, float b[2][3], S s[5]) { return float[2](1.0, 2.0); }\n");
    EXPECT_THAT(prototypes(found), ElementsAre("float[2] f(float[4] a, float[2][3] b, S[5] s)"));
    EXPECT_EQ(found[0].result, array_of(vector(Scalar::float_, 1), {2}));
    EXPECT_EQ(found[0].parameters[1].type, array_of(vector(Scalar::float_, 1), {2, 3}));
    EXPECT_EQ(scalar_count(found[0].parameters[2].type), 15U);
}

// However large a value is, its description is small.
TEST(Functions, TypesOfTooManyScalarsAreOversized) {
    const auto found = functions_of(
        "struct A { float a[4000]; };\nstruct B { A a, b; };\nstruct C { B b[1000]; };\n"
        "float f(A a, B b, C c, float d[65536][65536]) { return 1.0; }\n");
    EXPECT_TRUE(is_supported(found[0].parameters[0].type));
    const std::vector<std::string> names{"A", "B", "C", "float[65536][65536]"};
    for (std::size_t i = 1; i < names.size(); ++i) {
        const Type& type = found[0].parameters[i].type;
        EXPECT_FALSE(is_supported(type)) << names[i];
        EXPECT_EQ(name_of(type), names[i]);
    }
    EXPECT_EQ(found[0].parameters[1].type.scalar, Scalar::oversized);
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
    EXPECT_TRUE(is_supported(found[0].parameters[0].type));
    EXPECT_EQ(found[0].parameters[1].type.scalar, Scalar::oversized);
}

TEST(Functions, ATextWithoutFunctionsHasNone) {
    EXPECT_TRUE(functions_of("const float x = 1.0;\n").empty());
}

TEST(Functions, ErrorsNameTheirPlace) {
    EXPECT_EQ(
        message_of<CompileError>([] { static_cast<void>(functions_of("#include \"broken/outer.glsl\"\n")); }),
        fixture("broken/inner.glsl").string() + ":9: 'not_declared' : undeclared identifier");
    EXPECT_THROW(static_cast<void>(functions({"text", "float f() { return 1.0; }\n"}, {})), CompileError);
}

Type matrix(int columns, int rows) {
    return {.scalar = Scalar::float_, .columns = columns, .rows = rows};
}

Type structure(std::string name, std::vector<Member> members) {
    return {.scalar = Scalar::structure, .members = std::move(members), .name = std::move(name)};
}

const Type rows = array_of(vector(Scalar::float_, 2), {2, 3});
const Type image{.scalar = Scalar::unsupported, .name = "sampler2D"};
const Type lights = array_of(structure("Light", {{"at", rows}}), {4});

TEST(Type, ReadsAsGlsl) {
    const Type inner = structure("Inner", {{"x", vector(Scalar::float_, 1)}});
    const std::pair<Type, const char*> cases[] = {
        {{}, "void"},
        {vector(Scalar::bool_, 1), "bool"},
        {vector(Scalar::float_, 3), "vec3"},
        {vector(Scalar::bool_, 2), "bvec2"},
        {vector(Scalar::int_, 4), "ivec4"},
        {vector(Scalar::uint_, 2), "uvec2"},
        {matrix(3, 3), "mat3"},
        {matrix(4, 3), "mat4x3"},
        {matrix(2, 4), "mat2x4"},
        {structure("Outer", {{"a", inner}, {"m", matrix(2, 3)}}), "Outer { Inner a; mat2x3 m; }"},
        {rows, "vec2[2][3]"},
        {lights, "Light { vec2[2][3] at; }[4]"},
        {array_of(image, {2}), "sampler2D[2]"}};
    for (const auto& [type, text] : cases) EXPECT_EQ(to_glsl(type), text);
    EXPECT_EQ(name_of(lights), "Light[4]");
    const Function function{"shade",
                            inner,
                            {{"uv", vector(Scalar::float_, 2), Direction::in},
                             {"depth", vector(Scalar::float_, 1), Direction::out},
                             {"", vector(Scalar::uint_, 1), Direction::inout}},
                            true};
    EXPECT_EQ(to_glsl(function), "Inner shade(vec2 uv, out float depth, inout uint)");
    EXPECT_EQ(to_glsl(Function{"f", {}, {}, false}), "void f()");
}

TEST(Type, EqualityIsOfLayout) {
    const Type pair = structure("A", {{"x", vector(Scalar::float_, 2)}});
    EXPECT_EQ(pair, structure("B", {{"y", vector(Scalar::float_, 2)}}));
    const Type different[] = {
        pair,
        structure("A", {{"x", vector(Scalar::int_, 2)}}),
        structure("A", {{"x", vector(Scalar::float_, 2)}, {"z", vector(Scalar::float_, 2)}}),
        matrix(3, 4),
        matrix(4, 3),
        vector(Scalar::float_, 2),
        vector(Scalar::float_, 3),
        rows,
        array_of(vector(Scalar::float_, 2), {3, 2}),
        array_of(vector(Scalar::int_, 2), {2, 3}),
        image,
        {.scalar = Scalar::unsupported, .name = "sampler3D"}};
    for (const Type& a : different)
        for (const Type& b : different) EXPECT_EQ(a == b, &a == &b) << to_glsl(a) << " " << to_glsl(b);
}

TEST(Type, ArraysHaveElementsAndScalars) {
    EXPECT_EQ(element_of(rows), array_of(vector(Scalar::float_, 2), {3}));
    EXPECT_EQ(scalar_count(rows), 12U);
    EXPECT_EQ(scalar_count(array_of(lights, {65536, 65536})), most_scalars + 1);
}

TEST(Type, IsSupportedWhereItsMembersAre) {
    EXPECT_FALSE(is_supported(image));
    EXPECT_FALSE(is_supported(structure("S", {{"inner", structure("T", {{"a", image}})}})));
    EXPECT_TRUE(is_supported(structure("S", {{"v", vector(Scalar::float_, 3)}})));
    EXPECT_TRUE(is_supported(Type{}));
}

}  // namespace gloam::shader::functions_test
