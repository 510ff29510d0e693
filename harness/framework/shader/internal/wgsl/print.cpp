// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cctype>

#include "shader/internal/wgsl/function_writer.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

constexpr std::size_t columns = 120;

class Printer {
  public:
    Printer(const FunctionBody& body, const std::map<Id, std::string>& names) : body_(body), names_(names) {}

    std::string run() {
        list(body_.statements, 1);
        return text_;
    }

  private:
    void line(int depth, const std::string& text) {
        text_ +=
            broken(std::string(4 * static_cast<std::size_t>(depth), ' ') + with_names(text, names_)) + "\n";
    }

    void declarations(const Statement& s, int depth) {
        for (const Id variable : s.declares) {
            const auto initial = body_.initial.find(variable);
            line(depth, initial == body_.initial.end()
                            ? fmt::format("var {}: {};", mark(variable),
                                          entry_of(body_.types, variable, "a variable without a type"))
                            : fmt::format("var {} = {};", mark(variable), initial->second));
        }
    }

    void list(const Statements& statements, int depth) {
        for (std::size_t k = 0; k < statements.size(); ++k) {
            const Statement& s = statements[k];
            declarations(s, depth);
            if (s.heads_loop) {
                declarations(statements[k + 1], depth);
                loop(statements[k + 1], depth, assignment(s));
                ++k;
            } else {
                statement(s, depth);
            }
        }
    }

    static std::string assignment(const Statement& s) {
        const std::string target = s.target != 0 ? mark(s.target) : s.text;
        const std::string keyword = s.keyword.empty() ? "" : s.keyword + " ";
        // `x = x + y` is shorter as `x += y`.
        const std::string start = target + " ";
        const bool itself = s.keyword.empty() && s.value.starts_with(start) &&
                            s.value.size() > start.size() + 2 &&
                            std::string("+-*").find(s.value[start.size()]) != std::string::npos &&
                            s.value[start.size() + 1] == ' ' &&
                            one_term(s.value.substr(start.size() + 2), s.value[start.size()]);
        if (itself)
            return fmt::format("{} {}= {}", target, s.value[start.size()], s.value.substr(start.size() + 2));
        return fmt::format("{}{} = {}", keyword, target, s.value);
    }

    // Whether the rest of an expression is one operand of the operation in front of it.
    static bool one_term(const std::string& rest, char operation) {
        int depth = 0;
        for (std::size_t k = 0; k < rest.size(); ++k) {
            if (rest[k] == '(' || rest[k] == '[') ++depth;
            if (rest[k] == ')' || rest[k] == ']') --depth;
            if (depth > 0 || rest[k] != ' ') continue;
            const char next = rest[k + 1];
            const bool product = next == '*' || next == '/' || next == '%';
            if (operation == '*' || !(product && rest[k + 2] == ' ')) {
                // An operator of sums, or any operator behind a product.
                if (next == '+' || next == '-' || operation == '*') return false;
            }
        }
        return true;
    }

    void statement(const Statement& s, int depth) {
        switch (s.kind) {
            case StatementKind::assign:
                return line(depth, assignment(s) + ";");
            case StatementKind::expression:
                return line(depth, s.value + ";");
            case StatementKind::condition:
                return condition(s, depth, "if");
            case StatementKind::loop:
                return loop(s, depth, "");
            case StatementKind::choice:
                return choice(s, depth);
            case StatementKind::leave:
                return line(depth, "break;");
            case StatementKind::next:
                return line(depth, "continue;");
            case StatementKind::give:
                return line(depth, s.value.empty() ? "return;" : "return " + s.value + ";");
        }
    }

    void condition(const Statement& s, int depth, const std::string& keyword) {
        const bool only_else = s.lists[0].empty() && !s.lists[1].empty();
        if (s.lists[0].empty() && s.lists[1].empty()) return;
        line(depth, fmt::format("{} ({}) {{", keyword, only_else ? "!(" + s.value + ")" : s.value));
        list(s.lists[only_else ? 1 : 0], depth + 1);
        if (!only_else && !s.lists[1].empty()) {
            const Statements& other = s.lists[1];
            if (other.size() == 1 && other[0].kind == StatementKind::condition && other[0].declares.empty() &&
                !(other[0].lists[0].empty() && other[0].lists[1].empty()))
                return condition(other[0], depth, "} else if");
            line(depth, "} else {");
            list(other, depth + 1);
        }
        line(depth, "}");
    }

