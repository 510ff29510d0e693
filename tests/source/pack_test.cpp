// SPDX-License-Identifier: MIT
#include "module/include.hpp"
#include "module/support.hpp"
#include "module/texts.hpp"

namespace gloam::source::pack_test {

using namespace module;

using Files = std::vector<std::filesystem::path>;

std::string packed(const std::string& text, const PackRequest& request = {}) {
    return pack({Source{"text", text}}, request, {fixtures()});
}

std::string packed_fixture(const std::string& name, const PackRequest& request = {}) {
    return pack(Files{fixture(name)}, request, {fixtures()});
}

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

// What a text has of math/hypot.glsl.
const std::string hypot_text =
    "// x squared.\n"
    "float fx_square(float x) {\n"
    "    return x * x;\n"
    "}\n"
    "\n"
    "// Length of (x, y).\n"
    "float fx_hypot(float x, float y) {\n"
    "    return sqrt(fx_square(x) + fx_square(y));\n"
    "}\n";

TEST(Pack, PutsDependenciesFirstAndDropsTheScaffolding) {
    EXPECT_EQ(packed_fixture("math/hypot.glsl"),
              "#version 450\n// SPDX-License-Identifier: MIT\n\n" + hypot_text);
}

TEST(Pack, HoldsEachFileOnceInAnyOrder) {
    const auto [hypot, neighbour] = std::pair(fixture("math/hypot.glsl"), fixture("math/neighbour.glsl"));
    for (const Files& files : {Files{hypot, fixture("math/square.glsl"), hypot, neighbour},
                               Files{neighbour, fixture("math/../math/square.glsl"), hypot}}) {
        const std::string text = pack(files, {}, {fixtures()});
        EXPECT_EQ(count_of(text, "float fx_square("), 1U);
        EXPECT_EQ(count_of(text, "SPDX"), 1U);
        EXPECT_THAT(text, AllOf(HasSubstr("fx_cube"), HasSubstr("fx_hypot")));
    }
}

TEST(Pack, AFileThatAnotherOneIncludesFirstIsStillGiven) {
    const Source first{"first", "#include \"math/neighbour.glsl\"\nfloat one() { return fx_square(1.0); }\n"};
    const std::filesystem::path second = fixture("math/neighbour.glsl");
    EXPECT_THAT(pack({first}, {}, {fixtures()}), Not(HasSubstr("fx_cube")));
    EXPECT_EQ(
        count_of(pack({first, {second.string(), read_text(second)}}, {}, {fixtures()}), "float fx_cube("),
        1U);
}

// A condition is decided for the version that is asked for, a comment that shares its line with a directive
// stays.
TEST(Pack, DecidesConditionsAndKeepsComments) {
    EXPECT_EQ(packed_fixture("pack/odd.glsl", {.language = Language::es300}),
              "#version 300 es\n"
              "// SPDX-License-Identifier: MIT\n"
              "precision highp float;\n"
              "precision highp int;\n"
              "precision highp sampler2D;\n"
              "\n"
              "/* This comment stays,\n"
              "#include \"pack/conditional.glsl\"\n"
              "   and so does its second half. */\n"
              "\n"
              "// Before the include.\n"
              "const float FX_HALF = 0.5;\n"
              "\n" +
                  hypot_text +
                  "\n"
                  "#define FX_SCALE 2.0\n"
                  "\n"
                  "// Uses all of it.\n"
                  "float fx_odd(float x) {\n"
                  "    return FX_SCALE * fx_hypot(x, FX_HALF);\n"
                  "}\n");
}

// The preprocessor's output holds the names of the texts, too: none may be taken for a mark of a line.
TEST(Pack, ATextMayHaveAnyName) {
    const Source text{
        .name = "kernel of gloam_line_occlusion",
        .text =
            "uniform float fx_scale;\n#include \"pack/conditional.glsl\"\nfloat f() { return fx_scale; }\n"};
    const std::string all = pack({text}, {.language = Language::es300}, {fixtures()});
    EXPECT_EQ(count_of(all, "uniform float fx_scale;"), 1U);
}

TEST(Pack, AConditionMayHideOrHoldAnInclude) {
    EXPECT_THAT(
        packed("#define FX_FAST\n#include \"pack/conditional.glsl\"\nfloat f() { return fx_square(2.0); }\n"),
        HasSubstr("float fx_square"));
    EXPECT_THAT(packed("#include \"pack/conditional.glsl\"\nfloat f() { return 2.0; }\n"),
                Not(HasSubstr("fx_square")));
    const std::string text =
        "#if __VERSION__ >= 450 && !defined(GL_ES)\nfloat f() { return 1.0; }\n#elif defined(GL_ES)\n"
        "float f() { return 2.0; }\n#else\nfloat f() { return 3.0; }\n#endif\n";
    EXPECT_THAT(packed(text), HasSubstr("1.0"));
    EXPECT_THAT(packed(text, {.language = Language::es310}), AllOf(HasSubstr("2.0"), Not(HasSubstr("1.0"))));
    EXPECT_THAT(packed(text, {.language = Language::gl330}), AllOf(HasSubstr("3.0"), Not(HasSubstr("#if"))));
}

// One of everything, of each a second that nothing reaches.
constexpr const char* two_of_each = R"(
struct Used { float x; };
struct Unused { float x; };
#define TWICE(x) (2.0 * (x))
#define THRICE(x) (3.0 * (x))
const float ONE = 1.0, OTHER = 5.0;
const float LONELY[2] = float[2](1.0, 2.0);
// Of the user.
float fetch(int at);
float nothing(int at);
float helper(Used u) { return TWICE(u.x); }
float helpless(Unused u) { return THRICE(u.x); }
float wanted(Used u, int THRICE) { return helper(u) + ONE + fetch(THRICE); }
float other() { return helpless(Unused(LONELY[0])) + nothing(1); }
)";

