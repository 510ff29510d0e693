// SPDX-License-Identifier: MIT
// Somebody's shader file: `gloam check FILE` and `gloam explain`.
#include "tools/gloam.hpp"

namespace gloam::test::own_file_test {

const std::string file = std::string(GLOAM_TOOLS_FIXTURES) + "/own.glsl";

class OwnFile : public InFolder {};

TEST_F(OwnFile, EveryFunctionIsJudgedByTheRules) {
    const std::string report = path("own.json").string();
    EXPECT_THAT(output_of(gloam("check {} --inputs 512 --json {}", file, report)),
                HasSubstr("2 checks, 0 failed"));
    const json rows = json::parse(read_file(report)).at("results");
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].at("function"), "own_root");
    EXPECT_EQ(rows[0].at("verdict"), "rules");
    EXPECT_EQ(rows[0].at("inputs"), 512);
}

// A shader of another API and stage: its functions are checked without main, bindings and inputs.
TEST_F(OwnFile, AWholeShaderIsCheckedFunctionByFunction) {
    const std::string shader = write("whole.frag",
                                     "#version 330 core\n"
                                     "in vec2 uv;\nout vec4 color;\nuniform sampler2DMS image;\n"
                                     "float luma(vec3 c) { return dot(c, vec3(0.3, 0.6, 0.1)); }\n"
                                     "float luma(vec4 c) { return luma(c.rgb) * c.a; }\n"
                                     "float table(int i) { return float[2](1.0, 2.0)[i]; }\n"
                                     "float edge(float x) { return fwidth(x); }\n"
                                     "vec3 seen() { return texelFetch(image, ivec2(uv), 0).rgb; }\n"
                                     "void main() { color = vec4(seen(), edge(luma(color))); }\n")
                                   .string();
    const std::string report = path("own.json").string();
    const CommandResult all = gloam("check {} --inputs 64 --json {}", shader, report);
    expect_success(all);
    EXPECT_THAT(all.out, HasSubstr("4 checks, 0 failed"));
    EXPECT_THAT(all.out, HasSubstr("#version 330 core is compiled as #version 450 for Vulkan"));
    EXPECT_THAT(all.out, testing::ContainsRegex("seen\\(\\) was left out: it uses \"image\".*whole.frag:9"));
    EXPECT_THAT(all.out, testing::ContainsRegex("table shipped: the result is undefined for .* of 64 inputs.*"
                                                "element .* of 2, in table .*whole.frag:7"));
    const json rows = json::parse(read_file(report)).at("results");
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[0].at("equation"), "luma(vec3)");
    EXPECT_EQ(rows[1].at("equation"), "luma(vec4)");
    EXPECT_EQ(rows[1].at("function"), "luma");
    EXPECT_GT(rows[2].at("undefined"), 0);
    expect_success(gloam("check {} luma(vec4) --inputs 64 --variant all", shader));
    expect_success(gloam("explain {} luma(vec4) 1 2 3 4", shader));
    // What was named and cannot be checked is not passed over.
    EXPECT_EQ(gloam("check {} luma seen --inputs 64", shader).status, 2);
    expect_could_not_run(gloam("explain {} seen 1 1", shader), "image");
    // A quad: the values of all four, or of one for all.
    EXPECT_THAT(output_of(gloam("explain {} edge 1 2 5 8", shader)), HasSubstr("OpFSub"));
    expect_success(gloam("explain {} edge 1", shader));
    expect_could_not_run(gloam("explain {} edge 1 2", shader),
                         "takes 4 values (or 1, for all its invocations), got 2");
}

