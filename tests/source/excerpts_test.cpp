// SPDX-License-Identifier: MIT
#include "module/include.hpp"
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::source::excerpts_test {

using namespace module;

// Functions of a text from elsewhere, each as a text that a compute shader can contain.

Excerpts excerpts_of(const std::string& text) {
    return module::excerpts({"own.frag", text}, {});
}

// The compiled function, in the order of definitions.
std::vector<std::string> compiled(const Excerpt& excerpt) {
    std::vector<std::string> texts;
    for (const Function& function : functions({"own.frag", "#version 450\n" + excerpt.text}, {}))
        texts.push_back(to_glsl(function));
    return texts;
}

TEST(Excerpts, NameTheDefinitionsOfTheFileItself) {
    const TemporaryDirectory folder;
    (void)folder.write("other.glsl", "float f(float x) { return x; }\nfloat g(float x) { return x; }\n");
    const Excerpts all = module::excerpts({"own.glsl",
                                           "#include \"other.glsl\"\n"
                                           "float f(const in vec2 x, out float y) { y = 1.0; return x.x; }\n"
                                           "float f(float x[2], sampler2D) { return f(x[0]); }\n"},
                                          {folder.path()});
    EXPECT_EQ(all.version, "");
    ASSERT_EQ(all.functions.size(), 1U);
    EXPECT_THAT(all.functions[0].definitions, ElementsAre("", "f(vec2, float)", "f(float[2], sampler2D)"));
    EXPECT_THAT(compiled(all.functions[0]), ElementsAre("float f(float x)", "float f(vec2 x, out float y)",
                                                        "float f(float[2] x, sampler2D)"));
}

TEST(Excerpts, ErrorsNameTheLinesOfTheFile) {
    const Excerpts all = excerpts_of(
        "/* a comment\n"
        "   of two lines */ float f(float x) {\n"
        "#if 0\n"
        "    x = 1.0;\n"
        "#endif\n"
        "    float y = \\\n"
        "        2.0;  /* one\n"
        "    more */ float z = 3.0;\n"
        "    return x + missing;\n"
        "}\n");
    ASSERT_EQ(all.functions.size(), 1U);
    EXPECT_EQ(message_of<CompileError>([&] { static_cast<void>(compiled(all.functions[0])); }),
              "own.frag:9: 'missing' : undeclared identifier");
}

// Other forms: tests/subject/fixtures/uniforms.glsl.
TEST(Excerpts, BlocksMayHaveDirectivesAndUniformsStructures) {
    const Excerpts all = excerpts_of(
        "layout(push_constant) uniform Pushed {\n#define COUNT 3\n    float c[COUNT]; } pushed;\n"
        "uniform struct S { float x; } s;\nfloat f() { return pushed.c[2] + s.x; }\n");
    EXPECT_THAT(compiled(all.functions.at(0)), ElementsAre("float f()"));
    EXPECT_THAT(all.functions[0].globals,
                ElementsAre(Pair("pushed", Access::uniform), Pair("s", Access::uniform)));
}

TEST(Excerpts, AComputeShaderHasNoDerivativesToSelectALevelBy) {
    const auto needs = [](const std::string& file) {
        const std::string text = "uniform sampler2D image;\nvec4 f(vec2 uv) { return texture(image, uv); }\n";
        return module::excerpts({file, text}, {}).functions.at(0).needs;
    };
    EXPECT_EQ(needs("own.glsl"), Needs::quad);
    EXPECT_EQ(needs("own.comp"), Needs::nobody);
}

TEST(Excerpts, ATextWithoutFunctionsHasNone) {
    EXPECT_THAT(excerpts_of("#version 450\nconst float x = 1.0;\nvoid main() { }\n").functions, IsEmpty());
    const std::string function = "float f(float x) { return x; }\n";
    for (const std::string& text :
         {function + "uniform struct S { float a; }", "] uniform float y;" + function})
        EXPECT_NO_THROW((void)excerpts_of(text)) << text;
    EXPECT_NO_THROW((void)module::mutations({"own.glsl", function + "if ("}, {}));
    EXPECT_THAT(message_of<CompileError>([] { (void)excerpts_of("\n#include \"none.glsl\"\n"); }),
                HasSubstr("own.frag:2: cannot find include \"none.glsl\""));
}

// "12 comparison: '<' -> '<='", of each fault of a text.
std::vector<std::string> faults_of(const std::string& text, const std::string& kind = {}) {
    std::vector<std::string> found;
    for (const Mutation& one : module::mutations({"own.glsl", text}, {}))
        if (kind.empty() || one.kind == kind)
            found.push_back(std::to_string(one.line) + " " + one.kind + ": '" + one.before + "' -> '" +
                            one.after + "'");
    return found;
}

// The faults of an expression of floats a, b, vectors u, v of three and a structure s { float p, q; int n; }.
std::vector<std::string> changed(const std::string& expression, const std::string& kind) {
    const std::string head =
        "struct S { float p; float q; int n; };\nfloat g(float x, float y);\n"
        "float f(float a, float b, vec3 u, vec3 v, S s) { return ";
    const std::string text = head + expression + "; }\n";
    std::vector<std::string> results;
    for (const Mutation& one : module::mutations({"own.glsl", text}, {}))
        if (one.kind == kind) {
            const std::string whole = mutated(text, one);
            results.push_back(whole.substr(head.size(), whole.size() - head.size() - 4));
            EXPECT_EQ(one.line, 3);
            EXPECT_EQ(one.function, "f");
        }
    return results;
}

TEST(Mutations, ChangeOperatorsAndComparisons) {
    EXPECT_THAT(changed("a + b", "operator"), ElementsAre("a - b"));
    EXPECT_THAT(changed("-a * b", "operator"), ElementsAre("a * b", "-a / b"));
    EXPECT_THAT(changed("a < b && !(a == b) ? a : b", "operator"),
                ElementsAre("a < b || !(a == b) ? a : b", "a < b && (a == b) ? a : b"));
    EXPECT_THAT(changed("a < b ? a : b", "comparison"), ElementsAre("a <= b ? a : b", "a > b ? a : b"));
    EXPECT_THAT(changed("a < b ? a : b", "condition"), ElementsAre("true ? a : b", "false ? a : b"));
    EXPECT_THAT(changed("float(s.n << 2)", "operator"), ElementsAre("float(s.n >> 2)"));
}

TEST(Mutations, ChangeConstantsAndFunctions) {
    EXPECT_THAT(changed("a * 0.3", "constant"), ElementsAre("a * 0.6", "a * 0.15"));
    EXPECT_THAT(changed("a * 1.0 + 0.0", "constant"),
                ElementsAre("a * 0.0 + 0.0", "a * 2.0 + 0.0", "a * 1.0 + 1.0"));
    EXPECT_THAT(changed("float(s.n & 0x7)", "constant"), ElementsAre("float(s.n & 0x6)"));
    EXPECT_THAT(changed("float(uint(s.n) + 4u)", "constant"),
                ElementsAre("float(uint(s.n) + 5u)", "float(uint(s.n) + 3u)"));
    EXPECT_THAT(changed("false ? a : b", "constant"), ElementsAre("true ? a : b"));
    EXPECT_THAT(changed("max(a, abs(b))", "function"), ElementsAre("min(a, abs(b))", "max(a, (b))"));
}

TEST(Mutations, LeaveOutStatementsAndMoveTheBoundsOfLoops) {
    const std::string text =
        "float f(float x) {\n"
        "    float sum = 0.0;\n"
        "    for (int i = 0; i < 4; ++i) {\n"
        "        if (x > sum) continue;\n"
        "        sum += x;\n"
        "    }\n"
        "    return sum;\n"
        "}\n";
    EXPECT_THAT(faults_of(text, "loop bound"),
                ElementsAre("3 loop bound: '<' -> '<='", "3 loop bound: '<' -> '>'"));
    EXPECT_THAT(faults_of(text, "statement"),
                ElementsAre("4 statement: 'continue;' -> ';'", "5 statement: 'sum += x;' -> ';'"));
    EXPECT_THAT(faults_of(text, "condition"),
                ElementsAre("4 condition: 'x > sum' -> 'true'", "4 condition: 'x > sum' -> 'false'"));
}

TEST(Mutations, LeaveCommentsDirectivesInterfaceAndIncludesAlone) {
    const TemporaryDirectory folder;
    (void)folder.write("other.glsl", "float g(float x) { return x * 3.0; }\n");
    const std::string text =
        "#version 330 core\n"
        "#include \"other.glsl\"\n"
        "#define TWICE(x) (2.0 * (x))\n"
        "#if 0\nfloat dead(float x) { return x + 1.0; }\n#endif\n"
        "struct S { float a[4]; };\n"
        "layout(location = 1) in vec2 uv;\n"
        "uniform sampler2D image;\n"
        "const float third = 1.0 / 3.0;  // 1.0 + 2.0\n"
        "/* 4.0\n*/ float f(float x) { return TWICE(g(x)) + third + texture(image, uv).x; }\n";
    const std::string file = folder.write("own.frag", text).string();
    std::vector<std::string> found;
    for (const Mutation& one : module::mutations({file, text}, {folder.path()})) {
        found.push_back(std::to_string(one.line) + " " + one.before + " " + one.after);
        EXPECT_EQ(text.substr(one.begin, one.end - one.begin), one.before);
    }
    EXPECT_THAT(found, ElementsAre("10 1.0 0.0", "10 1.0 2.0", "10 / *", "10 3.0 6.0", "10 3.0 1.5", "12 + -",
                                   "12 + -"));
}

TEST(Mutations, ATextIsValidInSomeStage) {
    const auto message = [](const std::string& text) {
        return message_of<CompileError>([&] { require_valid({"own.glsl", text}, {}); });
    };
    EXPECT_EQ(message("float f(float x) {\n    return x +\n  y; }\n"),
              "own.glsl:3: 'y' : undeclared identifier");
    EXPECT_THAT(message("#include \"none.glsl\"\n"), HasSubstr("none.glsl"));
    EXPECT_THAT(message("float f( { ((((\n"), HasSubstr("own.glsl:1: "));
    EXPECT_EQ(message(""), "");
}

}  // namespace gloam::source::excerpts_test
