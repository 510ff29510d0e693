// SPDX-License-Identifier: MIT
#include <algorithm>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

// Where variables are declared.
namespace gloam::shader::internal::wgsl {
namespace {

bool mentions(const std::string& text, Id variable) {
    return text.find(mark(variable)) != std::string::npos;
}

// In the statement itself, not in those inside it.
bool mentions_itself(const Statement& s, Id variable) {
    return s.target == variable || mentions(s.text, variable) || mentions(s.value, variable);
}

bool mentions(const Statements& list, Id variable);

bool mentions(const Statement& s, Id variable) {
    return mentions_itself(s, variable) ||
           std::ranges::any_of(s.lists, [&](const Statements& list) { return mentions(list, variable); });
}

bool mentions(const Statements& list, Id variable) {
    return std::ranges::any_of(list, [&](const Statement& s) { return mentions(s, variable); });
}

int writes_to(const Statements& list, Id variable) {
    int count = 0;
    for (const Statement& s : list) {
        count += s.target == variable ? 1 : 0;
        for (const Statements& inner : s.lists) count += writes_to(inner, variable);
    }
    return count;
}

// What happens first to a variable on each way through statements.
enum class First {
    nothing,  // on some way nothing, on none a read
    read,
    set,  // as a whole, or the way ends
};

First first_in(const Statements& list, Id variable);

// Of ways of which one is taken.
First any_of(const std::vector<Statements>& lists, Id variable) {
    bool all_set = !lists.empty();
    for (const Statements& list : lists) {
        const First first = first_in(list, variable);
        if (first == First::read) return First::read;
        all_set = all_set && first == First::set;
    }
    return all_set ? First::set : First::nothing;
}

First first_in_loop(const Statement& s, Id variable) {
    const First body = first_in(s.lists[0], variable);
    if (body == First::read) return First::read;
    if (body == First::nothing && (mentions(s.lists[1], variable) || mentions(s.text, variable)))
        return First::read;
    return body == First::set && s.value.empty() ? First::set : First::nothing;
}

First first_in(const Statements& list, Id variable) {
    for (const Statement& s : list) {
        if (mentions(s.value, variable) || mentions(s.text, variable)) return First::read;
        if (s.target == variable) return First::set;
        First first = First::nothing;
        if (s.kind == StatementKind::leave || s.kind == StatementKind::next || s.kind == StatementKind::give)
            return First::set;
        if (s.kind == StatementKind::condition || s.kind == StatementKind::choice)
            first = any_of(s.lists, variable);
        if (s.kind == StatementKind::loop) first = first_in_loop(s, variable);
        if (first != First::nothing) return first;
    }
    return First::nothing;
}

struct Place {
    Statements* list = nullptr;
    std::size_t at = 0;
};

// The innermost list with all uses, and the first of them.
Place innermost(Statements& list, Id variable, bool may_enter_loops) {
    Place place{&list, 0};
    while (true) {
        Statements& here = *place.list;
        const auto first =
            std::ranges::find_if(here, [&](const Statement& s) { return mentions(s, variable); });
        if (first == here.end()) return {};
        place.at = static_cast<std::size_t>(first - here.begin());
        const bool alone =
            std::none_of(first + 1, here.end(), [&](const Statement& s) { return mentions(s, variable); });
        if (!alone || mentions_itself(*first, variable)) return place;
        if (first->kind == StatementKind::loop && !may_enter_loops) return place;
        Statements* inner = nullptr;
        for (Statements& candidate : first->lists) {
            if (!mentions(candidate, variable)) continue;
            if (inner != nullptr) return place;
            inner = &candidate;
        }
        place.list = inner;
    }
}

void declare(FunctionBody& body, Id variable) {
    const bool has_initial = body.initial.contains(variable);
    const int writes = writes_to(body.statements, variable);
    const bool changes = writes > 0 || body.addressed.contains(variable);
    Place place = innermost(body.statements, variable, !(has_initial && changes));
    if (place.list == nullptr) return;
    // A variable of an inner loop must not bring a value from one round to the next.
    if (!has_initial && first_in(*place.list, variable) == First::read)
        place = innermost(body.statements, variable, false);
    Statement& first = (*place.list)[place.at];
    if (first.target != variable || mentions(first.value, variable) || has_initial) {
        first.declares.push_back(variable);
        if (!has_initial && !body.types.contains(variable))
            throw NotTranslated("a variable of a type without a name that is set on several ways");
        return;
    }
    first.keyword = writes == 1 && !body.addressed.contains(variable) ? "let" : "var";
    const std::size_t next = place.at + 1;
    if (next >= place.list->size()) return;
    const Statement& loop = (*place.list)[next];
    const bool only_there =
        std::none_of(place.list->begin() + static_cast<std::ptrdiff_t>(next) + 1, place.list->end(),
                     [&](const Statement& s) { return mentions(s, variable); });
    first.heads_loop = only_there && first.keyword == "var" && loop.kind == StatementKind::loop &&
                       !loop.value.empty() && loop.text.empty() && loop.lists[1].size() == 1 &&
                       loop.lists[1][0].target == variable;
}

void collect(const Statements& list, std::vector<Id>& variables, std::set<Id>& seen) {
    const auto add = [&](Id id) {
        if (id != 0 && seen.insert(id).second) variables.push_back(id);
    };
    for (const Statement& s : list) {
        for (const Id id : marks_in(s.text)) add(id);
        for (const Id id : marks_in(s.value)) add(id);
        add(s.target);
        for (const Statements& inner : s.lists) collect(inner, variables, seen);
    }
}

// Gives the variables names, list by list.
class Namer {
  public:
    Namer(const FunctionBody& body, const std::set<std::string>& taken) : body_(body), taken_(taken) {}

