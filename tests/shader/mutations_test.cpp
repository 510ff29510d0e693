// SPDX-License-Identifier: MIT
#include "shader/mutations.hpp"
#include "shader/include.hpp"
#include "support.hpp"

#include "support/matchers.hpp"

namespace gloam::shader::mutations_test {

using test::message_of;
using test::TemporaryDirectory;

// "12 comparison: '<' -> '<='", of each fault of a text.
std::vector<std::string> faults_of(const std::string& text, const std::string& kind = {}) {
    std::vector<std::string> found;
    for (const Mutation& one : mutations({"own.glsl", text}, {}))
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
    for (const Mutation& one : mutations({"own.glsl", text}, {}))
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

// What only the compiler knows: the types.
TEST(Mutations, ChangeComponentsMembersAndArgumentsOfOneType) {
    EXPECT_THAT(changed("u.x", "components"), ElementsAre("u.y"));
    EXPECT_THAT(changed("u.z", "components"), ElementsAre("u.x", "u.y"));
    EXPECT_THAT(changed("u.rg.x", "components"), ElementsAre("u.gr.x", "u.rr.x", "u.rg.y"));
    EXPECT_THAT(changed("s.p + float(s.n)", "member"), ElementsAre("s.q + float(s.n)"));
    EXPECT_THAT(changed("g(a, g(b, 2.0))", "arguments"), ElementsAre("g(g(b, 2.0), a)", "g(a, g(2.0, b))"));
    EXPECT_THAT(changed("dot(u, vec3(a, b, b))", "arguments"),
                ElementsAre("dot(vec3(a, b, b), u)", "dot(u, vec3(b, a, b))"));
    EXPECT_THAT(changed("mix(u, v, a).x", "arguments"), ElementsAre("mix(v, u, a).x"));
    EXPECT_THAT(changed("(u * a).x", "arguments"), IsEmpty());
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
    for (const Mutation& one : mutations({file, text}, {folder.path()})) {
        found.push_back(std::to_string(one.line) + " " + one.before + " " + one.after);
        EXPECT_EQ(text.substr(one.begin, one.end - one.begin), one.before);
    }
    EXPECT_THAT(found, ElementsAre("10 1.0 0.0", "10 1.0 2.0", "10 / *", "10 3.0 6.0", "10 3.0 1.5", "12 + -",
                                   "12 + -", "12 x y"));
}

// Nearly all of them.
TEST(Mutations, OfTheLibraryCompile) {
    const std::filesystem::path root = GLOAM_GLSL_DIR;
    std::size_t tried = 0;
    std::size_t refused = 0;
    for (const char* name : {"gloam/occlusion/bias.glsl", "gloam/sampling/halton.glsl"}) {
        const Source source{(root / name).string(), read_text(root / name)};
        for (const Mutation& one : mutations(source, {root})) {
            ++tried;
            try {
                (void)functions({source.name, "#version 450\n" + mutated(source.text, one)},
                                {.include_roots = {root}, .variant = {}});
            } catch (const CompileError&) {
                ++refused;
            }
        }
    }
    EXPECT_GT(tried, 30U);
    EXPECT_LT(refused, tried / 10);
}

TEST(Mutations, AreNotOfATextThatDoesNotCompile) {
    const auto message = [](const std::string& text) {
        return message_of<CompileError>([&] { (void)mutations({"own.glsl", text}, {}); });
    };
    EXPECT_EQ(message("float f(float x) {\n    return x +\n  y; }\n"),
              "own.glsl:3: 'y' : undeclared identifier");
    EXPECT_THAT(message("#include \"none.glsl\"\n"), HasSubstr("none.glsl"));
    EXPECT_THAT(message("float f( { ((((\n"), HasSubstr("own.glsl:1: "));
    EXPECT_EQ(message(""), "");
}

}  // namespace gloam::shader::mutations_test
