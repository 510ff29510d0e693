// SPDX-License-Identifier: MIT
#include "site/page_data.hpp"
#include "support/test.hpp"

namespace gloam::site {

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
