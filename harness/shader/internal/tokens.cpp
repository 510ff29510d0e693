// SPDX-License-Identifier: MIT
#include "shader/internal/tokens.hpp"

#include <algorithm>

namespace gloam::shader::internal {
namespace {

bool is_word_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

}  // namespace

std::vector<std::string> tokens_of(std::string_view text) {
    std::vector<std::string> tokens;
    bool line_start = true;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        if (c == '#' && line_start) {
            i = std::min(text.find('\n', i), text.size());
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '\n') {
            line_start = line_start || c == '\n';
            ++i;
        } else {
            std::size_t end = i + 1;
            if (is_word_character(c))
                while (end < text.size() && is_word_character(text[end])) ++end;
            tokens.emplace_back(text.substr(i, end - i));
            line_start = false;
            i = end;
        }
    }
    return tokens;
}

std::size_t behind_bracket(Tokens tokens, std::size_t open) {
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const std::string& token = tokens[i];
        if (token == "(" || token == "[" || token == "{") ++depth;
        if ((token == ")" || token == "]" || token == "}") && --depth == 0) return i + 1;
    }
    return tokens.size();
}

bool contains(Tokens tokens, std::string_view word) {
    return std::ranges::find(tokens, word) != tokens.end();
}

std::optional<std::size_t> parameter_list(Tokens statement) {
    for (std::size_t i = 0; i < statement.size();) {
        if (statement[i] == "=" || statement[i] == "{") return std::nullopt;
        if (statement[i] == "[" || (statement[i] == "(" && i > 0 && statement[i - 1] == "layout")) {
            i = behind_bracket(statement, i);
        } else if (statement[i] == "(") {
            return i >= 2 ? std::optional(i) : std::nullopt;
        } else {
            ++i;
        }
    }
    return std::nullopt;
}

}  // namespace gloam::shader::internal
