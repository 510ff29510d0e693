// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "shader/internal/declarations.hpp"
#include "shader/internal/outline.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;

bool is_name(const std::string& token) {
    const char c = token.front();
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool opens(const std::string& token) {
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
        if (!named && is_name(list[i])) last = list[i];
        i = opens(list[i]) ? behind_bracket(list, i) : i + 1;
    }
    add();
}

void add_mentions(Tokens tokens, Piece& piece) {
    for (const std::string& token : tokens)
        if (is_name(token)) piece.mentions.insert(token.substr(0, token.find('.')));
}

// Names that are assigned to, indexed or read, and never called: no function of that name is meant.
void add_variables(Tokens tokens, Piece& piece) {
    std::set<std::string> called;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!is_name(tokens[i])) continue;
        const std::string name = tokens[i].substr(0, tokens[i].find('.'));
        const std::string& next = tokens[i + 1];
        if (name == tokens[i] && next == "(") called.insert(name);
        // A macro may take the name of a function.
        if (name != tokens[i] || (next != "(" && next != ")" && next != ",")) piece.variables.insert(name);
    }
    std::erase_if(piece.variables, [&](const std::string& name) { return called.contains(name); });
}

// A name of a parameter hides what has it at file scope.
void take_function(Tokens tokens, std::size_t open, Piece& piece) {
    const std::size_t end = behind_bracket(tokens, open);
    piece.kind = contains(tokens.subspan(end), "{") ? Kind::function : Kind::prototype;
    piece.names = {tokens[open - 1]};
    add_variables(tokens.subspan(end), piece);
    const Tokens list = tokens.subspan(open + 1, end - open - 2);
    std::vector<std::string> parameters;
    add_declared(list, parameters);
    for (const std::string& token : list) {
        if (!is_name(token)) continue;
        piece.parameter_types.push_back(token);
    }
    for (const std::string& name : parameters) {
        const bool only_once = std::ranges::count(list, name) == 1;
        const auto at = std::ranges::find(list, name) - list.begin();
        const bool has_type = at > 0 && (is_name(list[static_cast<std::size_t>(at) - 1]) ||
                                         list[static_cast<std::size_t>(at) - 1] == "]");
        if (only_once && has_type) piece.mentions.erase(name);
    }
}

constexpr std::array<std::string_view, 6> storage{"uniform", "buffer", "in", "out", "attribute", "varying"};

// Qualifiers up to the name of the block or the type of the variable.
bool is_interface(Tokens head) {
    for (std::size_t i = 0; i < head.size();) {
        if (head[i] == "=") break;
        if (std::ranges::find(storage, head[i]) != storage.end()) return true;
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
    if (open > 0 && is_name(tokens[open - 1])) piece.names.push_back(tokens[open - 1]);
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
    constexpr std::array<std::string_view, 3> statements{"precision", "invariant", ";"};
    if (std::ranges::find(statements, tokens.front()) != statements.end()) return true;
    if (tokens.front() != "layout" || tokens.size() < 3) return false;
    const Tokens rest = tokens.subspan(behind_bracket(tokens, 1));
    return std::ranges::all_of(rest, [](const std::string& token) {
        return token == ";" || std::ranges::find(storage, token) != storage.end();
    });
}

}  // namespace

bool is_macro_call(Tokens tokens) {
    if (tokens.size() < 3 || !is_name(tokens[0]) || tokens[0] == "layout" || tokens[1] != "(") return false;
    const std::size_t end = behind_bracket(tokens, 1);
    return end == tokens.size() || tokens[end] == "{" || tokens[end] == ";";
}

Piece piece_of(std::string_view code) {
    const std::vector<std::string> all = tokens_of(code);
    Piece piece;
    if (all.empty()) return piece;
    add_mentions(all, piece);
    const Tokens tokens = Tokens(all).subspan(behind_macro_lines(all));
    if (is_macro_call(tokens)) {
        piece.by_macro = true;
        return piece;
    }
    if (declares_nothing(tokens)) {
        piece.kind = tokens.front() == "layout" ? Kind::interface : Kind::other;
        return piece;
    }
    const auto brace = static_cast<std::size_t>(std::ranges::find(tokens, "{") - tokens.begin());
    const auto equals = static_cast<std::size_t>(std::ranges::find(tokens, "=") - tokens.begin());
    if (const auto open = parameter_list(tokens)) {
        take_function(tokens, *open, piece);
    } else if (brace < tokens.size() && !(equals < brace && !is_interface(tokens.first(brace)))) {
        take_braces(tokens, brace, piece);
    } else {
        piece.kind = is_interface(tokens) ? Kind::interface : Kind::variable;
        add_declared(tokens, piece.names);
    }
    return piece;
}

Piece macro_of(const Directive& directive) {
    Piece piece;
    if (directive.keyword != "define" && directive.keyword != "undef") return piece;
    std::string text = directive.argument;
    std::ranges::replace(text, '\n', ' ');
    const std::vector<std::string> tokens = tokens_of(text);
    if (tokens.empty()) return piece;
    piece.kind = Kind::macro;
    piece.names = {tokens.front()};
    add_mentions(Tokens(tokens).subspan(1), piece);
    return piece;
}

}  // namespace gloam::shader::internal
