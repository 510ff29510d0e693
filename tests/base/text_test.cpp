// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <gmock/gmock.h>

#include <set>

namespace gloam::base {
namespace text_test {

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

}  // namespace text_test
}  // namespace gloam::base