TEST(Pack, LeavesOutWhatTheFunctionDoesNotReach) {
    const std::string text = packed(two_of_each, {.functions = {"wanted"}});
    EXPECT_EQ(text,
              "#version 450\n\n// Call: wanted\n// Define: fetch: Of the user\n"
              "// Structures to fill in: Used\n\n"
              "// Of the user.\nfloat fetch(int at);\nstruct Used { float x; };\n"
              "#define TWICE(x) (2.0 * (x))\nconst float ONE = 1.0, OTHER = 5.0;\n"
              "float helper(Used u) { return TWICE(u.x); }\n"
              "float wanted(Used u, int THRICE) { return helper(u) + ONE + fetch(THRICE); }\n");
    const std::string both = packed(two_of_each);
    for (const char* name : {"Unused", "THRICE(x)", "LONELY", "nothing", "helpless"})
        EXPECT_THAT(both, HasSubstr(name));
}

// Values that no function reads, because another value is the rest; a setting may have them all the same.
TEST(Pack, ConstantsThatAKeptCommentNamesAreKept) {
    const std::string text = packed(R"(
const uint FX_LAW_STEP = 0u;
const uint FX_LAW_LINEAR = 1u;
#define FX_LAW_CUBIC 2u
const uint FX_MODE_OFF = 0u;
const uint FX_MODE_ON = 1u;
const uint FX_LAW = 7u;
struct Settings {
    uint law;   // FX_LAW_*, linear for any other number
    uint mode;  // FX_MODE_ON or another
};
/* FX_MODE_OFF */
float unused() { return 1.0; }
float wanted(Settings s) { return s.law == FX_LAW_STEP ? 1.0 : 0.0; }
)",
                                    {.functions = {"wanted"}});
    for (const char* kept : {"FX_LAW_STEP = 0u", "FX_LAW_LINEAR = 1u", "FX_LAW_CUBIC 2u", "FX_MODE_ON = 1u"})
        EXPECT_THAT(text, HasSubstr(kept));
    for (const char* dropped : {"FX_MODE_OFF", "FX_LAW = 7u"}) EXPECT_THAT(text, Not(HasSubstr(dropped)));
}

constexpr const char* has_fetches = R"(// What the file is.

