// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "source/declarations.hpp"
#include "source/outline.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;

// Where a declaration begins: behind macros that are called without a ';', as in "INFO(name) float f(float
// x)".
std::size_t behind_macro_lines(Tokens statement) {
    std::size_t first = 0;
    while (first + 2 < statement.size() && statement[first].is_word() && statement[first] != "layout" &&
           statement[first + 1] == "(") {
        const std::size_t end = first + behind_bracket(statement.subspan(first), 1);
        if (end >= statement.size() || !statement[end].is_word()) break;
        first = end;
    }
    return first;
}

bool opens(const Token& token) {
    return token == "(" || token == "[" || token == "{";
}

// The declared names of "a, b[2], c = f(1)": each the last name outside brackets, before a '=' or the end.
void add_declared(Tokens list, std::vector<std::string>& names) {
    std::string last;
    bool named = false;
    const auto add = [&] {
        if (!last.empty()) names.push_back(last);
        last.clear();
        named = false;
    };
    for (std::size_t i = 0; i < list.size();) {
        if (list[i] == "=") named = !last.empty();
        if (list[i] == "," || list[i] == ";") add();
        if (!named && list[i].is_word()) last = list[i].text;
        i = opens(list[i]) ? behind_bracket(list, i) : i + 1;
    }
    add();
}

// Whether a token is a name, and no member of what stands before it.
bool is_own_name(Tokens tokens, std::size_t i) {
    return tokens[i].is_word() && (i == 0 || tokens[i - 1] != ".");
}

void add_mentions(Tokens tokens, Piece& piece) {
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (is_own_name(tokens, i)) piece.mentions.insert(tokens[i].text);
}

// Names that are assigned to, indexed or read, and never called: no function of that name is meant.
void add_variables(Tokens tokens, Piece& piece) {
    std::set<std::string> called;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!is_own_name(tokens, i)) continue;
        const Token& next = tokens[i + 1];
        if (next == "(") called.insert(tokens[i].text);
        // A macro may take the name of a function.
        if (next != "(" && next != ")" && next != ",") piece.variables.insert(tokens[i].text);
    }
    std::erase_if(piece.variables, [&](const std::string& name) { return called.contains(name); });
}

// A name of a parameter hides what has it at file scope.
void take_function(Tokens tokens, Declaration function, Piece& piece) {
    piece.kind = function.defined ? Kind::function : Kind::prototype;
    piece.names = {function.name};
    add_variables(tokens.subspan(function.body), piece);
    const Tokens list = tokens.subspan(function.list, function.body - 1 - function.list);
    for (const Token& token : list)
        if (token.is_word()) piece.parameter_types.push_back(token.text);
    for (const DeclaredParameter& parameter : function.parameters)
        if (std::ranges::count(list, parameter.name, &Token::text) == 1) piece.mentions.erase(parameter.name);
    piece.function = std::move(function);
}

constexpr std::array<std::string_view, 6> storage{"uniform", "buffer", "in", "out", "attribute", "varying"};

bool is_storage(const Token& token) {
    return std::ranges::find(storage, token.text) != storage.end();
}

// Qualifiers up to the name of the block or the type of the variable.
bool is_interface(Tokens head) {
    for (std::size_t i = 0; i < head.size();) {
        if (head[i] == "=") break;
        if (is_storage(head[i])) return true;
        const bool layout = head[i] == "layout" && i + 1 < head.size() && head[i + 1] == "(";
        const std::size_t end = layout ? behind_bracket(head, i + 1) : i + 1;
        if (layout && contains(head.subspan(i, end - i), "constant_id")) return true;
        i = end;
    }
    return false;
}

// "struct Name { ... } variables;" and "uniform Name { ... } instance;".
void take_braces(Tokens tokens, std::size_t open, Piece& piece) {
    const std::size_t end = behind_bracket(tokens, open);
    if (open > 0 && tokens[open - 1].is_word()) piece.names.push_back(tokens[open - 1].text);
    const std::size_t declared = piece.names.size();
    add_declared(tokens.subspan(end), piece.names);
    const bool block = !contains(tokens.first(open), "struct");
    piece.kind = is_interface(tokens.first(open)) ? Kind::interface
                 : declared < piece.names.size()  ? Kind::variable
                                                  : Kind::structure;
    if (block && declared == piece.names.size() && end > open + 1)
        add_declared(tokens.subspan(open + 1, end - open - 2), piece.names);
}

// Nothing of "layout(local_size_x = 8) in;", "precision highp float;", "invariant gl_Position;" has a name.
bool declares_nothing(Tokens tokens) {
    if (tokens[0] == "precision" || tokens[0] == "invariant" || tokens[0] == ";") return true;
    if (tokens[0] != "layout" || tokens.size() < 3) return false;
    return std::ranges::all_of(tokens.subspan(behind_bracket(tokens, 1)),
                               [](const Token& token) { return token == ";" || is_storage(token); });
}

void take(Tokens tokens, Piece& piece) {
    if (is_macro_call(tokens)) {
        piece.by_macro = true;
        return;
    }
    if (declares_nothing(tokens)) {
        piece.kind = tokens[0] == "layout" ? Kind::interface : Kind::other;
        return;
    }
    const auto brace =
        static_cast<std::size_t>(std::ranges::find(tokens, "{", &Token::text) - tokens.begin());
    if (auto function = declaration_of(tokens)) {
        take_function(tokens, std::move(*function), piece);
    } else if (brace < tokens.size() &&
               (!contains(tokens.first(brace), "=") || is_interface(tokens.first(brace)))) {
        take_braces(tokens, brace, piece);
    } else {
        piece.kind = is_interface(tokens) ? Kind::interface : Kind::variable;
        add_declared(tokens, piece.names);
    }
}

}  // namespace

bool is_macro_call(Tokens tokens) {
    if (tokens.size() < 3 || !tokens[0].is_word() || tokens[0] == "layout" || tokens[1] != "(") return false;
    const std::size_t end = behind_bracket(tokens, 1);
    return end == tokens.size() || tokens[end] == "{" || tokens[end] == ";";
}

Piece piece_of(std::vector<Token> tokens) {
    Piece piece;
    if (tokens.empty()) return piece;
    add_mentions(tokens, piece);
    tokens.erase(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(behind_macro_lines(tokens)));
    take(tokens, piece);
    piece.tokens = std::move(tokens);
    return piece;
}

Piece macro_of(const Directive& directive) {
    Piece piece;
    if (directive.keyword != "define" && directive.keyword != "undef") return piece;
    std::string text = directive.argument;
    std::ranges::replace(text, '\n', ' ');
    const std::vector<Token> tokens = tokens_of(text);
    if (tokens.empty()) return piece;
    piece.kind = Kind::macro;
    piece.names = {tokens.front().text};
    add_mentions(Tokens(tokens).subspan(1), piece);
    return piece;
}

}  // namespace gloam::shader::internal
