// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/program.hpp"
#include "module/module.hpp"
#include "module/spirv.hpp"

namespace gloam::interpreter::internal {

using module::spirv::Decorations;
using module::spirv::Id;
using module::spirv::MatrixLayout;

// A type of the module, with the number of elements of an array as `count`.
struct Type : module::spirv::Type {
    std::uint32_t slots = 0;
};

// Coordinates of an image besides the layer.
[[nodiscard]] std::uint32_t dimensions_of(const Type& image);

// Channels of an image's format; 4 where it has none.
[[nodiscard]] std::uint32_t channels_of(const Type& image);

// The types of a module, by their IDs.
class Types {
  public:
    // `length`: of an array.
    void add(Id id, const module::spirv::Type& declared, std::uint32_t length);

    // Throws Error (malformed) for an ID that is not a type.
    [[nodiscard]] const Type& at(Id id) const;
    [[nodiscard]] std::uint32_t slots(Id id) const { return at(id).slots; }

    // The type of all scalars in it: float, integer or bool.
    [[nodiscard]] const Type& scalar_of(Id id) const;

    // Bytes of each scalar of a type in memory.
    [[nodiscard]] std::uint32_t scalar_bytes(Id id) const { return scalar_of(id).width == 16 ? 2 : 4; }

    // Appends the byte offset of every scalar of a type at offset `base`, plus 1 for a 16-bit scalar.
    // `scalar_stride`: between the components of a vector; 0: consecutive.
    void append_offsets(Id id, const module::spirv::MatrixLayout& matrix, std::uint32_t scalar_stride,
                        std::uint32_t base, std::vector<std::uint32_t>& offsets) const;

  private:
    std::map<Id, Type> types_;
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
    std::vector<module::Instruction> body;  // labels and line instructions included, also the line before it
};

// A parsed module: its declarations, and its functions in order. `words` must outlive this object.
class Module {
  public:
    Module(const module::Spirv& words, std::span<const Constant> constants);

    [[nodiscard]] Id entry_point(const std::string& name) const;
    [[nodiscard]] const Function& function(Id id) const;
    [[nodiscard]] std::string name_of(Id id) const;
    [[nodiscard]] std::string string_of(Id id) const;
    // Whether invocations wait for each other somewhere: at a barrier, a derivative, or another operation of
    // a quad or group.
    [[nodiscard]] bool meets() const { return meets_; }
    // The value of an integer constant, if the ID is one.
    [[nodiscard]] std::optional<std::uint32_t> integer(Id id) const;

    module::spirv::Declarations declared;
    Types types;
    std::map<Id, ConstantValue> constants;
    std::vector<module::Instruction> computed_constants;  // OpSpecConstantOp, and composites of those
    std::vector<module::Instruction> variables;           // outside of functions
    std::map<Id, Id> undefined;                           // OpUndef outside of functions: its type

  private:
    void read_declaration(const module::Instruction& instruction);
    [[nodiscard]] std::uint32_t length_of(const module::spirv::Type& type) const;
    void read_constant(const module::Instruction& instruction);
    void read_function(const module::Instruction& instruction);

    std::map<std::uint32_t, std::uint32_t> specialized_;
    std::map<Id, std::string> strings_;
    std::map<std::string, Id> entry_points_;
    std::map<Id, Function> functions_;
    Function* open_ = nullptr;
    bool meets_ = false;
    std::optional<module::Instruction> line_;  // the last line instruction outside of functions
};

}  // namespace gloam::interpreter::internal
