// SPDX-License-Identifier: MIT
#include "source/tokens.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "source/lines.hpp"

namespace gloam::source {
namespace {

constexpr std::array long_operators{"<<=", ">>=", "<<", ">>", "<=", ">=", "==", "!=", "&&", "||", "^^",
                                    "++",  "--",  "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^="};
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789";
constexpr std::string_view digits = "0123456789";

std::size_t number_length(std::string_view text) {
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    std::size_t end = hex ? 2 : 0;
    for (; end < text.size(); ++end) {
        const bool sign = !hex && (text[end] == '+' || text[end] == '-') && end > 0 &&
                          (text[end - 1] == 'e' || text[end - 1] == 'E');
        if (!sign && text[end] != '.' && letters.find(text[end]) == std::string_view::npos) break;
    }
    return end;
}

std::size_t token_length(std::string_view text) {
    const bool fraction = text[0] == '.' && text.size() > 1 && digits.find(text[1]) != std::string_view::npos;
    if (fraction || digits.find(text[0]) != std::string_view::npos) return number_length(text);
    if (letters.find(text[0]) != std::string_view::npos)
        return std::min(text.find_first_not_of(letters), text.size());
    const auto longer =
        std::ranges::find_if(long_operators, [&](const char* one) { return text.starts_with(one); });
    return longer == long_operators.end() ? 1 : std::string_view(*longer).size();
}

}  // namespace

bool Token::is_word() const {
    return letters.find(text.front()) != std::string_view::npos && !is_number();
}

bool Token::is_number() const {
    return digits.find(text.front()) != std::string_view::npos || (text.front() == '.' && text.size() > 1);
}

std::vector<Token> line_tokens(const Line& line, std::string_view text) {
    constexpr std::string_view between{" \t\r\n\v\f\0", 7};
    std::vector<Token> tokens;
    if (directive_of(line)) return tokens;
    const auto begin = static_cast<std::size_t>(line.text.data() - text.data());
    const std::string_view code = line.code;
    int number = line.number;
    std::size_t before = 0;
    for (std::size_t at = code.find_first_not_of(between); at != std::string_view::npos;
         at = code.find_first_not_of(between, at)) {
        const std::size_t length = token_length(code.substr(at));
        number += static_cast<int>(std::ranges::count(line.text.substr(before, at - before), '\n'));
        tokens.push_back({std::string(code.substr(at, length)), begin + at, number});
        before = at;
        at += length;
    }
    return tokens;
}

std::vector<Token> tokens_of(std::string_view text) {
    std::vector<Token> tokens;
    for (const Line& line : split_lines(text))
        std::ranges::move(line_tokens(line, text), std::back_inserter(tokens));
    return tokens;
}

std::size_t behind(Tokens tokens, std::size_t i) {
    int depth = 0;
    for (; i < tokens.size(); ++i) {
        if (tokens[i] == "(" || tokens[i] == "[" || tokens[i] == "{") ++depth;
        if (depth == 0) return i + 1;
        if ((tokens[i] == ")" || tokens[i] == "]" || tokens[i] == "}") && --depth == 0) return i + 1;
    }
    return tokens.size();
}

Tokens up_to(Tokens tokens, std::string_view text) {
    return {tokens.begin(), std::ranges::find(tokens, text, &Token::text)};
}

bool contains(Tokens tokens, std::string_view text) {
    return up_to(tokens, text).size() < tokens.size();
}

std::string joined(Tokens tokens, std::string_view separator) {
    std::string text;
    for (const Token& token : tokens) text.append(text.empty() ? "" : separator).append(token.text);
    return text;
}

}  // namespace gloam::source
