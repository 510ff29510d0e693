// SPDX-License-Identifier: MIT
#include "base/text.hpp"
#include "base/pattern.hpp"
#include "support/test.hpp"

namespace gloam::base::text_test {

// Test vectors of RFC 4648, section 10.
TEST(Base64, IsThatOfTheStandard) {
    const auto of = [](std::vector<unsigned char> bytes) { return base64(bytes); };
    EXPECT_EQ(of({}), "");
    EXPECT_EQ(of({'f'}), "Zg==");
    EXPECT_EQ(of({'f', 'o', 'o', 'b', 'a', 'r'}), "Zm9vYmFy");
    EXPECT_EQ(of({0xff, 0xfe, 0x00, 0xfb}), "//4A+w==");
}

TEST(Text, IsShortenedBetweenCharacters) {
    EXPECT_EQ(shortened("abcdef", 6), "abcdef");
    EXPECT_EQ(shortened("abcdefg", 6), "abc...");
    EXPECT_EQ(shortened("ab\u00e9\u00e9\u00e9", 6), "ab...");  // the first of them would be cut in two
    EXPECT_EQ(shortened(std::string(5'000'000, 'x'), 40).size(), 40U);
}

TEST(Text, OneLineShowsWhatATerminalWouldObey) {
    EXPECT_EQ(one_line("a\nb\x1b[2J\tc\x7f\n\n"), "a b [2J c ");
    EXPECT_EQ(one_line("caf\u00e9"), "caf\u00e9");
    EXPECT_EQ(one_line("a\xc2\x9b[2J\x80\xe2\x82"), "a  [2J   ");  // CSI, and bytes that are no UTF-8
    EXPECT_EQ(for_terminal("a\n\tb\x1b]0;c\x07\r\n"), "a\n\tb ]0;c  \n");
}

TEST(Pattern, FindsTakesApartAndReplaces) {
    const Pattern pair("(\\w+)=(\\d)?;", true);
    EXPECT_THAT(pair.first("a; b=2; c=;"), ElementsAre("b=2;", "b", "2"));
    EXPECT_THAT(pair.first("c=;"), ElementsAre("c=;", "c", ""));
    EXPECT_THAT(pair.first("none"), IsEmpty());
    EXPECT_THAT(pair.all("a=1; b=2;"), ElementsAre("a=1;", "b=2;"));
    EXPECT_EQ(Pattern("X+").replaced("aXXbXc", "-"), "a-b-c");
    EXPECT_EQ(Pattern("(x|y)+", true).first(std::string(1 << 20, 'X')).front().size(),
              1U << 20U);  // no stack
}

TEST(Text, HasOtherWordsOrSmallLetters) {
    EXPECT_EQ(replaced("aaba", "a", "aa"), "aaaabaa");
    EXPECT_EQ(lower("AMD Radeon 7\u00c9"), "amd radeon 7\u00c9");
}

TEST(Text, NamesAreOneShortLine) {
    EXPECT_TRUE(is_name("llvmpipe (LLVM 15.0.6, 256 bits)"));
    for (const std::string& text :
         {std::string(), std::string("a\nb"), std::string(1001, 'x'), std::string("\x1b")})
        EXPECT_FALSE(is_name(text)) << text;
}

TEST(Text, FileNamesLeadNowhereElse) {
    EXPECT_EQ(file_name_of("columns"), "columns");
    EXPECT_EQ(file_name_of("scaling-open-tiles_2.5"), "scaling-open-tiles_2.5");
    EXPECT_EQ(file_name_of("../../etc/passwd"), "%2E.%2F..%2Fetc%2Fpasswd");
    EXPECT_EQ(file_name_of("."), "%2E");
    EXPECT_EQ(file_name_of(""), "unnamed");
    std::set<std::string> names;
    for (const std::string& text :
         {std::string("a/b"), std::string("a b"), std::string("a%2Fb"), std::string("a\nb"),
          std::string(500, 'x'), std::string(501, 'x'), std::string("/")}) {
        const std::string name = file_name_of(text);
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_LE(name.size(), 120U);
        EXPECT_EQ(name.find_first_of("/ \n\\"), std::string::npos) << name;
        EXPECT_NE(name.front(), '.');
    }
}

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

// A text, and what is wrong with it; "": nothing. What is no JSON is left to the parser.
TEST(JsonBounds, EndDepthMembersAndBytes) {
    const std::string member = R"("a": [1, 2], )";
    const std::string open(100, '[');
    const std::pair<std::string, std::string> rows[] = {
        {std::string(64, '[') + std::string(64, ']'), ""},
        {"\n\n" + std::string(65, '['), "line 3: nested more than 64 deep"},
        {repeated("{\"a\":", 65), "nested"},
        {"[" + repeated("[],", 100'000) + "[]]", ""},
        {R"([")" + open + R"(\")" + open + R"(", "\\", "{{{"])", ""},
        {R"(["\\", )" + open, "nested"},
        {"{" + repeated(member, 999) + R"("b": 0})", ""},
        {"{" + repeated(member, 1000) + R"("b": 0})", "more than 1000 members"},
        {std::string(64U << 20U, ' '), ""},
        {std::string((64U << 20U) + 1, ' '), "67108865 bytes of JSON, expected at most 67108864"},
        {"", ""},
        {"]]]]", ""},
        {"\"\\", ""},
        {"}{", ""}};
    for (const auto& [text, error] : rows) {
        const auto read = [&] { require_bounded_json(text); };
        if (error.empty()) {
            EXPECT_NO_THROW(read()) << text.substr(0, 40);
        } else {
            expect_error<std::runtime_error>(read, {error});
        }
    }
}

}  // namespace gloam::base::text_test
