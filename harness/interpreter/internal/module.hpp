// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "interpreter/internal/types.hpp"
#include "interpreter/program.hpp"

namespace gloam::interpreter::internal {

// The names and decorations of an ID outside of functions.
struct Decorations {
    bool no_contraction = false;
    bool relaxed = false;
    std::optional<std::uint32_t> spec_id;
    std::optional<std::uint32_t> built_in;
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
};

// A constant as the bits of its scalars.
struct ConstantValue {
    Id type = 0;
    std::vector<std::uint32_t> bits;
};

struct Function {
    Id id = 0;
    Id result_type = 0;
    std::vector<Id> parameters;
    std::vector<shader::Instruction> body;  // labels and line instructions included, also the line before it
};

// A parsed module: its declarations, and its functions in order. `words` must outlive this object.
class Module {
  public:
    Module(const shader::Spirv& words, std::span<const Constant> constants);

    [[nodiscard]] Id entry_point(const std::string& name) const;
    [[nodiscard]] const Function& function(Id id) const;
    [[nodiscard]] std::string name_of(Id id) const;
    [[nodiscard]] std::string string_of(Id id) const;
    [[nodiscard]] Decorations decorations_of(Id id) const;
    // The value of an integer constant, if the ID is one.
    [[nodiscard]] std::optional<std::uint32_t> integer(Id id) const;

    Types types;
    std::map<Id, ConstantValue> constants;
    std::vector<shader::Instruction> computed_constants;  // OpSpecConstantOp, and composites of those
    std::vector<shader::Instruction> variables;           // outside of functions
    std::map<Id, Id> undefined;                           // OpUndef outside of functions: its type
    std::set<Id> extended_sets;                           // GLSL.std.450

  private:
    void read_declaration(const shader::Instruction& instruction);
    void decorate(const shader::Instruction& instruction);
    void decorate_member(const shader::Instruction& instruction);
    void read_constant(const shader::Instruction& instruction);
    void read_function(const shader::Instruction& instruction);

    std::map<std::uint32_t, std::uint32_t> specialized_;
    std::map<Id, std::string> names_;
    std::map<Id, std::string> strings_;
    std::map<Id, Decorations> decorations_;
    std::map<std::string, Id> entry_points_;
    std::map<Id, Function> functions_;
    Function* open_ = nullptr;
    std::optional<shader::Instruction> line_;  // the last line instruction outside of functions
};

}  // namespace gloam::interpreter::internal