struct Result { float x; };
struct Camera { float width; };
// Defined by the user: depth of a pixel,
// in metres.
float fetch(int at);
/* Defined by the user: a weight. */
float weigh(Camera camera);
float helper(int at) { return fetch(at); }
// The whole.
Result whole(Camera camera, int at) { return Result(helper(at) * weigh(camera)); }
)";

TEST(Pack, TheHeadSaysWhatToCallAndWhatToDefine) {
    const std::string text = packed(has_fetches);
    EXPECT_THAT(text,
                StartsWith("#version 450\n\n// Call: whole\n// Define: fetch: depth of a pixel, in metres\n"
                           "// Define: weigh: a weight\n// Structures to fill in: Camera\n\n"
                           "// What the file is.\n\n// Defined by the user: depth of a pixel,\n"
                           "// in metres.\nfloat fetch(int at);\nstruct Camera"))
        << text;
    EXPECT_EQ(packed(text), text) << "packed twice";
    EXPECT_THAT(packed(std::string(has_fetches) + "float fetch(int at) { return 1.0; }\n"
                                                  "float weigh(Camera camera) { return 1.0; }\n"),
                Not(HasSubstr("// Call")));
    EXPECT_THAT(
        packed(has_fetches, {.functions = {"helper"}}),
        StartsWith("#version 450\n\n// Call: helper\n// Define: fetch: depth of a pixel, in metres\n\n"));
}

TEST(Pack, LinesOfTheHeadFitThePage) {
    std::string meaning;
    for (int i = 0; i < 60; ++i) meaning += "\n// word";
    const std::string text = packed("// Defined by the user:" + meaning +
                                    "\nfloat fetch(int at);\nfloat f() { return fetch(1); }\n");
    const std::string head = text.substr(0, text.find("// Defined"));
    EXPECT_EQ(count_of(head, "word"), 60U);
    EXPECT_EQ(count_of(head, "\n//   word"), 2U) << head;
    for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
        end = head.find('\n', at);
        EXPECT_LE(head.substr(at, end - at).size(), 120U);
    }
}

TEST(Pack, AFunctionThatIsNotThereIsNamed) {
    EXPECT_THAT(
        message_of<std::invalid_argument>([] { (void)packed(two_of_each, {.functions = {"fetch"}}); }),
        AllOf(StartsWith("text: "), HasSubstr("fetch")));
}

TEST(Pack, ATextThatDoesNotEndIsRefused) {
    for (const char* text : {"float f() { return 1.0;\n", "/* no end\nfloat f() { return 1.0; }\n"})
        EXPECT_THROW((void)packed(text), CompileError) << text;
}

TEST(Pack, WithAMainItIsTheWholeShader) {
    const std::string shader = R"(#version 450
// What the shader does.
//
// In two paragraphs.

layout(local_size_x = 4) in;
const int SIDE = 4;
int unused() { return 3; }
int index() { return int(gl_GlobalInvocationID.x); }

// What it writes.
layout(binding = 0, std430) buffer Values { int values[]; };
layout(binding = 1, std430) buffer Others { int others[SIDE]; } named;
layout(binding = 2) uniform sampler2D unread;
void main() { values[index()] = named.others[0]; }
)";
    const std::string text = packed(shader);
    EXPECT_THAT(text, StartsWith("#version 450\n\n// What the shader does.\n//\n// In two paragraphs.\n\n"
                                 "layout(local_size_x = 4) in;\n\n// What it writes.\nlayout(binding = 0"));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("unused")), Not(HasSubstr("unread"))));
    EXPECT_LT(text.find("const int SIDE"), text.find("} named;"));
    EXPECT_LT(text.find("} named;"), text.find("int index()"));
    // The same module, but for the sampler.
    const std::size_t unread = shader.find("layout(binding = 2)");
    const auto without_sampler = std::string(shader).erase(unread, shader.find("void main") - unread);
    EXPECT_EQ(
        compile({"packed", text}, {.variant = {.optimization = Optimization::performance}}).size(),
        compile({"as it was", without_sampler}, {.variant = {.optimization = Optimization::performance}})
            .size());
}