// What a shader is given besides parameters: ranges, explanations and other devices know it.
TEST_F(OwnFile, UniformsAndSamplersAreInputs) {
    const std::string shader =
        write("given.frag",
              "#version 300 es\nprecision mediump float;\n"
              "uniform sampler2D image;\nuniform float exposure;\n"
              "layout(std140) uniform Grade { vec3 gain; float weights[3]; };\n"
              "in vec2 uv;\nout vec4 color;\n"
              "vec3 seen() { return texture(image, uv).rgb * exposure; }\n"
              "float mean(float a[3]) { return a[0] * weights[0] + a[1] * weights[2]; }\n"
              "void main() { color = vec4(seen() * gain, 1.0); }\n")
            .string();
    EXPECT_THAT(output_of(gloam("check {} --inputs 64 --variant all", shader)),
                HasSubstr("14 checks, 0 failed"));
    EXPECT_THAT(output_of(gloam("check {} seen --inputs 64 --range exposure=1:2 --range uv=0:1", shader)),
                HasSubstr("1 checks, 0 failed"));
    expect_could_not_run(gloam("check {} seen --range gain=0:1", shader), "gain");
    EXPECT_THAT(output_of(gloam("explain {} seen 0.5 0.5 2", shader)), HasSubstr("given.frag:8"));
    const std::string report = path("opengl.json").string();
    const CommandResult opengl =
        gloam("check {} seen --inputs 64 --device es:llvmpipe-3.2 --json {}", shader, report);
    if (opengl.out.find("unsupported") == std::string::npos) return expect_could_not_run(opengl, "OpenGL");
    EXPECT_THAT(read_file(report),
                HasSubstr("runs in several invocations together, and OpenGL runs each alone"));
}

// Vulkan promises nothing of a sine outside of [-pi, pi].
TEST_F(OwnFile, ACheckWithoutAVerdictNamesTheRange) {
    const std::string shader = write("wave.glsl", "float wave(float x) { return sin(1e20 + x); }\n").string();
    const CommandResult usual = gloam("check {} --inputs 64", shader);
    EXPECT_EQ(usual.status, 2);
    EXPECT_THAT(usual.out, HasSubstr("--range PARAMETER=LOW:HIGH"));
    const CommandResult given = gloam("check {} --inputs 64 --range x=0:1", shader);
    EXPECT_EQ(given.status, 2);
    EXPECT_THAT(given.out, Not(HasSubstr("--range PARAMETER"))) << "it was given";
}

TEST_F(OwnFile, NothingCheckedIsNoSuccess) {
    const std::string shader = path("nothing.glsl").string();
    const std::string sampled =
        "vec4 sampled(sampler2DMS image, ivec2 at) { return texelFetch(image, at, 0); }\n";
    std::ofstream(shader) << sampled;
    expect_could_not_run(
        gloam("check {}", shader),
        "nothing was checked: sampled(sampler2DMS, ivec2): values of the parameter type sampler2DMS");
    std::ofstream(shader) << "const float one = 1.0;\n";
    expect_could_not_run(gloam("check {}", shader), "nothing was checked: it defines no function");
    std::ofstream(shader) << sampled << "void nothing(float x) { }\n";
    const CommandResult several = gloam("check {}", shader);
    EXPECT_EQ(several.status, 2);
    EXPECT_THAT(several.err, HasSubstr("all 2 functions were left out"));
    EXPECT_THAT(several.out, HasSubstr("sampled(sampler2DMS, ivec2) was left out: values"));
    EXPECT_THAT(several.out, HasSubstr("nothing(float) was left out: it has no result"));
    std::ofstream(shader) << "float sum(float x) { return x + 1.0; }\n\nfloat wrong(float x) { return y; }\n";
    const CommandResult wrong = gloam("check {} --inputs 64", shader);
    EXPECT_EQ(wrong.status, 2);
    EXPECT_THAT(wrong.out, HasSubstr("1 checks, 0 failed"));
    EXPECT_THAT(wrong.out, HasSubstr(shader + ":3: 'y' : undeclared identifier"));
}

