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
};

[[nodiscard]] bool is_word(std::string_view token);
[[nodiscard]] bool is_number(std::string_view token);

// The line of a position in a text.
[[nodiscard]] int line_at(std::string_view text, std::size_t position);

// The tokens of the first file of a text, but for its directives.
[[nodiscard]] std::vector<Token> tokens_of(const ActiveText& active);

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
