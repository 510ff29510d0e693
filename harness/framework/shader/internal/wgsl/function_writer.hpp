// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/internal/wgsl/module.hpp"
#include "shader/internal/wgsl/module_text.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

// `a operation b`, with brackets where WGSL needs them.
[[nodiscard]] Expression binary(const std::string& operation, const Expression& a, const Expression& b);
// `operation a`: "-", "!", "~".
[[nodiscard]] Expression unary(const std::string& operation, const Expression& a);
// `function(a, ...)`.
[[nodiscard]] Expression call(const std::string& function, std::vector<Expression> arguments);
// The expression as a part of one that binds its parts tightly: `a` of `a.x`.
[[nodiscard]] std::string primary(const Expression& a);
// An expression that is a name or a number as it stands.
[[nodiscard]] Expression plain(std::string text);
// A literal whose type is written: for functions and operators that have literals alone.
[[nodiscard]] Expression typed(Expression a);

// The arithmetic, logic and conversions that an instruction calculates from its operands. False where it is
// no such instruction.
class ModuleText;
[[nodiscard]] bool operation(ModuleText& text, const Instruction& instruction,
                             const std::vector<Expression>& operands, Expression& result);
// A result of WGSL, which has the sign of the operand's integers, as `type`, which SPIR-V states.
[[nodiscard]] Expression of_sign(ModuleText& text, Id type, Id operand, const Expression& result);
// What an instruction of GLSL.std.450 calculates from its operands. False where there is no such instruction.
[[nodiscard]] bool extended_operation(ModuleText& text, const Instruction& instruction,
                                      const std::vector<Expression>& operands, Expression& result);

// A selection whose branches only calculate a value: `a && b`, `a || b`, or one of two values.
struct Fold {
    enum class Kind { conjunction, disjunction, either };
    Kind kind = Kind::either;
    Id result = 0;  // a phi, or a variable without a name
    Id condition = 0;
    Id yes = 0;  // the values; of a conjunction or disjunction `yes` is the right one
    Id no = 0;
    Id negation = 0;         // of the condition, which is not needed
    std::vector<Id> blocks;  // of the branches, in order, with those of inner folds
    Id merge = 0;
};

// An argument variable that stands for another value or variable.
struct Shape {
    // By the label of the block that ends with the selection.
    std::map<Id, Fold> folds;
    std::set<Id> idle_values;      // negations that a fold has turned round
    std::map<Id, Id> only_values;  // of phis that only one block gives a value
    std::set<Id> fold_results;     // their phis and variables
    std::map<Id, Id> straight;     // a block: the first of those that run one after another with it
    std::map<Id, int> uses;        // of each value
    std::map<Id, Id> home;         // of a value: straight of the only block that uses it; 0: of several
    std::map<Id, Id> defined_in;   // of a value: straight of its block
    std::set<Id> bound;            // variables that only hand a value to one call
    std::map<Id, Id> same;         // variables that only hand another variable to one call, and which
    std::set<std::size_t> idle;    // instructions (by position) that `same` makes idle
};

// The shape of a function of the module.
[[nodiscard]] Shape shape_of(const Module& module, const Facts& facts, const Function& function);

// The statements of a function, before its variables are declared.
struct FunctionBody {
    Statements statements;
    std::map<Id, std::string> wanted_names;  // of local variables, those made here included
    std::map<Id, std::string> types;         // of those that may need a declaration without a value
    std::map<Id, std::string> initial;       // values of variables that are declared with one
    std::set<Id> addressed;                  // variables whose parts are set or whose address is given
};

// An index of a chain changes before the element is used.
class ChangedIndex : public NotTranslated {
  public:
    explicit ChangedIndex(Id of)
        : NotTranslated("an index that changes before its element is used"), chain(of) {}
    Id chain;
};

// The statements of a function. Indices that change before they are used become variables.
[[nodiscard]] FunctionBody body_of(ModuleText& text, const Function& function);

// Makes statements and expressions of a function's instructions. A value that is used once is written where
// it is used, as long as nothing that it reads changes before.
class FunctionWriter {
  public:
    FunctionWriter(ModuleText& text, const Function& function, const std::set<Id>& kept_indices);

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
    Id block_or_loop(const Block& here, const Open& open, Statements& out);
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
    bool derivative(const Instruction& instruction, Statements& out);
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
    [[nodiscard]] Expression chain(const Instruction& instruction, Statements& out);
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

    const std::set<Id>& kept_indices_;  // chains whose indices become variables
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
