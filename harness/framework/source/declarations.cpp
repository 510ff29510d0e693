// SPDX-License-Identifier: MIT
#include "source/declarations.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace gloam::source {
namespace {

using Kind = Declaration::Kind;

// The first parenthesis that starts a list of parameters; they follow a type and a name.
std::optional<std::size_t> parameter_list(Tokens tokens) {
    for (std::size_t i = 0; i < tokens.size() && tokens[i] != "=" && tokens[i] != "{";
         i = behind(tokens, i)) {
        if (tokens[i] != "(" || (i > 0 && tokens[i - 1] == "layout")) continue;
        return i >= 2 ? std::optional(i) : std::nullopt;
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
        const std::size_t end = tokens[i] == "[" ? behind(tokens, i) : i + 1;
        if (tokens[i] == "[")
            (parameter.name.empty() ? type_sizes : name_sizes).append(joined(tokens.subspan(i, end - i), ""));
        else if (tokens[i].is_word() && !is_qualifier(tokens[i]))
            (type.empty() ? type : parameter.name) = tokens[i].text;
        i = end;
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
        while (end < tokens.size() && tokens[end] != ",") end = behind(tokens, end);
        parameters.push_back(parameter_of(tokens.subspan(first, end - first)));
        first = end + 1;
    }
    return parameters;
}

std::optional<FunctionHead> function_of(Tokens tokens) {
    const auto open = parameter_list(tokens);
    if (!open) return std::nullopt;
    const std::size_t body = behind(tokens, *open);
    return FunctionHead{.name = tokens[*open - 1].text,
                        .result = joined(tokens.first(*open - 1), " "),
                        .text = joined(tokens.first(body), " "),
                        .parameters = parameters_of(tokens.subspan(*open + 1, body - *open - 2)),
                        .defined = contains(tokens.subspan(body), "{"),
                        .list = *open + 1,
                        .body = body};
}

// Where a declaration begins: behind macros that are called without a ';', as in "INFO(name) float f(float
// x)".
std::size_t behind_macro_lines(Tokens tokens) {
    std::size_t first = 0;
    while (first + 2 < tokens.size() && tokens[first].is_word() && tokens[first] != "layout" &&
           tokens[first + 1] == "(") {
        const std::size_t end = behind(tokens, first + 1);
        if (end >= tokens.size() || !tokens[end].is_word()) break;
        first = end;
    }
    return first;
}

// The declared names of "a, b[2], c = f(1)": each the last name outside brackets, before a '=' or the end.
void add_declared(Tokens list, std::vector<std::string>& names) {
    std::string last;
    bool named = false;
    const auto add = [&] {
        if (!last.empty()) names.push_back(std::exchange(last, {}));
        named = false;
    };
    for (std::size_t i = 0; i < list.size(); i = behind(list, i)) {
        if (list[i] == "=") named = !last.empty();
        if (list[i] == "," || list[i] == ";") add();
        if (!named && list[i].is_word()) last = list[i].text;
    }
    add();
}

// Whether a token is a name, and no member of what stands before it.
bool is_own_name(Tokens tokens, std::size_t i) {
    return tokens[i].is_word() && (i == 0 || tokens[i - 1] != ".");
}

std::set<std::string> mentions_in(Tokens tokens) {
    std::set<std::string> mentions;
    for (std::size_t i = 0; i < tokens.size(); ++i)
        if (is_own_name(tokens, i)) mentions.insert(tokens[i].text);
    return mentions;
}

// Names that are assigned to, indexed or read, and never called: no function of that name is meant.
std::set<std::string> variables_in(Tokens tokens) {
    std::set<std::string> variables;
    std::set<std::string> called;
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
        if (!is_own_name(tokens, i)) continue;
        const Token& next = tokens[i + 1];
        if (next == "(") called.insert(tokens[i].text);
        // A macro may take the name of a function.
        if (next != "(" && next != ")" && next != ",") variables.insert(tokens[i].text);
    }
    std::erase_if(variables, [&](const std::string& name) { return called.contains(name); });
    return variables;
}

// A name of a parameter hides what has it at file scope.
void take_function(Tokens tokens, FunctionHead function, Declaration& to) {
    to.kind = function.defined ? Kind::function : Kind::prototype;
    to.names = {function.name};
    to.variables = variables_in(tokens.subspan(function.body));
    const Tokens list = tokens.subspan(function.list, function.body - 1 - function.list);
    for (const DeclaredParameter& parameter : function.parameters)
        if (std::ranges::count(list, parameter.name, &Token::text) == 1) to.mentions.erase(parameter.name);
    to.function = std::move(function);
}

bool is_storage(const Token& token) {
    constexpr std::array words{"uniform", "buffer", "in", "out", "attribute", "varying"};
    return std::ranges::find(words, token.text) != words.end();
}

// Qualifiers up to the name of the block or the type of the variable.
bool is_interface(Tokens head) {
    for (std::size_t i = 0; i < head.size() && head[i] != "=";) {
        if (is_storage(head[i])) return true;
        const bool layout = head[i] == "layout" && i + 1 < head.size() && head[i + 1] == "(";
        const std::size_t end = layout ? behind(head, i + 1) : i + 1;
        if (layout && contains(head.subspan(i, end - i), "constant_id")) return true;
        i = end;
    }
    return false;
}

