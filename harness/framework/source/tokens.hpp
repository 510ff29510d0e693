// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::source {

// A name, keyword, number, operator or other character of a GLSL text.
struct Token {
    std::string text;
    std::size_t begin = 0;  // in the text
    int line = 1;           // of the text

    [[nodiscard]] std::size_t end() const { return begin + text.size(); }
    [[nodiscard]] bool is_word() const;  // a name or keyword
    [[nodiscard]] bool is_number() const;
    friend bool operator==(const Token& token, std::string_view text) { return token.text == text; }
};
using Tokens = std::span<const Token>;

// The tokens of a text, but for comments and directives.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

// The index behind a token: of an opening bracket behind the one that closes it, or the end if there is none.
[[nodiscard]] std::size_t behind(Tokens tokens, std::size_t i);

// The tokens before the first of this text; all if there is none.
[[nodiscard]] Tokens up_to(Tokens tokens, std::string_view text);

[[nodiscard]] bool contains(Tokens tokens, std::string_view text);

[[nodiscard]] std::string joined(Tokens tokens, std::string_view separator);

}  // namespace gloam::source
