// SPDX-License-Identifier: MIT
// Values: written where they are used, or as variables.
#include <algorithm>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

std::string mark(Id variable) {
    return "\x01" + std::to_string(variable) + "\x02";
}

std::vector<Id> marks_in(const std::string& text) {
    std::vector<Id> found;
    for (std::size_t at = text.find('\x01'); at != std::string::npos; at = text.find('\x01', at + 1))
        found.push_back(static_cast<Id>(std::stoul(text.substr(at + 1, text.find('\x02', at) - at - 1))));
    return found;
}

FunctionWriter::FunctionWriter(ModuleText& text, const Function& function)
    : text_(text),
      module_(text.module()),
      facts_(text.facts()),
      function_(function),
      shape_(shape_of(module_, facts_, function)) {
    for (const Variable& variable : function.variables) {
        const std::string name = module_.name_of(variable.id);
        body_.wanted_names[variable.id] = identifier(name.empty() ? "t" : name);
        body_.types[variable.id] = text.type(variable.type);
        if (variable.initial != 0) body_.initial[variable.id] = text.constant(variable.initial).text;
    }
    for (const Id parameter : function.parameters)
        if (module_.value_type(parameter).kind != TypeKind::pointer)
            values_[parameter] = {.text = mark(parameter)};
    const std::vector<Passing>& passing = facts_.of(function.id).passing;
    for (std::size_t p = 0; p < passing.size(); ++p)
        if (passing[p] == Passing::copied)
            body_.types[function.parameters[p]] = text.type(module_.pointee(function.parameters[p]));
}

FunctionBody FunctionWriter::run() {
    region(function_.first(), {}, body_.statements);
    Statements& all = body_.statements;
    if (!all.empty() && all.back().kind == StatementKind::give && all.back().value.empty()) all.pop_back();
    return std::move(body_);
}

Id FunctionWriter::same(Id variable) const {
    const auto found = shape_.same.find(variable);
    return found == shape_.same.end() ? variable : found->second;
}

Expression FunctionWriter::take(Id value) {
    if (module_.constant(value) != nullptr) return text_.constant(value);
    const auto found = values_.find(value);
    if (found == values_.end()) throw NotTranslated("a value that is used before it is known");
    if (--left_[value] <= 0) std::erase(pending_, value);
    return found->second;
}

// A value that is calculated here.
void FunctionWriter::define(Id result, Expression expression, Statements& out) {
    const int uses = shape_.uses[result];
    values_[result] = expression;
    if (uses == 0) return;
    const bool name =
        expression.level == Level::primary && expression.text.find_first_of("([") == std::string::npos;
    if (name && expression.reads.empty()) return;
    const bool here = shape_.home[result] == shape_.defined_in[result] && (uses == 1 || name);
    left_[result] = uses;
    if (here) {
        pending_.push_back(result);
    } else {
        keep(result, expression, out);
    }
}

// Writes the value as a variable of its own.
void FunctionWriter::keep(Id result, const Expression& expression, Statements& out) {
    const std::string name = module_.name_of(result);
    body_.wanted_names[result] = identifier(name.empty() ? "t" : name);
    if (!member_names_.contains(result) && !body_.types.contains(result))
        body_.types[result] = text_.type(module_.type_of(result));
    out.push_back({.kind = StatementKind::assign, .target = result, .value = expression.text});
    values_[result] = {.text = mark(result)};
    std::erase(pending_, result);
}

// Values that read the variable must be calculated before it changes.
void FunctionWriter::before_change(Id variable, Statements& out) {
    for (const auto& [chain, reads] : chain_reads_)
        if (chain_uses_[chain] > 0 && reads.contains(variable))
            throw NotTranslated("an index that changes before the element is used");
    const std::vector<Id> pending = pending_;
    for (const Id value : pending)
        if (entry_of(values_, value, "a value that is used before it is known").reads.contains(variable))
            keep(value, entry_of(values_, value, "a value that is used before it is known"), out);
}

void FunctionWriter::keep_all(Statements& out) {
    const std::vector<Id> pending = pending_;
    for (const Id value : pending)
        keep(value, entry_of(values_, value, "a value that is used before it is known"), out);
}

namespace {

// Whether all ways through the statement end with setting the variable.
bool ends_with(const Statement& s, Id variable) {
    if (s.kind == StatementKind::assign) return s.target == variable;
    if (s.kind != StatementKind::condition) return false;
    return std::ranges::all_of(s.lists, [&](const Statements& list) {
        return !list.empty() && (ends_with(list.back(), variable) || list.back().kind == StatementKind::give);
    });
}

// Sets `to` where the statement sets the variable, or returns the value where `to` is 0.
void redirect(Statement& s, Id variable, Id to) {
    if (s.kind == StatementKind::assign && s.target == variable) {
        s.target = to;
        if (to == 0) s.kind = StatementKind::give;
        return;
    }
    if (s.kind != StatementKind::condition) return;
    for (Statements& list : s.lists)
        if (!list.empty()) redirect(list.back(), variable, to);
}

// The statement before, if it only calculates what the mark stands for: its value, taken away.
std::string taken_from(Statements& out, const std::string& value, bool once) {
    if (!once || out.empty() || out.back().kind != StatementKind::assign) return value;
    if (out.back().target == 0 || value != mark(out.back().target)) return value;
    const std::string text = out.back().value;
    out.pop_back();
    return text;
}

}  // namespace

void FunctionWriter::assign(Id variable, const Expression& value, Statements& out) {
    before_change(variable, out);
    const bool is_variable =
        std::ranges::find(function_.variables, variable, &Variable::id) != function_.variables.end();
    if (is_variable && facts_.uses_of(variable).changes == 1 && !body_.initial.contains(variable))
        set_once_.insert(variable);
    if (!body_.wanted_names.contains(variable)) {
        const std::string name = module_.name_of(variable);
        body_.wanted_names[variable] = identifier(name.empty() ? "t" : name);
        body_.types[variable] = text_.type(module_.type_of(variable));
    }
    if (from_choice(value, variable, out)) return;
    const std::vector<Id> marks = marks_in(value.text);
    const bool once = marks.size() == 1 && shape_.uses[marks[0]] == 1;
    const std::string text = taken_from(out, value.text, once);
    out.push_back({.kind = StatementKind::assign, .target = variable, .value = text});
}

// Where the value is a variable without a name that the branches of the statement before have set for this:
// they set the other variable, or return.
bool FunctionWriter::from_choice(const Expression& value, Id to, Statements& out) {
    const std::vector<Id> marks = marks_in(value.text);
    if (marks.size() != 1 || value.text != mark(marks[0]) || out.empty()) return false;
    const Id from = marks[0];
    if (std::ranges::find(function_.variables, from, &Variable::id) == function_.variables.end())
        return false;
    if (!module_.name_of(from).empty() || facts_.uses_of(from).loads != 1) return false;
    if (out.back().kind != StatementKind::condition || !ends_with(out.back(), from)) return false;
    redirect(out.back(), from, to);
    return true;
}

void FunctionWriter::give(const Expression& value, Statements& out) {
    if (from_choice(value, 0, out)) return;
    const std::vector<Id> marks = marks_in(value.text);
    const bool once = marks.size() == 1 && shape_.uses[marks[0]] == 1;
    out.push_back({.kind = StatementKind::give, .value = taken_from(out, value.text, once)});
}

}  // namespace gloam::shader::internal::wgsl
