// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/internal/wgsl/module.hpp"

namespace gloam::shader::internal::wgsl {

// How tightly the parts of an expression are bound, from the tightest on.
enum class Level { primary, unary, product, sum, relation, bits, logic };

// A part of the text of WGSL. Local variables stand in it as marks (mark()), because their names are chosen
// when the whole function is known.
struct Expression {
    std::string text;
    Level level = Level::primary;
    std::string operation;   // of the levels bits and logic
    std::set<Id> reads;      // local variables; `memory` for anything that outlives the function
    bool literal = false;    // a number without variables: of an abstract type
    bool component = false;  // it ends with one component of a vector: ".x"
    std::string typed{};     // of a literal: the same with the suffix of its type
};

inline constexpr Id memory = 0;

// The place of a local variable's name.
[[nodiscard]] std::string mark(Id variable);
// The variables whose marks are in the text, in order.
[[nodiscard]] std::vector<Id> marks_in(const std::string& text);

struct Statement;
using Statements = std::vector<Statement>;

struct Statement {
    enum class Kind {
        assign,      // target or text = value
        expression,  // value
        condition,   // if (value) lists[0] else lists[1]
        loop,        // lists[0], continuing lists[1]; value: its condition at the front, text: at the end
        choice,      // switch (value), lists by labels
        leave,       // break
        next,        // continue
        give         // return value
    };
    Kind kind = Kind::expression;
    Id target = 0;  // a variable that is set as a whole
    std::string text{};
    std::string value{};
    std::vector<Statements> lists{};
    std::vector<std::string> labels{};

    // Set when the declarations are placed.
    std::vector<Id> declares{};  // variables declared in front of the statement
    std::string keyword{};       // "let", "var": the assignment is the declaration of its target
    bool heads_loop = false;     // the declaration of a variable that only the loop behind it uses
};

using StatementKind = Statement::Kind;

}  // namespace gloam::shader::internal::wgsl
