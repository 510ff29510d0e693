// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shader/internal/lines.hpp"

namespace gloam::shader::internal {

struct Token {
    std::string text;
    std::size_t begin = 0;
    int tree_line = 0;  // in the text that the compiler parses
};

[[nodiscard]] bool is_word(std::string_view token);
[[nodiscard]] bool is_number(std::string_view token);

// The line of a position in a text.
[[nodiscard]] int line_at(std::string_view text, std::size_t position);

// The tokens of the first file of a text, and the text, with its includes, in which each of them has its own
// line.
class TokenText {
  public:
    explicit TokenText(const ActiveText& active);

    // The line of the file at a line of the exploded text; 0 for a line of an include.
    [[nodiscard]] int line_of(int tree_line, const std::string& file) const;

    std::vector<Token> tokens;
    std::string exploded;

  private:
    void add(std::string_view line);
    void add_tokens(std::string_view code, std::size_t begin);

    int lines_ = 0;
};

// Tokens with which a file does something: the body of a function, or the value of a constant.
struct Region {
    std::size_t first = 0;
    std::size_t last = 0;  // excluded
    std::string function;  // empty: outside of all
};
[[nodiscard]] std::vector<Region> regions(const std::vector<Token>& tokens);

// The index of the bracket that closes the one at `open`; the end if there is none.
[[nodiscard]] std::size_t closing(const std::vector<Token>& tokens, std::size_t open);

}  // namespace gloam::shader::internal
