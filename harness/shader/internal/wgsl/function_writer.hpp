// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/internal/wgsl/expressions.hpp"
#include "shader/internal/wgsl/module_text.hpp"
#include "shader/internal/wgsl/shape.hpp"
#include "shader/internal/wgsl/statement.hpp"

namespace gloam::shader::internal::wgsl {

// The statements of a function, before its variables are declared.
struct FunctionBody {
    Statements statements;
    std::map<Id, std::string> wanted_names;  // of local variables, those made here included
    std::map<Id, std::string> types;         // of those that may need a declaration without a value
    std::map<Id, std::string> initial;       // values of variables that are declared with one
    std::set<Id> addressed;                  // variables whose parts are set or whose address is given
};

// Makes statements and expressions of a function's instructions. A value that is used once is written where
// it is used, as long as nothing that it reads changes before.
class FunctionWriter {
  public:
    FunctionWriter(ModuleText& text, const Function& function);

    [[nodiscard]] FunctionBody run();

  private:
    // Where the branches of the open statements lead.
    struct Open {
        Id stop = 0;   // ends the region
        Id leave = 0;  // `break`
        Id next = 0;   // `continue`
    };

    // control.cpp
    void region(Id start, const Open& open, Statements& out);
    Id block(const Block& block, const Open& open, Statements& out);
    void folded(const Block& block, const Fold& fold, Statements& out);
    void body_of(const Block& block, Statements& out);
    void branch(Id from, Id to, const Open& open, Statements& out);
    Id selection(const Block& block, const Open& open, Statements& out);
    Id two_ways(const Block& block, const Open& open, Statements& out);
    Id choice(const Block& block, const Open& open, Statements& out);
    void loop(const Block& header, const Open& open, Statements& out);
    [[nodiscard]] std::optional<std::pair<Id, bool>> loop_condition(const Block& block, Id leave) const;
    const Block* straight_on(const Block& at, const Block& header, const Open& open, Statements& out);
    void continuing(const Block& header, Id next, Id leave, Statement& loop);
    void set_phis(Id from, Id to, Statements& out);
    [[nodiscard]] bool is_jump(Id to, const Open& open) const;

    // instructions.cpp
    void instruction(const Instruction& instruction, Statements& out);
    bool value(const Instruction& instruction, Statements& out);
    bool memory_access(const Instruction& instruction, Statements& out);
    bool image_access(const Instruction& instruction, Statements& out);
    [[nodiscard]] std::vector<Expression> coordinates(Id image, Id coordinate, Statements& out);
    void image_size(const Instruction& instruction, Statements& out);
    void sample(const Instruction& instruction, Statements& out);
    bool atomic_access(const Instruction& instruction, Statements& out);
    [[nodiscard]] Expression written_twice(Id value, Statements& out);
    void compare_exchange(const Instruction& instruction, Statements& out);
    bool subgroup_operation(const Instruction& instruction, Statements& out);
    void load(const Instruction& instruction, Statements& out);
    void store(const Instruction& instruction, Statements& out);
    void store_value(Id to, const Expression& value, Statements& out);
    void split_number(const Instruction& instruction, Statements& out);
    void insert(const Instruction& instruction, Statements& out);
    void call_function(const Instruction& instruction, Statements& out);
    [[nodiscard]] Expression argument_of(Id argument, Passing passing);
    [[nodiscard]] bool is_parameter(Id id) const;
    [[nodiscard]] Expression opaque(Id variable) const;
    [[nodiscard]] Expression sampler_of(Id variable) const;
    void barrier(const Instruction& instruction, Statements& out);
    void memory_barriers(std::uint32_t semantics, Statements& out);
    [[nodiscard]] Expression pointer(Id id);
    [[nodiscard]] Expression chain(const Instruction& instruction);
    [[nodiscard]] std::vector<Expression> take_all(const Instruction& instruction);

    // values.cpp
    [[nodiscard]] Expression take(Id value);
    void define(Id result, Expression expression, Statements& out);
    void keep(Id result, const Expression& expression, Statements& out);
    void before_change(Id variable, Statements& out);
    void keep_all(Statements& out);
    [[nodiscard]] Id same(Id variable) const;
    bool from_choice(const Expression& value, Id to, Statements& out);
    void give(const Expression& value, Statements& out);
    void assign(Id variable, const Expression& value, Statements& out);

    // A variable that is made here for a value.
    static Id copy_of(Id value) { return 0x40000000U + value; }

    ModuleText& text_;
    const Module& module_;
    const Facts& facts_;
    const Function& function_;
    Shape shape_;
    FunctionBody body_;
    std::map<Id, Expression> values_;
    std::map<Id, Expression> samplers_;       // of combined images
    std::vector<Id> pending_;                 // values that are not written yet, in order
    std::map<Id, std::set<Id>> chain_reads_;  // what the indices of a chain read
    std::map<Id, int> left_;                  // uses of a pending value that are still to come
    std::set<Id> set_once_;                   // variables that have their only value
    std::map<Id, int> chain_uses_;            // uses of a chain that are still to come
    std::map<Id, std::vector<std::string>>
        member_names_;  // of results whose structures WGSL has under its own
};

// The parameter for the sampler of a parameter that is a combined one.
[[nodiscard]] inline Id sampler_parameter(Id parameter) {
    return 0x60000000U + parameter;
}

// Chooses where the variables are declared: as far inside as all uses allow, with their first value.
void declare_variables(FunctionBody& body, const std::set<Id>& parameters);

// Names of the variables: each unlike those that it stands beside, and unlike the identifiers that are taken.
[[nodiscard]] std::map<Id, std::string> choose_names(const FunctionBody& body,
                                                     const std::vector<Id>& parameters,
                                                     const std::set<std::string>& taken);

// All identifiers in the texts of the statements.
[[nodiscard]] std::set<std::string> identifiers_in(const Statements& statements);

// The text with the names at its marks.
[[nodiscard]] std::string with_names(const std::string& text, const std::map<Id, std::string>& names);

// The statements as lines of at most 120 columns, where they can be broken.
[[nodiscard]] std::string print(const FunctionBody& body, const std::map<Id, std::string>& names);

// A line, broken where it is too long.
[[nodiscard]] std::string broken(const std::string& line);

}  // namespace gloam::shader::internal::wgsl