    void take(Id variable, std::set<std::string>& scope) {
        const auto known = body_.wanted_names.find(variable);
        const std::string wanted = known == body_.wanted_names.end() ? "t" : known->second;
        std::string name = wanted;
        for (int i = 2; taken_.contains(name) || scope.contains(name); ++i)
            name = wanted + "_" + std::to_string(i);
        scope.insert(name);
        names[variable] = name;
    }

    void run(const Statements& list, std::set<std::string> scope) {
        std::string of_loop;
        for (const Statement& s : list) {
            for (const Id variable : s.declares) take(variable, scope);
            if (!s.keyword.empty()) take(s.target, scope);
            for (const Statements& inner : s.lists) run(inner, scope);
            if (!of_loop.empty()) scope.erase(of_loop);
            of_loop = s.heads_loop ? names[s.target] : "";
        }
    }

    std::map<Id, std::string> names;

  private:
    const FunctionBody& body_;
    const std::set<std::string>& taken_;
};

}  // namespace

void declare_variables(FunctionBody& body, const std::set<Id>& parameters) {
    std::vector<Id> variables;
    std::set<Id> seen = parameters;
    collect(body.statements, variables, seen);
    for (const Id variable : variables) declare(body, variable);
}

std::map<Id, std::string> choose_names(const FunctionBody& body, const std::vector<Id>& parameters,
                                       const std::set<std::string>& taken) {
    Namer namer(body, taken);
    std::set<std::string> scope;
    for (const Id parameter : parameters) namer.take(parameter, scope);
    namer.run(body.statements, scope);
    return namer.names;
}

// Values: written where they are used, or as variables.

std::string mark(Id variable) {
    return "\x01" + std::to_string(variable) + "\x02";
}

std::vector<Id> marks_in(const std::string& text) {
    std::vector<Id> found;
    for (std::size_t at = text.find('\x01'); at != std::string::npos; at = text.find('\x01', at + 1))
        found.push_back(static_cast<Id>(std::stoul(text.substr(at + 1, text.find('\x02', at) - at - 1))));
    return found;
}

FunctionBody body_of(ModuleText& text, const Function& function) {
    for (std::set<Id> kept;;) {
        try {
            return FunctionWriter(text, function, kept).run();
        } catch (const ChangedIndex& changed) {
            if (!kept.insert(changed.chain).second) throw;
        }
    }
}

FunctionWriter::FunctionWriter(ModuleText& text, const Function& function, const std::set<Id>& kept_indices)
    : kept_indices_(kept_indices),
      text_(text),
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
        if (chain_uses_[chain] > 0 && reads.contains(variable)) throw ChangedIndex(chain);
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
