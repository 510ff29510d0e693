// SPDX-License-Identifier: MIT
// Functions of a text from elsewhere, each as a text that a compute shader can contain.
#include "shader/excerpt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace gloam::shader {
namespace excerpt_test {

using test::message_of;
using test::TempDir;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Excerpts excerpts_of(const std::string& text) {
    return excerpts({"own.frag", text}, {});
}

// The compiled function, in the order of definitions.
std::vector<std::string> compiled(const Excerpt& excerpt) {
    std::vector<std::string> texts;
    for (const Function& function : functions({"own.frag", "#version 450\n" + excerpt.text}, {}))
        texts.push_back(to_glsl(function));
    return texts;
}

constexpr const char* fragment_shader =
    "// A shader for another API.\n"
    "#version 330 core\n"
    "in vec2 uv;\n"
    "out vec4 color;\n"
    "uniform sampler2D image;\n"
    "layout(local_size_x = 8) in;\n"
    "struct Light { vec3 to; };\n"
    "float gray(vec3 c) { return dot(c, vec3(0.3, 0.6, 0.1)); }\n"
    "float lit(Light light, vec3 n) { return gray(light.to * n); }\n"
    "vec3 seen() { return texture(image, uv).rgb; }\n"
    "void main() { color = vec4(gray(seen())); }\n";

TEST(Excerpts, LackVersionMainAndInterfaceOfTheText) {
    const Excerpts all = excerpts_of(fragment_shader);
    EXPECT_EQ(all.version, "330 core");
    ASSERT_EQ(all.functions.size(), 3U);
    EXPECT_THAT(compiled(all.functions[0]), ElementsAre("float gray(vec3 c)"));
    EXPECT_THAT(compiled(all.functions[1]),
                ElementsAre("float gray(vec3 c)", "float lit(Light light, vec3 n)"));
    EXPECT_THAT(all.functions[1].interface, IsEmpty());
    EXPECT_THAT(all.functions[2].interface, ElementsAre("image", "uv"));
    EXPECT_THAT(message_of<CompileError>([&] { static_cast<void>(compiled(all.functions[2])); }),
                HasSubstr("own.frag:10: 'image' : undeclared identifier"));
}

TEST(Excerpts, NameTheDefinitionsOfTheFileItself) {
    const TempDir folder;
    (void)folder.write("other.glsl", "float f(float x) { return x; }\nfloat g(float x) { return x; }\n");
    const Excerpts all = excerpts({"own.glsl",
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

TEST(Excerpts, KeepExtensionsConstantsAndMacros) {
    const Excerpts all = excerpts_of(
        "#extension GL_EXT_shader_explicit_arithmetic_types : enable\n"
        "layout(constant_id = 3) const int count = 4;\n"
        "#line 700\n"
        "#define SCALE float(count)\n"
        "const float half_of = 0.5;\n"
        "float unused(float x) { return x * undefined_name; }\n"
        "float f(float x) { return float(float32_t(x)) * SCALE * half_of; }\n");
    ASSERT_EQ(all.functions.size(), 2U);
    EXPECT_THAT(compiled(all.functions[1]), ElementsAre("float f(float x)"));
    EXPECT_THAT(all.functions[1].text, Not(HasSubstr("unused")));
    EXPECT_THAT(message_of<CompileError>([&] { static_cast<void>(compiled(all.functions[0])); }),
                HasSubstr("own.frag:6: 'undefined_name'"));
}

TEST(Excerpts, ATextWithoutFunctionsHasNone) {
    EXPECT_THAT(excerpts_of("#version 450\nconst float x = 1.0;\nvoid main() { }\n").functions, IsEmpty());
    EXPECT_THAT(message_of<CompileError>([] { (void)excerpts_of("\n#include \"none.glsl\"\n"); }),
                HasSubstr("own.frag:2: cannot find include \"none.glsl\""));
}

}  // namespace excerpt_test
}  // namespace gloam::shader
