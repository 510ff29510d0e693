// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "site/page_data.hpp"
#include "support/test.hpp"

namespace gloam::site {

namespace pass_data_test {

const std::string fragments =
    "struct Parameters { vec2 scale; ivec2 size; mat3 turn; };\n"
    "layout(constant_id = 4) const int WIDTH = 3;\n"
    "const int REACH = WIDTH;\n"
    "uniform Parameters parameters;\n"
    "uniform sampler2D first;  // why\n"
    "uniform bool set;\n"
    "uniform sampler2D second;\n"
    "in vec2 at;\n"
    "layout(location = 0) out vec4 color;\n"
    "void main() {\n"
    "    vec4 texel = texelFetch(first, parameters.size, 0) + texelFetch(second, ivec2(WIDTH), REACH);\n"
    "    color = set ? texel : vec4(parameters.turn * vec3(at, 1.0), parameters.scale.x);\n"
    "}\n";

std::string made(const PassText& pass) {
    return pass_text(pass, {.library = {}, .page = {}});
}

TEST(PassDataTest, APassIsOneText) {
    EXPECT_THAT(made({"pass", fragments}),
                AllOf(StartsWith("#version 300 es\n"), HasSubstr("const int WIDTH = 3;\n"),
                      HasSubstr("uniform Parameters parameters;\n"), Not(HasSubstr("constant_id"))));
}

TEST(PassDataTest, ATextThatDoesNotCompileIsTold) {
    EXPECT_THROW((void)made({"pass", "void main() { no_such(); }\n"}), shader::CompileError);
}

}  // namespace pass_data_test

namespace shader_text_test {

TEST(ShaderTextTest, CommentsAndBlankLinesGo) {
    EXPECT_EQ(
        condensed(
            "#version 300 es\n\n  // a comment\nfloat f() { /* of\n two lines */ return 1.0; }  // end"),
        "#version 300 es\nfloat f() {   return 1.0; }\n");
}

TEST(ShaderTextTest, AnOperatorIsNoComment) {
    EXPECT_EQ(condensed("float x = a / b;\nfloat y = a\n/ b;\n"), "float x = a / b;\nfloat y = a\n/ b;\n");
}

TEST(ShaderTextTest, UndefsStayWhereAMacroIsDefined) {
    EXPECT_EQ(condensed("#undef a\nint x;\n"), "int x;\n");
    EXPECT_EQ(condensed("#define a b\n#undef a\nint x;\n"), "#define a b\n#undef a\nint x;\n");
}

TEST(ShaderTextTest, AnOpenCommentEndsTheText) {
    EXPECT_EQ(condensed("int x; /* open\nint y;"), "int x;\n");
    EXPECT_EQ(condensed(""), "");
}

}  // namespace shader_text_test

}  // namespace gloam::site
