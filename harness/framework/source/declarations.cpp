// SPDX-License-Identifier: MIT
#include "source/declarations.hpp"

#include <algorithm>
#include <array>

#include "source/outline.hpp"

namespace gloam::shader::internal {
namespace {

// The first parenthesis of a statement that starts a list of parameters.
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

bool is_qualifier(const Token& token) {
    constexpr std::array words{"const",   "in",       "out",      "inout",    "highp",    "mediump",  "lowp",
                               "precise", "coherent", "volatile", "restrict", "readonly", "writeonly"};
    return std::ranges::find(words, token.text) != words.end();
}

// "const in float[3] a[2]": the sizes behind the name come first.
DeclaredParameter parameter_of(Tokens tokens) {
    DeclaredParameter parameter;
    if (contains(tokens, "out")) parameter.direction = Direction::out;
    if (contains(tokens, "inout")) parameter.direction = Direction::inout;
    std::string type;
    std::string type_sizes;
    std::string name_sizes;
    for (std::size_t i = 0; i < tokens.size();) {
        if (tokens[i] == "[") {
            const std::size_t end = behind_bracket(tokens, i);
            (parameter.name.empty() ? type_sizes : name_sizes).append(joined(tokens.subspan(i, end - i), ""));
            i = end;
        } else {
            if (tokens[i].is_word() && !is_qualifier(tokens[i]))
                (type.empty() ? type : parameter.name) = tokens[i].text;
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
            end = tokens[end] == "[" || tokens[end] == "(" ? behind_bracket(tokens, end) : end + 1;
        parameters.push_back(parameter_of(tokens.subspan(first, end - first)));
        first = end + 1;
    }
    return parameters;
}

// Whether both have the same name and parameter types, and so declare one function.
bool declare_the_same(const Declaration& a, const Declaration& b) {
    return a.name == b.name && std::ranges::equal(a.parameters, b.parameters, {}, &DeclaredParameter::type,
                                                  &DeclaredParameter::type);
}

}  // namespace

std::optional<Declaration> declaration_of(Tokens statement) {
    const auto open = parameter_list(statement);
    if (!open) return std::nullopt;
    const std::size_t body = behind_bracket(statement, *open);
    return Declaration{.name = statement[*open - 1].text,
                       .result = joined(statement.first(*open - 1), " "),
                       .head = joined(statement.first(body), " "),
                       .parameters = parameters_of(statement.subspan(*open + 1, body - *open - 2)),
                       .defined = contains(statement.subspan(body), "{"),
                       .list = *open + 1,
                       .body = body};
}

std::vector<Declaration> declarations(std::string preprocessed) {
    std::vector<Declaration> found;
    for (Piece& piece : outline(whole_text(std::move(preprocessed)), Keep::line_numbers).pieces)
        if (piece.function) found.push_back(std::move(*piece.function));
    return found;
}

std::vector<Declaration> each_once(std::vector<Declaration> functions) {
    std::stable_partition(functions.begin(), functions.end(), [](const Declaration& f) { return f.defined; });
    std::vector<Declaration> once;
    for (Declaration& function : functions) {
        const auto is_same = [&](const Declaration& other) { return declare_the_same(other, function); };
        if (function.defined || std::ranges::none_of(once, is_same)) once.push_back(std::move(function));
    }
    return once;
}

std::string completed(std::string text, const std::vector<Declaration>& functions) {
    text += "\n";
    for (const Declaration& function : each_once(functions)) {
        if (function.defined) continue;
        const bool has_result = function.result != "void";
        text += function.head +
                (has_result ? " { " + function.result + " gloam_result; return gloam_result; }\n" : " { }\n");
    }
    if (std::ranges::none_of(functions, [](const Declaration& f) { return f.name == "main"; }))
        text += "void main() { }\n";
    return text;
}

}  // namespace gloam::shader::internal