    void loop(const Statement& s, int depth, const std::string& initial) {
        const Statements& after = s.lists[1];
        const bool one = after.size() == 1 && after[0].kind == StatementKind::assign &&
                         after[0].declares.empty() && after[0].keyword.empty() && s.text.empty();
        if (!s.value.empty() && after.empty() && s.text.empty()) {
            line(depth, fmt::format("while ({}) {{", s.value));
            list(s.lists[0], depth + 1);
            return line(depth, "}");
        }
        if (!s.value.empty() && one) {
            line(depth, fmt::format("for ({}; {}; {}) {{", initial, s.value, assignment(after[0])));
            list(s.lists[0], depth + 1);
            return line(depth, "}");
        }
        line(depth, "loop {");
        if (!s.value.empty()) line(depth + 1, fmt::format("if (!({})) {{ break; }}", s.value));
        list(s.lists[0], depth + 1);
        if (!after.empty() || !s.text.empty()) {
            line(depth + 1, "continuing {");
            list(after, depth + 2);
            if (!s.text.empty()) line(depth + 2, fmt::format("break if {};", s.text));
            line(depth + 1, "}");
        }
        line(depth, "}");
    }

    void choice(const Statement& s, int depth) {
        line(depth, fmt::format("switch ({}) {{", s.value));
        for (std::size_t k = 0; k < s.lists.size(); ++k) {
            const std::string& label = s.labels[k];
            line(depth + 1, label == "default" ? "default: {" : fmt::format("case {}: {{", label));
            list(s.lists[k], depth + 2);
            line(depth + 1, "}");
        }
        line(depth, "}");
    }

    const FunctionBody& body_;
    const std::map<Id, std::string>& names_;
    std::string text_;
};

void add_identifiers(const std::string& text, std::set<std::string>& found) {
    for (std::size_t at = 0; at < text.size();) {
        const auto is_word = [&](std::size_t k) {
            return k < text.size() &&
                   (std::isalnum(static_cast<unsigned char>(text[k])) != 0 || text[k] == '_');
        };
        if (!is_word(at)) {
            ++at;
            continue;
        }
        std::size_t end = at;
        while (is_word(end)) ++end;
        const bool member = at > 0 && text[at - 1] == '.';
        if (!member && std::isdigit(static_cast<unsigned char>(text[at])) == 0)
            found.insert(text.substr(at, end - at));
        at = end;
    }
}

}  // namespace

std::set<std::string> identifiers_in(const Statements& statements) {
    std::set<std::string> found;
    for (const Statement& s : statements) {
        add_identifiers(s.text, found);
        add_identifiers(s.value, found);
        for (const Statements& inner : s.lists) found.merge(identifiers_in(inner));
    }
    return found;
}

std::string with_names(const std::string& text, const std::map<Id, std::string>& names) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (text[at] != '\x01') {
            result += text[at];
            continue;
        }
        const std::size_t end = text.find('\x02', at);
        result += entry_of(names, static_cast<Id>(std::stoul(text.substr(at + 1, end - at - 1))),
                           "a variable without a declaration");
        at = end;
    }
    return result;
}

namespace {

// Where a line that is too long is broken best: behind a comma or in front of an operator, as far outside of
// brackets as there is such a place. 0 where there is none.
std::size_t break_of(const std::string& line, std::size_t indent) {
    std::size_t best = 0;
    int least = 0;
    int depth = 0;
    for (std::size_t k = indent; k < line.size() && k <= columns; ++k) {
        if (line[k] == '(' || line[k] == '[') ++depth;
        if (line[k] == ')' || line[k] == ']') --depth;
        if (line[k] != ' ' || k < columns / 2 || k + 1 >= line.size()) continue;
        const bool place =
            line[k - 1] == ',' ||
            (k + 2 < line.size() && std::string("&|+-*/").find(line[k + 1]) != std::string::npos);
        if (place && (best == 0 || depth <= least)) {
            best = k;
            least = depth;
        }
    }
    if (best != 0) return best;
    const std::size_t last = line.rfind(' ', columns);
    return last == std::string::npos || last <= indent ? 0 : last;
}

}  // namespace

std::string broken(const std::string& line) {
    if (line.size() <= columns || line.find("//") != std::string::npos) return line;
    const std::string indent(line.find_first_not_of(' ') + 4, ' ');
    std::string result;
    std::string rest = line;
    while (rest.size() > columns) {
        const std::size_t at = break_of(rest, indent.size());
        if (at == 0) break;
        result += rest.substr(0, at) + "\n";
        rest = indent + rest.substr(at + 1);
    }
    return result + rest;
}

std::string print(const FunctionBody& body, const std::map<Id, std::string>& names) {
    return Printer(body, names).run();
}

}  // namespace gloam::shader::internal::wgsl