// "struct Name { ... } variables;" and "uniform Name { ... } instance;".
void take_braces(Tokens tokens, std::size_t open, Declaration& to) {
    const std::size_t end = behind(tokens, open);
    if (open > 0 && tokens[open - 1].is_word()) to.names.push_back(tokens[open - 1].text);
    const std::size_t declared = to.names.size();
    add_declared(tokens.subspan(end), to.names);
    to.kind = is_interface(tokens.first(open)) ? Kind::interface
              : declared < to.names.size()     ? Kind::variable
                                               : Kind::structure;
    const bool block = !contains(tokens.first(open), "struct");
    if (block && declared == to.names.size() && end > open + 1)
        add_declared(tokens.subspan(open + 1, end - open - 2), to.names);
}

// Nothing of "layout(local_size_x = 8) in;", "precision highp float;", "invariant gl_Position;" has a name.
bool declares_nothing(Tokens tokens) {
    if (tokens[0] == "precision" || tokens[0] == "invariant" || tokens[0] == ";") return true;
    if (tokens[0] != "layout" || tokens.size() < 3) return false;
    return std::ranges::all_of(tokens.subspan(behind(tokens, 1)),
                               [](const Token& token) { return token == ";" || is_storage(token); });
}

void take(Tokens tokens, Declaration& to) {
    to.by_macro = is_macro_call(tokens);
    if (to.by_macro) return;
    if (declares_nothing(tokens)) {
        to.kind = tokens[0] == "layout" ? Kind::interface : Kind::other;
        return;
    }
    const Tokens head = up_to(tokens, "{");
    if (auto function = function_of(tokens)) {
        take_function(tokens, std::move(*function), to);
    } else if (head.size() < tokens.size() && (!contains(head, "=") || is_interface(head))) {
        take_braces(tokens, head.size(), to);
    } else {
        to.kind = is_interface(tokens) ? Kind::interface : Kind::variable;
        add_declared(tokens, to.names);
    }
}

// Whether both have the same name and parameter types, and so declare one function.
bool declare_the_same(const FunctionHead& a, const FunctionHead& b) {
    return a.name == b.name && std::ranges::equal(a.parameters, b.parameters, {}, &DeclaredParameter::type,
                                                  &DeclaredParameter::type);
}

}  // namespace

bool Declaration::defines(const std::string& name) const {
    return kind == Kind::function && names.front() == name;
}

Tokens Declaration::parameter_list() const {
    return Tokens(tokens).subspan(function->list, function->body - 1 - function->list);
}

bool is_macro_call(Tokens tokens) {
    if (tokens.size() < 3 || !tokens[0].is_word() || tokens[0] == "layout" || tokens[1] != "(") return false;
    const std::size_t end = behind(tokens, 1);
    return end == tokens.size() || tokens[end] == "{" || tokens[end] == ";";
}

Declaration declaration_of(std::vector<Token> tokens) {
    Declaration one;
    if (tokens.empty()) return one;
    one.mentions = mentions_in(tokens);
    tokens.erase(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(behind_macro_lines(tokens)));
    take(tokens, one);
    one.tokens = std::move(tokens);
    return one;
}

Declaration macro_of(const Directive& directive) {
    Declaration macro;
    if (directive.keyword != "define" && directive.keyword != "undef") return macro;
    std::string text = directive.argument;
    std::ranges::replace(text, '\n', ' ');
    const std::vector<Token> tokens = tokens_of(text);
    if (tokens.empty()) return macro;
    macro.kind = Kind::macro;
    macro.names = {tokens.front().text};
    macro.mentions = mentions_in(Tokens(tokens).subspan(1));
    return macro;
}

std::vector<FunctionHead> function_heads(std::string preprocessed) {
    std::vector<FunctionHead> heads;
    for (Declaration& one : outline(whole_text(std::move(preprocessed)), Keep::line_numbers).declarations)
        if (one.function) heads.push_back(std::move(*one.function));
    return heads;
}

std::vector<FunctionHead> each_once(std::vector<FunctionHead> functions) {
    std::stable_partition(functions.begin(), functions.end(),  // clang 14 cannot read that of std::ranges
                          [](const FunctionHead& one) { return one.defined; });
    std::vector<FunctionHead> once;
    for (FunctionHead& function : functions) {
        const auto is_same = [&](const FunctionHead& other) { return declare_the_same(other, function); };
        if (function.defined || std::ranges::none_of(once, is_same)) once.push_back(std::move(function));
    }
    return once;
}

std::string completed(std::string text, const std::vector<FunctionHead>& functions) {
    text += "\n";
    for (const FunctionHead& function : each_once(functions)) {
        if (function.defined) continue;
        const bool has_result = function.result != "void";
        text += function.text +
                (has_result ? " { " + function.result + " gloam_result; return gloam_result; }\n" : " { }\n");
    }
    if (std::ranges::find(functions, "main", &FunctionHead::name) == functions.end())
        text += "void main() { }\n";
    return text;
}

}  // namespace gloam::source
