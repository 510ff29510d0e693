// SPDX-License-Identifier: MIT
#include "source/lines.hpp"
#include "module/support.hpp"

namespace gloam::source::lines_test {

std::vector<std::string> includes(std::string_view text) {
    std::vector<std::string> names;
    for (const Line& line : split_lines(text))
        if (const auto include = include_of(line))
            names.push_back((include->system ? "<" : "") + include->name);
    return names;
}

// However they are written, past continuations and comments, and of what is none.
TEST(Lines, FindsIncludes) {
    const std::pair<const char*, std::vector<std::string>> rows[] = {
        {"#include \"a\"\n  #\tinclude\"b\" // why\n/* x */ # include <c>\n#include \"d//e\"",
         {"a", "b", "<c", "d//e"}},
        {"#include \\\n \"a\"\n#inc\\\nlude \"b\"\n#include \\\r\n \"c\"\r\n", {"a", "b", "c"}},
        {"// #include \"a\"\n/* #include \"b\"\n#include \"c\"\n*/\n// goes on \\\n#include \"d\"\n", {}},
        {"/* // */ #include \"a\"\n// /*\n#include \"b\"\n", {"a", "b"}},
        {"#include\n#include a\n#include \"a\n#includes \"b\"\nfloat x; #include \"c\"\n#define include "
         "\"d\"\n",
         {}}};
    for (const auto& [text, names] : rows) EXPECT_EQ(includes(text), names) << text;
}

TEST(Tokens, HaveTheirPlaceInTheText) {
    const std::string text = "a.b += .5e-3f; // no\n#define c 1\n/* d */ x <<= 0x1Fu \\\n>= y2[i]";
    const std::vector<Token> tokens = tokens_of(text);
    EXPECT_EQ(joined(tokens, " "), "a . b += .5e-3f ; x <<= 0x1Fu >= y2 [ i ]");
    for (const Token& token : tokens) EXPECT_EQ(text.substr(token.begin, token.text.size()), token.text);
    EXPECT_EQ(tokens[5].line, 1);
    EXPECT_EQ(tokens[6].line, 3);
    EXPECT_EQ(tokens[9].line, 4);
}

}  // namespace gloam::source::lines_test
