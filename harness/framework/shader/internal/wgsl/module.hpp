// SPDX-License-Identifier: MIT
#pragma once

#include <spirv.h>
#include <array>
#include <cstdint>
#include <list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/compile.hpp"
#include "shader/module.hpp"
#include "shader/spirv.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

using spirv::Decorations;
using spirv::Id;
using spirv::Member;
using spirv::Type;
using TypeKind = Type::Kind;

// The entry of a map. Throws NotTranslated, with `what` it is about, where there is none.
template <class Map>
[[nodiscard]] const typename Map::mapped_type& entry_of(const Map& map, const typename Map::key_type& key,
                                                        const char* what) {
    const auto found = map.find(key);
    if (found == map.end()) throw NotTranslated(what);
    return found->second;
}

struct Variable {
    Id id = 0;
    Id type = 0;  // of what it holds
    std::uint32_t storage = 0;
    Id initial = 0;
};

struct Block {
    Id label = 0;
    std::vector<Instruction> body;     // without variables, merge and terminator
    std::optional<Instruction> merge;  // OpSelectionMerge, OpLoopMerge
    Instruction end;
};

struct Function {
    Id id = 0;
    Id result = 0;
    std::vector<Id> parameters;
    std::vector<Variable> variables;
    std::map<Id, Block> blocks;
    std::vector<Id> order;  // of the blocks
    [[nodiscard]] Id first() const { return order.front(); }
    [[nodiscard]] const Block& block(Id label) const {
        return entry_of(blocks, label, "a branch to a block of another function");
    }
};

// What a module declares.
class Module : public spirv::Declarations {
  public:
    // The words must outlive it.
    explicit Module(const Spirv& words);

    [[nodiscard]] const Type& type(Id id) const;
    // The type of a value or of a parameter.
    [[nodiscard]] Id type_of(Id value) const;
    // The image type of an image or a combined sampler.
    [[nodiscard]] const Type& image_type(Id type) const;
    [[nodiscard]] const Type& value_type(Id value) const { return type(type_of(value)); }
    // Of a pointer: the type of what it points to.
    [[nodiscard]] Id pointee(Id pointer) const { return value_type(pointer).element; }
    [[nodiscard]] const Instruction* constant(Id id) const;
    [[nodiscard]] std::optional<std::uint32_t> integer(Id id) const;  // of an OpConstant
    // Whether it is an image, a sampler or both.
    [[nodiscard]] bool is_opaque(Id type) const;
    [[nodiscard]] bool is_float(Id type) const;  // or a vector of them
    [[nodiscard]] bool is_half(Id type) const;   // is_float(), of 16 bits
    [[nodiscard]] bool is_signed(Id type) const;
    [[nodiscard]] bool is_bool(Id type) const;
    [[nodiscard]] std::uint32_t components(Id type) const;  // 1 for a scalar

    std::map<Id, Instruction> constants;  // all OpConstant..., OpSpecConstant..., OpUndef
    std::vector<Id> constant_order;
    std::vector<Variable> variables;
    std::vector<Function> functions;
    std::map<std::uint32_t, Id> entry_points;  // by SPIR-V's execution model
    std::vector<std::uint32_t> local_size{1, 1, 1};

  private:
    void read_global(const Instruction& instruction);
    void read_in_function(const Instruction& instruction);
    void drop_dead_blocks(Function& function);

    std::map<Id, Id> value_types_;
    std::list<std::array<std::uint32_t, 2>> branches_;  // words of instructions made here
    bool in_function_ = false;
    Id block_ = 0;
};

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

// The IDs that an instruction uses, without its type and result.
[[nodiscard]] std::vector<Id> operands(const Instruction& instruction);

// Whether an instruction works on a subgroup: its result depends on the invocations that run it.
[[nodiscard]] bool is_subgroup_operation(std::uint32_t opcode);

// Whether its result depends on the neighbours of a fragment: a derivative, or a texture read by one.
[[nodiscard]] bool is_derivative(std::uint32_t opcode);

// The result of an instruction; 0 where it has none.
[[nodiscard]] Id result_of(const Instruction& instruction);

