// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/expressions.hpp"

#include <algorithm>
#include <map>

namespace gloam::shader::internal::wgsl {
namespace {

struct Binding {
    Level level;
    Level left;  // the loosest operands that need no brackets
    Level right;
};

Binding binding_of(const std::string& operation) {
    static const std::map<std::string, Binding> bindings{
        {"*", {Level::product, Level::product, Level::unary}},
        {"/", {Level::product, Level::product, Level::unary}},
        {"%", {Level::product, Level::product, Level::unary}},
        {"+", {Level::sum, Level::sum, Level::product}},
        {"-", {Level::sum, Level::sum, Level::product}},
        {"<<", {Level::bits, Level::unary, Level::unary}},
        {">>", {Level::bits, Level::unary, Level::unary}},
        {"&", {Level::bits, Level::unary, Level::unary}},
        {"|", {Level::bits, Level::unary, Level::unary}},
        {"^", {Level::bits, Level::unary, Level::unary}},
        {"&&", {Level::logic, Level::relation, Level::relation}},
        {"||", {Level::logic, Level::relation, Level::relation}},
    };
    const auto found = bindings.find(operation);
    return found != bindings.end() ? found->second : Binding{Level::relation, Level::sum, Level::sum};
}

bool chains(const std::string& operation) {
    return operation == "&" || operation == "|" || operation == "^" || operation == "&&" || operation == "||";
}

std::string part(const Expression& a, Level loosest, const std::string& operation) {
    const bool chain = chains(operation) && a.operation == operation;
    return a.level <= loosest || chain ? a.text : "(" + a.text + ")";
}

}  // namespace

Expression plain(std::string text) {
    return {.text = std::move(text)};
}

Expression typed(Expression a) {
    if (!a.literal) return a;
    a.text = a.typed;
    a.literal = false;
    return a;
}

Expression binary(const std::string& operation, const Expression& a, const Expression& b) {
    if (a.literal && b.literal) return binary(operation, typed(a), typed(b));
    const Binding binding = binding_of(operation);
    Expression result{
        .text = part(a, binding.left, operation) + " " + operation + " " + part(b, binding.right, ""),
        .level = binding.level,
        .operation = chains(operation) ? operation : ""};
    result.reads = a.reads;
    result.reads.insert(b.reads.begin(), b.reads.end());
    return result;
}

Expression unary(const std::string& operation, const Expression& a) {
    const Expression b = typed(a);
    Expression result{.text = operation + (b.level == Level::primary ? b.text : "(" + b.text + ")"),
                      .level = Level::unary,
                      .reads = b.reads};
    return result;
}

std::string primary(const Expression& a) {
    return a.level == Level::primary ? a.text : "(" + a.text + ")";
}

Expression call(const std::string& function, std::vector<Expression> arguments) {
    const bool constant = std::ranges::all_of(arguments, &Expression::literal);
    const bool constructor = function.starts_with("vec") || function.starts_with("mat");
    Expression result;
    std::string list;
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        Expression& a = arguments[k];
        if (constant && !constructor) a = typed(a);
        // `f(a < b, c > d)` would be read as a list of types.
        const bool looks_like_types =
            a.level == Level::relation && a.text.find(" < ") != std::string::npos &&
            std::any_of(arguments.begin() + static_cast<std::ptrdiff_t>(k) + 1, arguments.end(),
                        [](const Expression& later) { return later.text.find('>') != std::string::npos; });
        list += (list.empty() ? "" : ", ") + (looks_like_types ? "(" + a.text + ")" : a.text);
        result.reads.insert(a.reads.begin(), a.reads.end());
    }
    result.text = function + "(" + list + ")";
    return result;
}

}  // namespace gloam::shader::internal::wgsl