TEST_F(OwnFile, OneFunctionInAllVariantsFromItsRange) {
    EXPECT_THAT(
        output_of(gloam("check {} own_root --range p=2:3 --range q=0:1 --inputs 64 --variant all", file)),
        HasSubstr("7 checks, 0 failed"));
}

// No device gets a loop that takes too long, and the other functions are checked.
TEST_F(OwnFile, ALongLoopCostsOneFunction) {
    const std::string spins = std::string(GLOAM_TOOLS_FIXTURES) + "/own_spins.glsl";
    const std::string report = path("own.json").string();
    const std::string all = output_of(gloam("check {} --inputs 4096 --timeout 60 --json {}", spins, report));
    EXPECT_THAT(all, HasSubstr("3 checks, 0 failed, 1 not judged"));
    EXPECT_THAT(all, HasSubstr("own_spins shipped: it takes too long for 4096 of 4096 inputs"));
    const json rows = json::parse(read_file(report)).at("results");
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[1].at("function"), "own_spins");
    EXPECT_EQ(rows[1].at("outcome"), "not judged");
    EXPECT_EQ(rows[2].at("outside"), 0);
    EXPECT_EQ(rows[2].at("inputs"), 4096);
    EXPECT_EQ(rows[2].at("by_rules"), 4096);
    EXPECT_EQ(rows[2].at("bounded"), 2048);  // Bounds are calculated for at most 2,048 inputs of a run.
}

TEST_F(OwnFile, CoverageIsReportedOnRequest) {
    const std::string report = path("own.json").string();
    EXPECT_THAT(output_of(gloam("check {} own_swap --inputs 64 --coverage --json {}", file, report)),
                HasSubstr("own_swap shipped: lines 1 of 1, ways of branches 2 of 2"));
    const json row = json::parse(read_file(report)).at("results").at(0);
    EXPECT_EQ(row.at("coverage").at("points").at(0).at("text"), "return really ? v.yx : v;");
}

TEST_F(OwnFile, BadInputIsNamed) {
    expect_could_not_run(gloam("check {} no_such", file), "no_such");
    expect_could_not_run(gloam("check {} --range z=0:1", file), "z");
    expect_could_not_run(gloam("check {} --range p=1:0", file), "LOW <= HIGH");
    expect_could_not_run(gloam("explain {} own_root 1", file), "takes 2 values");
    expect_could_not_run(gloam("explain {} own_root 1 x", file), "x");
}

TEST_F(OwnFile, ExplainNamesTheLineWhereTheErrorEnters) {
    const std::string result = output_of(gloam("explain {} own_root 1 1e-4", file));
    EXPECT_THAT(result, testing::ContainsRegex("own.glsl:4 own_root +OpFMul"));
    EXPECT_THAT(result, testing::ContainsRegex("own.glsl:5 own_root +OpFSub.*most of the error"));
    EXPECT_THAT(result, HasSubstr("grows most at own.glsl:5, OpFSub: "));
    EXPECT_THAT(output_of(gloam("explain {} own_root 0 1", file)),
                AllOf(Not(HasSubstr("nan")),
                      testing::EndsWith("the first NaN is the result of own.glsl:4, GLSL.std.450 Sqrt\n")));
}

// `gloam audit FILE`.

class AuditCommand : public InFolder {
  protected:
    std::string lit() {
        return write("lit.glsl",
                     "// <script>alert(1)</script>\n"
                     "float angle(vec3 n, vec3 l) { return acos(dot(n, l)); }\n"
                     "// x in [0, 1]\n"
                     "float curve(float x) { return x / (1.0 + x); }\n")
            .string();
    }
};