// How a parameter is passed in WGSL.
enum class Passing {
    value,    // never changed by the function
    copied,   // by value; the function changes its copy
    pointer,  // out, inout
};

// What a function does, with all that it calls.
struct FunctionFacts {
    std::vector<Passing> passing;
    bool changes_memory = false;  // or has another effect besides its result
    bool reads_memory = false;
    std::set<Id> pointers_written;  // parameters
};

// How often a local variable is used, and how.
struct VariableUses {
    int stores = 0;                   // as a whole
    int loads = 0;                    // as a whole
    int parts = 0;                    // access chains and all other uses
    int calls = 0;                    // as an argument
    int changes = 0;                  // stores, also of parts, and arguments that the called function changes
    bool changes_after_load = false;  // a store behind a load, in the order of the module
};

// The declaration of a function of the module by its name and types; nullptr where there is none.
[[nodiscard]] const shader::Function* declaration_of(const Module& module, const Function& function,
                                                     const std::vector<shader::Function>& declared);

// Facts of the functions of a module.
class Facts {
  public:
    Facts(const Module& module, const std::vector<shader::Function>& declared);

    [[nodiscard]] const FunctionFacts& of(Id function) const {
        return entry_of(facts_, function, "a call of a function without a body");
    }
    [[nodiscard]] const VariableUses& uses_of(Id variable) const {
        return entry_of(uses_, variable, "a pointer to no variable");
    }
    // The variable or parameter behind a pointer.
    [[nodiscard]] Id base_of(Id pointer) const;
    // The variable of a loaded image.
    [[nodiscard]] Id image_of(Id value) const;
    // Members of structures, and whole variables, that atomic operations change.
    [[nodiscard]] bool is_atomic(Id structure, std::uint32_t member) const {
        return atomic_members_.contains({structure, member});
    }
    [[nodiscard]] bool is_atomic(Id variable) const { return atomic_variables_.contains(variable); }
    // Whether it leads to a scalar that atomic operations change.
    [[nodiscard]] bool is_atomic_pointer(Id pointer) const;
    [[nodiscard]] bool is_written(Id variable) const { return written_.contains(variable); }
    // Whether a combined sampler is read by its sampler, not only by texelFetch().
    [[nodiscard]] bool is_sampled(Id variable) const { return sampled_.contains(variable); }
    [[nodiscard]] bool is_read(Id variable) const { return read_.contains(variable); }
    // Whether the function, or one that it calls, uses the variable of the module.
    [[nodiscard]] const std::set<Id>& calls_of(Id function) const {
        return entry_of(calls_, function, "a call of a function without a body");
    }
    [[nodiscard]] const std::set<Id>& globals_of(Id function) const {
        return entry_of(globals_, function, "a call of a function without a body");
    }

  private:
    void read_function(const Function& function);
    void read_use(const Instruction& instruction, FunctionFacts& facts);
    void read_atomic(const Instruction& instruction);
    // The innermost structure that the pointer goes through, and the member; nothing where there is none.
    [[nodiscard]] std::optional<std::pair<Id, std::uint32_t>> owner_of(Id pointer) const;
    void store_to(Id pointer, FunctionFacts& facts);
    void load_from(Id pointer, FunctionFacts& facts);
    void read_call(const Instruction& instruction, FunctionFacts& facts);
    void decide_passing(const Function& function, const shader::Function* declared);
    [[nodiscard]] bool only_given(Id function, std::size_t parameter) const;

    const Module& module_;
    std::map<Id, FunctionFacts> facts_;
    std::map<Id, VariableUses> uses_;
    std::map<Id, Instruction> chains_;  // by their result
    std::map<Id, Id> loaded_;
    std::set<Id> globals_of_module_;
    std::set<std::pair<Id, std::uint32_t>> atomic_members_;
    std::set<Id> atomic_variables_;
    std::set<Id> written_;
    std::set<Id> read_;
    std::set<Id> sampled_;
    std::map<Id, std::set<Id>> calls_;
    std::map<Id, std::set<Id>> globals_;
    std::map<Id, std::vector<Instruction>> call_sites_;
    Id open_ = 0;
};

}  // namespace gloam::shader::internal::wgsl
