// SPDX-License-Identifier: MIT
#include "shader/internal/declarations.hpp"

#include <algorithm>
#include <array>

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

std::size_t behind_macro_lines(Tokens statement) {
    std::size_t first = 0;
    while (first + 2 < statement.size() && is_word_character(statement[first].front()) &&
           statement[first] != "layout" && statement[first + 1] == "(") {
        const std::size_t end = first + behind_bracket(statement.subspan(first), 1);
        if (end >= statement.size() || !is_word_character(statement[end].front())) break;
        first = end;
    }
    return first;
}

std::optional<std::size_t> parameter_list(Tokens statement) {
    const std::size_t first = behind_macro_lines(statement);
    for (std::size_t i = first; i < statement.size();) {
        if (statement[i] == "=" || statement[i] == "{") return std::nullopt;
        if (statement[i] == "[" || (statement[i] == "(" && i > 0 && statement[i - 1] == "layout")) {
            i = behind_bracket(statement, i);
        } else if (statement[i] == "(") {
            return i >= first + 2 ? std::optional(i) : std::nullopt;
        } else {
            ++i;
        }
    }
    return std::nullopt;
}

namespace {

std::string joined(Tokens tokens, std::string_view separator) {
    std::string text;
    for (const std::string& token : tokens) text.append(text.empty() ? "" : separator).append(token);
    return text;
}

bool is_qualifier(const std::string& token) {
    constexpr std::array words{"const",   "in",       "out",      "inout",    "highp",    "mediump",  "lowp",
                               "precise", "coherent", "volatile", "restrict", "readonly", "writeonly"};
    return std::ranges::find(words, token) != words.end();
}

// "const in float[3] a[2]": the sizes behind the name come first.
DeclaredParameter parameter_of(Tokens tokens) {
    DeclaredParameter parameter;
    if (contains(tokens, "out")) parameter.direction = Direction::out;
    if (contains(tokens, "inout")) parameter.direction = Direction::inout;
    std::string type;
    std::string type_sizes;
    std::string name_sizes;
    int words = 0;  // 1: the type was read, 2: its name, too
    for (std::size_t i = 0; i < tokens.size();) {
        if (tokens[i] == "[") {
            const std::size_t end = behind_bracket(tokens, i);
            (words == 1 ? type_sizes : name_sizes).append(joined(tokens.subspan(i, end - i), ""));
            i = end;
        } else {
            if (!is_qualifier(tokens[i]) && ++words == 1) type = tokens[i];
            ++i;
        }
    }
    parameter.type = type + name_sizes + type_sizes;
    return parameter;
}

// What stands between the parentheses.
std::vector<DeclaredParameter> parameters_of(Tokens tokens) {
    std::vector<DeclaredParameter> parameters;
    if (tokens.empty() || (tokens.size() == 1 && tokens[0] == "void")) return parameters;
    for (std::size_t first = 0; first <= tokens.size();) {
        std::size_t end = first;
        while (end < tokens.size() && tokens[end] != ",")
            end = tokens[end] == "[" ? behind_bracket(tokens, end) : end + 1;
        parameters.push_back(parameter_of(tokens.subspan(first, end - first)));
        first = end + 1;
    }
    return parameters;
}

// A statement up to its ; or to the { of its body.
std::optional<Declaration> declaration_of(Tokens statement, bool defined) {
    const auto open = parameter_list(statement);
    if (!open) return std::nullopt;
    const std::size_t close = behind_bracket(statement, *open) - 1;
    const std::size_t first = behind_macro_lines(statement);
    return Declaration{.name = statement[*open - 1],
                       .result = joined(statement.subspan(first, *open - 1 - first), " "),
                       .head = joined(statement.subspan(first, close + 1 - first), " "),
                       .parameters = parameters_of(statement.subspan(*open + 1, close - *open - 1)),
                       .defined = defined};
}

}  // namespace

std::vector<Declaration> declarations(std::string_view preprocessed) {
    const std::vector<std::string> all = tokens_of(preprocessed);
    const Tokens tokens = all;
    std::vector<Declaration> found;
    std::size_t first = 0;
    for (std::size_t i = 0; i < tokens.size();) {
        const bool body = tokens[i] == "{" && parameter_list(tokens.subspan(first, i - first));
        if (tokens[i] == ";" || body) {
            if (auto declaration = declaration_of(tokens.subspan(first, i - first), body))
                found.push_back(std::move(*declaration));
            i = body ? behind_bracket(tokens, i) : i + 1;
            first = i;
        } else if (tokens[i] == "{" || tokens[i] == "(") {
            i = behind_bracket(tokens, i);
        } else {
            ++i;
        }
    }
    return found;
}

bool declare_the_same(const Declaration& a, const Declaration& b) {
    return a.name == b.name && std::ranges::equal(a.parameters, b.parameters, {}, &DeclaredParameter::type,
                                                  &DeclaredParameter::type);
}

std::string completed(std::string text, const std::vector<Declaration>& functions) {
    text += "\n";
    for (const Declaration& function : functions) {
        const bool known =
            function.defined || std::ranges::any_of(functions, [&](const Declaration& other) {
                return (other.defined || &other < &function) && declare_the_same(other, function);
            });
        if (known) continue;
        const bool has_result = function.result != "void";
        text += function.head +
                (has_result ? " { " + function.result + " gloam_result; return gloam_result; }\n" : " { }\n");
    }
    if (std::ranges::none_of(functions, [](const Declaration& f) { return f.name == "main"; }))
        text += "void main() { }\n";
    return text;
}

}  // namespace gloam::shader::internal