TEST_F(AuditCommand, SaysWhatGoesWrongAndWhere) {
    const CommandResult all = gloam("audit {} --inputs 2048", lit());
    EXPECT_EQ(all.status, 1) << "some input gives NaN";
    EXPECT_THAT(all.out, StartsWith("lit.glsl: float angle(vec3 n, vec3 l)\n  n  "));
    EXPECT_THAT(all.out, HasSubstr("not finite"));
    EXPECT_THAT(all.out, HasSubstr("arises at lit.glsl:2 (acos)"));
    EXPECT_THAT(all.out, HasSubstr("acos(clamp(dot(n, l), -1.0, 1.0))"));
    EXPECT_THAT(all.out, HasSubstr("x               0 to 1 (comment)"));
    EXPECT_THAT(output_of(gloam("audit {} curve", lit())), HasSubstr("well            no input gives NaN"));
    EXPECT_EQ(gloam("audit {} curve --range x=-2:0", lit()).status, 1) << "it divides by zero at -1";
}

TEST_F(AuditCommand, RunsTheWorstInputsOnADevice) {
    const std::string report = path("audit.json").string();
    const CommandResult all = gloam("audit {} angle --device interpreter --json {}", lit(), report);
    EXPECT_EQ(all.status, 1);
    EXPECT_THAT(all.out, HasSubstr("NaN on interpreter"));
    const json function = json::parse(read_file(report)).at("functions").at(0);
    EXPECT_EQ(function.at("function"), "angle");
    EXPECT_EQ(function.at("broken"), true);
    EXPECT_EQ(function.at("domain").at(0).at("reason"), "name");
    const json finding = function.at("findings").at(0);
    EXPECT_EQ(finding.at("concern"), "not finite");
    EXPECT_EQ(finding.at("words").size(), 6U);
    EXPECT_EQ(finding.at("place").at("line"), 2);
    EXPECT_EQ(finding.at("devices").at(0).at("value"), "nan");
    // The words are a call of explain, which shows the same.
    std::string words;
    for (const auto& word : finding.at("words")) words += fmt::format(" 0x{:08x}", word.get<unsigned>());
    EXPECT_THAT(output_of(gloam("explain {} angle" + words, lit())),
                HasSubstr("the first NaN is the result of lit.glsl:2, GLSL.std.450 Acos"));
    expect_could_not_run(gloam("audit {} angle --device nothing-like-it", lit()), "nothing-like-it");
}

TEST_F(AuditCommand, WritesAPage) {
    const std::string page = path("audit.html").string();
    EXPECT_EQ(gloam("audit {} --inputs 512 --html {}", lit(), page).status, 1);
    const std::string html = read_file(page);
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)")) << "the source is text";
    EXPECT_THAT(html, Not(HasSubstr("<script>alert")));
    EXPECT_THAT(html, HasSubstr("<span class=\"heat4\"><b>   2</b> float angle"));
    EXPECT_THAT(html, HasSubstr("domain = domain.and_words({0x"));
    EXPECT_THAT(html, HasSubstr("+ acos(clamp(dot(n, l), -1.0, 1.0))"));
}

TEST_F(AuditCommand, RefusesWhatItCannotAudit) {
    expect_could_not_run(gloam("audit {}", path("missing.glsl").string()), "missing.glsl");
    expect_could_not_run(gloam("audit {} none", lit()), "no function none; it defines: angle, curve");
    expect_could_not_run(gloam("audit {} --range y=0:1", lit()), "no parameter has this name, only: l, n, x");
    expect_could_not_run(gloam("audit {}", write("main.frag", "void main() {}\n")),
                         "nothing was audited: it defines no function but main");
    expect_could_not_run(gloam("audit {} --range x=1", lit()), "expected NAME=LOW:HIGH");
    expect_could_not_run(gloam("audit {} --inputs 1", lit()), "--inputs");
    expect_could_not_run(gloam("audit {} --html {}", lit(), "/no/such/folder/a.html"), "/no/such/folder");
    const std::string broken = write("broken.glsl", "float f(float x) { return y; }\n").string();
    const CommandResult result = gloam("audit {}", broken);
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.out, HasSubstr("f(float) was left out: it does not compile"));
}

}  // namespace gloam::test::own_file_test
