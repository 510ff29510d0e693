// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "site/page_data.hpp"
#include "support/test.hpp"

namespace gloam::site {

using nlohmann::json;

namespace document_data_test {

json blocks(const std::string& markdown) {
    return json::parse(document_json(markdown));
}

TEST(DocumentDataTest, HeadingsAndParagraphs) {
    EXPECT_EQ(blocks("# Title\n\nOne line\nand another.\n\n## Part\nText"),
              json::parse(R"([{"kind": "heading", "level": 1, "text": "Title"},
                              {"kind": "paragraph", "text": "One line and another."},
                              {"kind": "heading", "level": 2, "text": "Part"},
                              {"kind": "paragraph", "text": "Text"}])"));
}

TEST(DocumentDataTest, LinksAndEmphasisBecomeTheirWords) {
    EXPECT_EQ(
        blocks("See [the page](page.md) for **bold** and *copies*, and `a * b * c`.").front().at("text"),
        "See the page for bold and copies, and `a * b * c`.");
}

TEST(DocumentDataTest, ListsJoinTheLinesOfAnItem) {
    EXPECT_EQ(blocks("- one\n  more\n- two\n\n1. first\n2. second\n"),
              json::parse(R"([{"kind": "list", "items": ["one more", "two"]},
                              {"kind": "list", "items": ["first", "second"]}])"));
}

TEST(DocumentDataTest, TablesKeepTheirCells) {
    EXPECT_EQ(
        blocks("| a | `b|c` |\n| --- | ---: |\n| 1 | <b>x</b> |\n| - | |\ntext"),
        json::parse(R"([{"kind": "table", "head": ["a", "`b|c`"], "rows": [["1", "<b>x</b>"], ["-", ""]]},
                              {"kind": "paragraph", "text": "text"}])"));
}

TEST(DocumentDataTest, CodeIsAsItStands) {
    EXPECT_EQ(blocks("```sh\n# no heading\n| no table |\n```\n\n    indented\n    twice\n"),
              json::parse(R"([{"kind": "code", "text": "# no heading\n| no table |\n"},
                              {"kind": "code", "text": "indented\ntwice\n"}])"));
}

TEST(DocumentDataTest, PicturesAndNothingAreLeftOut) {
    EXPECT_EQ(blocks("![a plot](plot.svg)\n"), json::array());
    EXPECT_EQ(blocks(""), json::array());
}

}  // namespace document_data_test

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

namespace document_data_test {

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

}  // namespace document_data_test

}  // namespace gloam::site
