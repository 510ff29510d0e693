// SPDX-License-Identifier: MIT
// Where variables are declared.
#include <algorithm>

#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

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

}  // namespace gloam::shader::internal::wgsl