TEST(Pack, SpecializationConstantsAreSet) {
    const std::string shader =
        "#version 450\nlayout(constant_id = 3) const bool on = false;  // why\n"
        "layout(constant_id=4) const uint many = 2u;\nlayout(constant_id = 5) const float length = 1.5;\n"
        "layout(constant_id = 6) const int sign = 1;\nlayout(constant_id = 7) const int kept = 7;\n"
        "layout(binding = 0) buffer Out { float x; };\n"
        "void main() { if (on) x = length * float(many) * float(sign + kept); }\n";
    EXPECT_THAT(
        packed(shader, {.constants = {{3, 1}, {4, 9}, {5, 0x3E800000}, {6, 0xFFFFFFFF}, {8, 3}}}),
        HasSubstr(
            "layout(constant_id = 3) const bool on = true;  // why\n"
            "layout(constant_id=4) const uint many = 9u;\nlayout(constant_id = 5) const float length = "
            "0.25;\n"
            "layout(constant_id = 6) const int sign = -1;\nlayout(constant_id = 7) const int kept = 7;\n"));
}

// A name that a macro gives: "#define f g" before f is declared.
TEST(Pack, FollowsAMacroThatRenames) {
    const std::string text = packed(
        "#define f renamed\nfloat f() { return 1.0; }\n#undef f\nfloat f() { return 2.0; }\n"
        "float wanted() { return renamed(); }\n",
        {.functions = {"wanted"}});
    EXPECT_THAT(text, AllOf(HasSubstr("#define f renamed\nfloat f() { return 1.0; }\n#undef f\n"),
                            HasSubstr("float wanted()")));
}

TEST(Pack, ADirectiveWithinAFunctionStaysInIt) {
    const std::string body =
        "float f(float x) {\n#define STEP(y) ((y) + 1.0)\n#ifdef NEVER\n    x = 9.0;\n#endif\n"
        "    return STEP(x); /* two\n    lines */\n}\n";
    EXPECT_EQ(packed(body),
              "#version 450\n\nfloat f(float x) {\n#define STEP(y) ((y) + 1.0)\n"
              "    return STEP(x); /* two\n    lines */\n}\n");
}

TEST(Pack, ExtensionsAndLicencesComeFirstAndOnce) {
    const TemporaryDirectory dir;
    const auto first = dir.write("a.glsl", "// SPDX-License-Identifier: MIT\nfloat a() { return 1.0; }\n");
    const auto second = dir.write(
        "b.glsl",
        "// SPDX-License-Identifier: Apache-2.0\r\n# extension GL_OES_sample_variables : enable // why\n"
        "#version 450\nfloat b() { return 2.0; }\n");
    EXPECT_THAT(
        pack(Files{first, second, first}, {.language = Language::es310}, {}),
        StartsWith(
            "#version 310 es\n// SPDX-License-Identifier: MIT\n// SPDX-License-Identifier: Apache-2.0\n"
            "#extension GL_OES_sample_variables : enable\nprecision highp float;\n"));
}

TEST(Pack, WhatHasNoFunctionIsKeptWhole) {
    const TemporaryDirectory dir;
    const auto text = "const float A = 1.0;\n#define B 2.0\nstruct C { float x; };\n";
    EXPECT_EQ(pack(Files{dir.write("c.glsl", text)}, {}, {}), std::string("#version 450\n\n") + text);
}

TEST(Pack, CountsLinesOfCode) {
    EXPECT_EQ(code_of("#version 300 es\n\n  // one\nfloat f() { /* of\n two */ return a\n/ b; }  // end"),
              "#version 300 es\nfloat f() {\nreturn a\n/ b; }\n");
    EXPECT_EQ(code_of("#define A 1 + \\\n    2\nint x; /* open\nint y;"), "#define A 1 +     2\nint x;\n");
    EXPECT_EQ(code_lines(""), 0U);
    EXPECT_EQ(code_lines("// one\n\nfloat f() {  // two\n    /* three */\n}\n"), 2U);
}

}  // namespace gloam::source::pack_test
