// SPDX-License-Identifier: MIT
// Faults of somebody's shader: each kind is named, none is the driver's, and what was not judged is never
// well.
#include "tools/gloam.hpp"

namespace gloam::test::fault_kinds_test {

// The text of a file, and what a run of the program on it says.
struct Row {
    std::string text;
    std::vector<std::string> says = {};
    std::vector<std::string> does_not_say = {};
};

class FaultKinds : public InFolder {
  protected:
    // Of each row a run that ends with this status. line: {} is the file.
    void expect(const std::string& line, int status, const std::vector<Row>& rows,
                const std::string& name = "own.glsl") {
        for (const Row& row : rows) {
            const CommandResult result = gloam(line, write(name, row.text + "\n"));
            const std::string all = result.out + result.err;
            EXPECT_EQ(result.status, status) << row.text << '\n' << all;
            for (const std::string& said : row.says) EXPECT_THAT(all, HasSubstr(said)) << row.text;
            for (const std::string& said : row.does_not_say)
                EXPECT_THAT(all, Not(HasSubstr(said))) << row.text;
        }
    }
};

const std::string audit = "audit {} --inputs 256";
const std::string check = "check {} --device interpreter --inputs 256";
const std::string check_few = "check {} --device interpreter --inputs 64";

TEST_F(FaultKinds, AuditNamesUndefinedIntegers) {
    const std::string shift = "a shift by less than 0 or by more than 31";
    const std::string outside = "bits outside the 32 of a word";
    const std::string beyond = "int() of NaN or of a number beyond an int";
    const std::string in_n = "// n in [0, 40]\n";
    expect(audit, 1,
           {{"int f(int a, int b) { return a / b; }", {"own.glsl:1 (an integer is divided"}},
            {"uvec2 f(uvec2 a) { return 7u / a; }", {"an integer is divided by 0"}},
            {"ivec2 f(ivec2 a, int b) {\n  return a % b;\n}", {"own.glsl:2 (% by 0"}},
            {"uint f(uint a, uint b) { return a % b + 1u; }", {"% by 0"}},
            {"// k in [0, 32]\nuint f(uint k) { return (1u << k) - 1u; }", {shift}},
            {"// k in [30, 40]\nint f(int x, int k) { return x >> k; }", {shift}},
            {"int f(uint x) { return 1 << findLSB(x); }", {shift}},
            {in_n + "int f(int x, int n) { return bitfieldExtract(x, n, 8); }", {outside}},
            {in_n + "uint f(uint x, int n) { return bitfieldInsert(x, 1u, n, 4); }", {outside}},
            {"// x in [-3, 3]\nuint f(float x) { return uint(x); }", {"uint() of NaN"}},
            {"// x in [0, 1e12]\nint f(float x) { return int(x) & 7; }", {beyond}},
            {"// v in [0, 1]\nivec2 f(vec2 v) { return ivec2(1.0 / v); }", {beyond}},
            {"// x in [-9, 9]\nint f(float x) { if (uint(x) > 4u) return 1; return 2; }",
             {"a branch or an index depends on it"}}});
    expect(audit, 0,
           {{"int f(int a, int b) { return b > 0 ? a / b : 0; }", {}, {"divided"}},
            {"// x in [-0.9, 3]\nuint f(float x) { return uint(x); }", {}, {"uint()"}}});
}

TEST_F(FaultKinds, AuditNamesWhatWasNeverWritten) {
    expect(audit, 1,
           {{"float f(float x) { vec3 c;\n c.x = x;\n return dot(c, vec3(1.0)); }",
             {"own.glsl:3 (\"c\" was never written)"}},
            {"float f(float x) { float sum; for (int i = 0; i < 3; ++i) sum += x; return sum; }",
             {"\"sum\" was never written"}},
            {"float f(float x) { float y; if (x > 0.5) y = x; return y; }", {"\"y\" was never written"}},
            {"void g(out float v) { v = -v; }\nfloat f(float x) { float r; g(r); return r + x; }",
             {"\"v\" was never written"}},
            {"int f(int x) { int n; return n + x; }", {"\"n\" was never written"}},
            {"// i in [0, 3]\nfloat f(int i) { float a[4]; a[0] = 1.0; return a[i]; }",
             {"\"a\" was never written"}},
            {"float f(float x) { if (x > 0.5) return 1.0; }", {"never written or returned"}}});
}

TEST_F(FaultKinds, CheckDoesNotJudgeWhatIsUndefined) {
    expect(check, 2,
           {{"float f(float x) { float r; r = -r; return r + x; }",
             {"\"r\" was never written", "not judged"},
             {"outside what"}},
            {"vec4 f(float x) { vec4 c; c.a = x; return c * 2.0; }", {"\"c\" was never written"}},
            {"float f(float x) { float m; return min(m, x); }", {"\"m\" was never written"}}});
    const std::string quotient = "int f(int a, int b) { return a / b; }";
    expect(check, 0,
           {{"bool f(float x, out float t) { if (x < 0.5) return false; t = sqrt(x); return true; }",
             {},
             {"undefined", "never written"}},
            {quotient, {"the result is undefined for", "an integer is divided by 0"}},
            {"float f(float x) { float w; return modf(x, w); }"},
            {"vec2 f(vec2 x) { vec2 w; return modf(x, w) + w; }"}});
    expect(check + " --range a=0:3 --range b=0:3", 1, {{quotient, {"is divided by 0"}}});
    expect(check + " --range k=0:40", 1, {{"uint f(uint k) { return 1u << k; }", {"a shift by"}}});
    expect(check + " --range x=-3:3", 1, {{"uint f(float x) { return uint(x); }", {"uint() of"}}});
}

TEST_F(FaultKinds, LongLoopsAreNotJudgedInBoundedTime) {
    const std::string down = "float f(float a) { while (a > 3.0) a -= 6.0; return a; }";
    const std::string too_long = "it takes too long for";
    expect(
        "check {} --device interpreter --inputs 512", 0,
        {{"float f(uint n) { float s = 0.0; for (uint i = 0u; i < n; ++i) s += 1.0; return s; }", {too_long}},
         {"float f(float a) { float n = 0.0; for (float t = 0.0; t < a; t += 0.01) n += 1.0; return n; }",
          {too_long}},
         {down, {too_long}}});
    expect(check_few + " --range a=1e8:1e9", 2, {{down, {"it takes too long"}, {"hang"}}});
    expect("audit {} --range a=1e8:1e9", 2,
           {{"float f(float a) { while (a > 3.0) a -= 1.0; return a; }", {"not audited"}, {"  well"}}});
    expect("audit {}", 2,
           {{"float f(float a) { for (;;) a = a * 0.5; return a; }", {"not audited"}, {"  well"}}});
}

// Modules that hold their inputs included: no device gets a long loop.
TEST_F(FaultKinds, LongLoopsAreNotJudgedInAnyVariant) {
    for (const std::string variant : {"shipped", "optimized", "literals", "specialization"})
        expect(
            "check {} --inputs 256 --variant " + variant, 0,
            {{"float f(float a) { float n = 0.0; for (float t = 1.0; t < a; t += 0.25) n += t; return n; }",
              {"it takes too long for"}},
             {"float f(float v) { do v -= 0.5; while (v > 2.0); return v; }", {"it takes too long for"}},
             {"uint f(uint a) { uint n = 0u; while (n < a) n += 3u; return n; }",
              {"it takes too long for"}}});
}

// The bits of a float that is known by bounds only.
TEST_F(FaultKinds, RelaxedFloatsAreComparedByTheirBits) {
    for (const std::string when : {"(b & 0x7fffffffu) > 0x7f800000u", "0x7f800000u <= (b & 0x7fffffffu)",
                                   "b >= 0x45000000u", "int(b) < 0"})
        expect("check {} --device interpreter --variant relaxed --inputs 2048 --range x=0.1:9", 0,
               {{"float f(float x) { uint b = floatBitsToUint(x * x); return " + when + " ? 0.0 : x; }",
                 {"2048 "},
                 {"any result"}}});
}

TEST_F(FaultKinds, TextsOfFunctionsWithoutParameters) {
    expect("audit {}", 1,
           {{"float f() { return 0.5 / 0.0; }", {"      inf"}, {"for :"}},
            {"float f() { float x; return x + 1.0; }", {"any value"}, {"for :"}},
            {"vec2 f() { vec2 v = vec2(0.0); return v / v; }", {}, {"for :"}}});
}

TEST_F(FaultKinds, InversesAreNotUndefined) {
    const std::string scale = "// s in [1, 2]\n";
    expect("audit {}", 0,
           {{scale + "mat2 f(float s) { return inverse(mat2(s)); }",
             {"unspecified", "(inverse)"},
             {"  undefined"}},
            {scale + "vec3 f(float s) { return normalize(transpose(inverse(mat3(s))) * vec3(1.0)); }",
             {"unspecified"},
             {"  undefined"}},
            {scale + "float f(float s) { return determinant(mat4(s)); }",
             {"unspecified", "(determinant)"},
             {"  undefined"}},
            {"// e in [0.0001, 0.001]\n"
             "float f(float e) { return inverse(mat3(1, 2, 3, 4, 5, 6, 7, 8, 9 + e))[0][0]; }",
             {"loses digits"},
             {"  undefined"}}});
}

TEST_F(FaultKinds, MacroLinesHideNothing) {
    const std::string third = "float third_of(float x) { return x / 3.0; }";
    const std::string half = "float half_of(float x) { return 0.5 * x; }\n";
    const std::string line = "#define INFO(name)\nINFO(one)\n\n" + half + third;
    const std::string two = "#define INFO(a, b)\nINFO(one, 1) INFO(two, 2)\n" + half;
    const std::string made = "#define MAKE(n) float n(float x) { return x; }\nMAKE(same)\n" + third;
    expect(check_few, 0,
           {{line, {"2 checks, 0 failed", "half_of"}},
            {two, {"half_of"}},
            {"#define EXPORT\nEXPORT\n" + half, {"half_of"}},
            {made, {"line 2: MAKE(same): functions that a macro makes", "third_of"}}});
    expect("audit {} --inputs 64", 0, {{line, {"half_of", "third_of"}}});
    expect("pack {}", 0, {{line, {"half_of", "third_of"}}, {made, {"MAKE(same)", "third_of"}}});
    expect("pack {} --function half_of", 0, {{two, {"half_of"}}});
}

TEST_F(FaultKinds, FilesOfAnyEndingAreRead) {
    const Row twice{"float twice(float x) { return x * 2.0; }", {"twice"}};
    for (const char* name : {"own.fs", "own.vs", "own.FRAG", "own", "own.shader"})
        expect(check_few, 0, {twice}, name);
    expect("audit {} --inputs 64", 0, {twice}, "own.inc");
}

TEST_F(FaultKinds, NamesOfVariablesAndBuiltInsMayBeFunctions) {
    const std::string bad = "float f(float x) { return nothing(x); }\n";
    expect("check {} g --device interpreter --inputs 64", 0,
           {{bad + "float g(float x) { float f = x * 2.0; return f; }", {"1 checks, 0 failed"}},
            {bad + "float g(float x) { float a = x, f = 2.0; return a * f; }", {"1 checks, 0 failed"}}});
    expect(check_few, 0,
           {{"float tanh(float x) { return x; }\nfloat g(float x) { return tanh(x) + 1.0; }",
             {"2 checks, 0 failed"}},
            {"mat2 transpose(mat2 m) { return m; }\nmat2 g(mat2 m) { return transpose(m); }",
             {"2 checks, 0 failed"}},
            {"vec3 round(vec3 x) { return floor(x + 0.5); }", {"1 checks, 0 failed"}}});
    expect("audit {} --inputs 64 --range x=1:2 --range y=1:2", 0,
           {{"float mod(float x, float y, float z) { return mod(x, y) + z; }", {"mod"}}});
}

TEST_F(FaultKinds, OldTextsAndOtherLanguages) {
    expect(check_few, 0,
           {{"uniform sampler2D map;\nvec4 f(vec2 uv) { return texture2D(map, uv); }", {}, {"left out"}},
            {"uniform samplerCube map;\nvec4 f(vec3 d) { return textureCube(map, d); }", {}, {"left out"}},
            {"uniform sampler2D map;\nvec4 f(vec2 uv) { return texture2DLodEXT(map, uv, 1.0); }",
             {},
             {"left out"}}});
    expect(check_few, 2,
           {{"vec4 f() { return gl_ModelViewMatrix * gl_Vertex; }",
             {"gl_ModelViewMatrix", "GLSL 1.20", "own.glsl:1"}},
            {"float3 f(float3 x) { return x * 2.0; }", {"HLSL", "float3"}}});
}

// `git bisect` skips such a build.
TEST_F(FaultKinds, AStepThatCannotRunIsNoFailure) {
    const auto status_of = [&](const std::string& program) {
        return gloam("check {} --inputs 64 --exit-code --compiler {}",
                     write("own.glsl", "float twice(float x) { return x * 2.0; }\n"),
                     program + " {in} {out}");
    };
    const std::string no_shell = write("no_shell", "#!/no/such/shell\n").string();
    for (const std::string& program : {std::string("no_such_program"), std::string("/no/such/folder/program"),
                                       std::string("env no_such_program"), no_shell}) {
        const CommandResult result = status_of(program);
        EXPECT_EQ(result.status, 125) << program << result.out << result.err;
        EXPECT_THAT(result.out, HasSubstr("0 failed")) << program;
    }
    EXPECT_EQ(status_of("false").status, 1) << "it runs, and fails";
}

TEST_F(FaultKinds, ExplainShowsIntegers) {
    const std::string quotient = "int f(int a, int b) { return a / b; }";
    expect("explain {} f 7 2", 0, {{quotient, {"OpSDiv", " 3"}}});
    expect("explain {} f 7 0", 0, {{quotient, {"undefined", "an integer is divided by 0"}}});
    expect("explain {} f 4", 0, {{"bool f(uint a) { return a * 2u > 7u; }", {"OpIMul", "8", "true"}}});
    expect("explain {} f 0.25", 0,
           {{"float f(float x) { float y; if (x > 0.5) y = 1.0; return y; }",
             {"result undefined", "was never written"}}});
    expect("explain {} f 3 4", 0, {{"float f(vec2 v) { return length(v); }", {"Length"}, {".y"}}});
    expect("explain {} f 1", 0, {{"uint f(uint a) { return (a << 3u) ^ 5u; }", {"OpBitwiseXor", "13"}}});
}

}  // namespace gloam::test::fault_kinds_test
