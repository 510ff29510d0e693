// SPDX-License-Identifier: MIT
// Faults of somebody's shader: each kind is named, none is the driver's, and what was not judged is never
// well.
#include "tools/gloam.hpp"

namespace gloam::test::fault_kinds_test {

// A run of the program on a file with this text.
struct Row {
    const char* kind;
    const char* text;
    const char* command;  // {}: the file
    int status;
    std::vector<const char*> says;
    std::vector<const char*> does_not_say = {};
    const char* file = "own.glsl";
};

class FaultKinds : public InFolder {
  protected:
    void expect(const std::vector<Row>& rows) {
        for (const Row& row : rows) {
            SCOPED_TRACE(row.kind);
            const CommandResult result = gloam(row.command, write(row.file, row.text).string());
            const std::string all = result.out + result.err;
            EXPECT_EQ(result.status, row.status) << row.text << all;
            for (const char* said : row.says) EXPECT_THAT(all, HasSubstr(said));
            for (const char* said : row.does_not_say) EXPECT_THAT(all, Not(HasSubstr(said)));
        }
    }
};

TEST_F(FaultKinds, AuditNamesUndefinedIntegers) {
    const char* const audit = "audit {} --inputs 256";
    const char* const shift = "a shift by less than 0 or by more than 31";
    const char* const beyond = "int() of NaN or of a number beyond an int";
    expect({
        {"quotient",
         "int f(int a, int b) { return a / b; }\n",
         audit,
         1,
         {"own.glsl:1 (an integer is divided"}},
        {"unsigned", "uvec2 f(uvec2 a) { return 7u / a; }\n", audit, 1, {"an integer is divided by 0"}},
        {"rest", "ivec2 f(ivec2 a, int b) {\n  return a % b;\n}\n", audit, 1, {"own.glsl:2 (% by 0"}},
        {"unsigned rest", "uint f(uint a, uint b) { return a % b + 1u; }\n", audit, 1, {"% by 0"}},
        {"left", "// k in [0, 32]\nuint f(uint k) { return (1u << k) - 1u; }\n", audit, 1, {shift}},
        {"right", "// k in [30, 40]\nint f(int x, int k) { return x >> k; }\n", audit, 1, {shift}},
        {"negative", "int f(uint x) { return 1 << findLSB(x); }\n", audit, 1, {shift}},
        {"field",
         "// n in [0, 40]\nint f(int x, int n) { return bitfieldExtract(x, n, 8); }\n",
         audit,
         1,
         {"bits outside the 32 of a word"}},
        {"insert",
         "// n in [0, 40]\nuint f(uint x, int n) { return bitfieldInsert(x, 1u, n, 4); }\n",
         audit,
         1,
         {"bits outside the 32 of a word"}},
        {"to uint", "// x in [-3, 3]\nuint f(float x) { return uint(x); }\n", audit, 1, {"uint() of NaN"}},
        {"to int", "// x in [0, 1e12]\nint f(float x) { return int(x) & 7; }\n", audit, 1, {beyond}},
        {"to ivec", "// v in [0, 1]\nivec2 f(vec2 v) { return ivec2(1.0 / v); }\n", audit, 1, {beyond}},
        {"a branch",
         "// x in [-9, 9]\nint f(float x) { if (uint(x) > 4u) return 1; return 2; }\n",
         audit,
         1,
         {"a branch or an index depends on it"}},
        {"a guard", "int f(int a, int b) { return b > 0 ? a / b : 0; }\n", audit, 0, {}, {"divided"}},
        {"small negative",
         "// x in [-0.9, 3]\nuint f(float x) { return uint(x); }\n",
         audit,
         0,
         {},
         {"uint()"}},
    });
}

TEST_F(FaultKinds, AuditNamesWhatWasNeverWritten) {
    const char* const audit = "audit {} --inputs 256";
    expect({
        {"component",
         "float f(float x) { vec3 c;\n c.x = x;\n return dot(c, vec3(1.0)); }\n",
         audit,
         1,
         {"own.glsl:3 (\"c\" was never written)"}},
        {"sum",
         "float f(float x) { float sum; for (int i = 0; i < 3; ++i) sum += x; return sum; }\n",
         audit,
         1,
         {"\"sum\" was never written"}},
        {"branch",
         "float f(float x) { float y; if (x > 0.5) y = x; return y; }\n",
         audit,
         1,
         {"\"y\" was never written"}},
        {"out",
         "void g(out float v) { v = -v; }\nfloat f(float x) { float r; g(r); return r + x; }\n",
         audit,
         1,
         {"\"v\" was never written"}},
        {"integer", "int f(int x) { int n; return n + x; }\n", audit, 1, {"\"n\" was never written"}},
        {"array",
         "// i in [0, 3]\nfloat f(int i) { float a[4]; a[0] = 1.0; return a[i]; }\n",
         audit,
         1,
         {"\"a\" was never written"}},
        {"return",
         "float f(float x) { if (x > 0.5) return 1.0; }\n",
         audit,
         1,
         {"never written or returned"}},
    });
}

TEST_F(FaultKinds, CheckDoesNotJudgeWhatIsUndefined) {
    const char* const check = "check {} --device interpreter --inputs 256";
    expect({
        {"never written",
         "float f(float x) { float r; r = -r; return r + x; }\n",
         check,
         2,
         {"\"r\" was never written", "not judged"},
         {"outside what"}},
        {"one component",
         "vec4 f(float x) { vec4 c; c.a = x; return c * 2.0; }\n",
         check,
         2,
         {"\"c\" was never written"}},
        {"minimum",
         "float f(float x) { float m; return min(m, x); }\n",
         check,
         2,
         {"\"m\" was never written"}},
        {"an out parameter left as it is",
         "bool f(float x, out float t) { if (x < 0.5) return false; t = sqrt(x); return true; }\n",
         check,
         0,
         {},
         {"undefined", "never written"}},
        {"quotient",
         "int f(int a, int b) { return a / b; }\n",
         check,
         0,
         {"the result is undefined for", "an integer is divided by 0"}},
        {"quotient in a range",
         "int f(int a, int b) { return a / b; }\n",
         "check {} --device interpreter --inputs 256 --range a=0:3 --range b=0:3",
         1,
         {"is divided by 0"}},
        {"shift in a range",
         "uint f(uint k) { return 1u << k; }\n",
         "check {} --device interpreter --inputs 256 --range k=0:40",
         1,
         {"a shift by"}},
        {"conversion in a range",
         "uint f(float x) { return uint(x); }\n",
         "check {} --device interpreter --inputs 256 --range x=-3:3",
         1,
         {"uint() of"}},
        {"modf", "float f(float x) { float w; return modf(x, w); }\n", check, 0, {}},
        {"modf of a vector", "vec2 f(vec2 x) { vec2 w; return modf(x, w) + w; }\n", check, 0, {}},
    });
}

TEST_F(FaultKinds, LongLoopsAreNotJudgedInBoundedTime) {
    const char* const check = "check {} --device interpreter --inputs 512";
    const char* const audit = "audit {} --range a=1e8:1e9";
    expect({
        {"uint",
         "float f(uint n) { float s = 0.0; for (uint i = 0u; i < n; ++i) s += 1.0; return s; }\n",
         check,
         0,
         {"it takes too long for"}},
        {"float",
         "float f(float a) { float n = 0.0; for (float t = 0.0; t < a; t += 0.01) n += 1.0; return n; }\n",
         check,
         0,
         {"it takes too long for"}},
        {"while",
         "float f(float a) { while (a > 3.0) a -= 6.0; return a; }\n",
         check,
         0,
         {"it takes too long for"}},
        {"all",
         "float f(float a) { while (a > 3.0) a -= 6.0; return a; }\n",
         "check {} --device interpreter --inputs 64 --range a=1e8:1e9",
         2,
         {"it takes too long"},
         {"hang"}},
        {"audit",
         "float f(float a) { while (a > 3.0) a -= 1.0; return a; }\n",
         audit,
         2,
         {"not audited"},
         {"  well"}},
        {"audit without an end",
         "float f(float a) { for (;;) a = a * 0.5; return a; }\n",
         "audit {}",
         2,
         {"not audited"},
         {"  well"}},
    });
}

// Modules that hold their inputs included: no device gets a long loop.
TEST_F(FaultKinds, LongLoopsAreNotJudgedInAnyVariant) {
    for (const char* text :
         {"float f(float a) { float n = 0.0; for (float t = 1.0; t < a; t += 0.25) n += t; return n; }\n",
          "float f(float v) { do v -= 0.5; while (v > 2.0); return v; }\n",
          "uint f(uint a) { uint n = 0u; while (n < a) n += 3u; return n; }\n"}) {
        for (const char* variant : {"shipped", "optimized", "literals", "specialization"}) {
            const std::string name = std::string("check {} --inputs 256 --variant ") + variant;
            const CommandResult result = gloam(name, write("own.glsl", text).string());
            EXPECT_EQ(result.status, 0) << variant << text << result.out << result.err;
            EXPECT_THAT(result.out, HasSubstr("it takes too long for")) << variant << text;
        }
    }
}

// The bits of a float that is known by bounds only.
TEST_F(FaultKinds, RelaxedFloatsAreComparedByTheirBits) {
    const char* const check = "check {} --device interpreter --variant relaxed --inputs 2048 --range x=0.1:9";
    for (const char* when : {"(b & 0x7fffffffu) > 0x7f800000u", "0x7f800000u <= (b & 0x7fffffffu)",
                             "b >= 0x45000000u", "int(b) < 0"}) {
        const std::string text = "float f(float x) { uint b = floatBitsToUint(x * x); return ";
        const std::string shader = text + when + " ? 0.0 : x; }\n";
        expect({{when, shader.c_str(), check, 0, {"2048 "}, {"any result"}}});
    }
}

TEST_F(FaultKinds, TextsOfFunctionsWithoutParameters) {
    expect(
        {{"infinite", "float f() { return 0.5 / 0.0; }\n", "audit {}", 1, {"      inf"}, {"for :"}},
         {"undefined", "float f() { float x; return x + 1.0; }\n", "audit {}", 1, {"any value"}, {"for :"}},
         {"NaN", "vec2 f() { vec2 v = vec2(0.0); return v / v; }\n", "audit {}", 1, {}, {"for :"}}});
}

TEST_F(FaultKinds, InversesAreNotUndefined) {
    expect({
        {"scaling",
         "// s in [1, 2]\nmat2 f(float s) { return inverse(mat2(s)); }\n",
         "audit {}",
         0,
         {"unspecified", "(inverse)"},
         {"  undefined"}},
        {"normals",
         "// s in [1, 2]\nvec3 f(float s) { return normalize(transpose(inverse(mat3(s))) * vec3(1.0)); }\n",
         "audit {}",
         0,
         {"unspecified"},
         {"  undefined"}},
        {"determinant",
         "// s in [1, 2]\nfloat f(float s) { return determinant(mat4(s)); }\n",
         "audit {}",
         0,
         {"unspecified", "(determinant)"},
         {"  undefined"}},
        {"condition",
         "// e in [0.0001, 0.001]\nfloat f(float e) { return inverse(mat3(1, 2, 3, 4, 5, 6, 7, 8, 9 + "
         "e))[0][0]; }\n",
         "audit {}",
         0,
         {"loses digits"},
         {"  undefined"}},
    });
}

TEST_F(FaultKinds, MacroLinesHideNothing) {
    const std::string third = "float third_of(float x) { return x / 3.0; }\n";
    const std::string line =
        "#define INFO(name)\nINFO(one)\n\nfloat half_of(float x) { return 0.5 * x; }\n" + third;
    const std::string two =
        "#define INFO(a, b)\nINFO(one, 1) INFO(two, 2)\nfloat half_of(float x) { return 0.5 * x; }\n";
    const std::string word = "#define EXPORT\nEXPORT\nfloat half_of(float x) { return 0.5 * x; }\n";
    const std::string made = "#define MAKE(n) float n(float x) { return x; }\nMAKE(same)\n" + third;
    const char* const check = "check {} --device interpreter --inputs 64";
    expect({
        {"check", line.c_str(), check, 0, {"2 checks, 0 failed", "half_of"}},
        {"several", two.c_str(), check, 0, {"half_of"}},
        {"a word", word.c_str(), check, 0, {"half_of"}},
        {"audit", line.c_str(), "audit {} --inputs 64", 0, {"half_of", "third_of"}},
        {"pack", line.c_str(), "pack {}", 0, {"half_of", "third_of"}},
        {"pack of one", two.c_str(), "pack {} --function half_of", 0, {"half_of"}},
        {"made by a macro",
         made.c_str(),
         check,
         0,
         {"line 2: MAKE(same): functions that a macro makes", "third_of"}},
        {"pack of what a macro makes", made.c_str(), "pack {}", 0, {"MAKE(same)", "third_of"}},
    });
}

TEST_F(FaultKinds, NamesAndEndings) {
    const char* const twice = "float twice(float x) { return x * 2.0; }\n";
    const char* const check = "check {} --device interpreter --inputs 64";
    expect({
        {"a variable named as a function",
         "float f(float x) { return nothing(x); }\nfloat g(float x) { float f = x * 2.0; return f; }\n",
         "check {} g --device interpreter --inputs 64",
         0,
         {"1 checks, 0 failed"}},
        {"a second variable",
         "float f(float x) { return nothing(x); }\nfloat g(float x) { float a = x, f = 2.0; return a * f; "
         "}\n",
         "check {} g --device interpreter --inputs 64",
         0,
         {"1 checks, 0 failed"}},
        {".fs", twice, check, 0, {"twice"}, {}, "own.fs"},
        {".vs", twice, check, 0, {"twice"}, {}, "own.vs"},
        {".FRAG", twice, check, 0, {"twice"}, {}, "own.FRAG"},
        {".inc", twice, "audit {} --inputs 64", 0, {"twice"}, {}, "own.inc"},
        {"no ending", twice, check, 0, {"twice"}, {}, "own"},
        {"another ending", twice, check, 0, {"twice"}, {}, "own.shader"},
        {"own tanh",
         "float tanh(float x) { return x; }\nfloat g(float x) { return tanh(x) + 1.0; }\n",
         check,
         0,
         {"2 checks, 0 failed"}},
        {"own transpose",
         "mat2 transpose(mat2 m) { return m; }\nmat2 g(mat2 m) { return transpose(m); }\n",
         check,
         0,
         {"2 checks, 0 failed"}},
        {"own round", "vec3 round(vec3 x) { return floor(x + 0.5); }\n", check, 0, {"1 checks, 0 failed"}},
        {"own mod beside the built-in one",
         "float mod(float x, float y, float z) { return mod(x, y) + z; }\n",
         "audit {} --inputs 64 --range x=1:2 --range y=1:2",
         0,
         {"mod"}},
    });
}

TEST_F(FaultKinds, OldTextsAndOtherLanguages) {
    const char* const check = "check {} --device interpreter --inputs 64";
    expect({
        {"texture2D",
         "uniform sampler2D map;\nvec4 f(vec2 uv) { return texture2D(map, uv); }\n",
         check,
         0,
         {},
         {"left out"}},
        {"textureCube",
         "uniform samplerCube map;\nvec4 f(vec3 d) { return textureCube(map, d); }\n",
         check,
         0,
         {},
         {"left out"}},
        {"texture2DLodEXT",
         "uniform sampler2D map;\nvec4 f(vec2 uv) { return texture2DLodEXT(map, uv, 1.0); }\n",
         check,
         0,
         {},
         {"left out"}},
        {"a variable of GLSL 1.20",
         "vec4 f() { return gl_ModelViewMatrix * gl_Vertex; }\n",
         check,
         2,
         {"gl_ModelViewMatrix", "GLSL 1.20", "own.glsl:1"}},
        {"HLSL", "float3 f(float3 x) { return x * 2.0; }\n", check, 2, {"HLSL", "float3"}},
    });
}

// `git bisect` skips such a build.
TEST_F(FaultKinds, AStepThatCannotRunIsNoFailure) {
    const std::string shader = write("own.glsl", "float twice(float x) { return x * 2.0; }\n").string();
    const std::string no_shell = write("no_shell", "#!/no/such/shell\n").string();
    for (const std::string& program : {std::string("no_such_program"), std::string("/no/such/folder/program"),
                                       std::string("env no_such_program"), no_shell}) {
        const CommandResult result =
            gloam("check {} --inputs 64 --exit-code --compiler {}", shader, program + " {in} {out}");
        EXPECT_EQ(result.status, 125) << program << result.out << result.err;
        EXPECT_THAT(result.out, HasSubstr("0 failed")) << program;
    }
    const CommandResult failed =
        gloam("check {} --inputs 64 --exit-code --compiler {}", shader, "false {in} {out}");
    EXPECT_EQ(failed.status, 1) << "it runs, and fails";
}

TEST_F(FaultKinds, ExplainShowsIntegers) {
    expect({
        {"quotient", "int f(int a, int b) { return a / b; }\n", "explain {} f 7 2", 0, {"OpSDiv", " 3"}},
        {"undefined",
         "int f(int a, int b) { return a / b; }\n",
         "explain {} f 7 0",
         0,
         {"undefined", "an integer is divided by 0"}},
        {"bool", "bool f(uint a) { return a * 2u > 7u; }\n", "explain {} f 4", 0, {"OpIMul", "8", "true"}},
        {"never written",
         "float f(float x) { float y; if (x > 0.5) y = 1.0; return y; }\n",
         "explain {} f 0.25",
         0,
         {"result undefined", "was never written"}},
        {"length", "float f(vec2 v) { return length(v); }\n", "explain {} f 3 4", 0, {"Length"}, {".y"}},
        {"bits", "uint f(uint a) { return (a << 3u) ^ 5u; }\n", "explain {} f 1", 0, {"OpBitwiseXor", "13"}},
    });
}

}  // namespace gloam::test::fault_kinds_test
