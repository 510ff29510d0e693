// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "interpreter/program.hpp"
#include "shader/spirv.hpp"

namespace gloam::interpreter::internal {

using Id = std::uint32_t;

// The memory layout of a matrix.
struct MatrixLayout {
    std::uint32_t stride = 0;
    bool row_major = false;
};

// A type of the module.
struct Type {
    enum class Kind {
        void_,
        boolean,
        integer,
        real,
        vector,
        matrix,
        array,
        runtime_array,
        structure,
        pointer,
        image,
        sampler,
        sampled_image,
        function
    };
    Kind kind = Kind::void_;
    std::uint32_t width = 0;  // bits of a number
    bool is_signed = false;
    Id element = 0;             // of a vector, matrix (its column) or array; the pointee of a pointer
    std::uint32_t count = 0;    // elements
    std::uint32_t storage = 0;  // of a pointer
    std::uint32_t slots = 0;
    std::uint32_t array_stride = 0;  // bytes
    std::uint32_t dimension = 0;     // of an image: SpvDim
    bool arrayed = false;
    std::uint32_t format = 0;  // SpvImageFormat
    struct Member {
        Id type = 0;
        std::uint32_t offset = 0;  // bytes
        MatrixLayout matrix;
    };
    std::vector<Member> members;
};

// Coordinates of an image besides the layer.
[[nodiscard]] std::uint32_t dimensions_of(const Type& image);

// Channels of an image's format; 4 where it has none.
[[nodiscard]] std::uint32_t channels_of(const Type& image);

// The types of a module, by their IDs.
class Types {
  public:
    // Reads an OpType instruction; ignores others. `length_of`: returns the value of a constant.
    template <class LengthOf>
    void read(const shader::Instruction& instruction, LengthOf&& length_of);

    void decorate(Id type, std::uint32_t array_stride) { strides_[type] = array_stride; }
    // A member of a structure; decorations can precede its type.
    Type::Member& member(Id type, std::uint32_t index) { return members_[{type, index}]; }

    // Throws Error (malformed) for an ID that is not a type.
    [[nodiscard]] const Type& at(Id id) const;
    [[nodiscard]] std::uint32_t slots(Id id) const { return at(id).slots; }

    // The type of all scalars in it: float, integer or bool.
    [[nodiscard]] const Type& scalar_of(Id id) const;

    // Bytes of each scalar of a type in memory.
    [[nodiscard]] std::uint32_t scalar_bytes(Id id) const { return scalar_of(id).width == 16 ? 2 : 4; }

    // Appends the byte offset of every scalar of a type at offset `base`, plus 1 for a 16-bit scalar.
    // `scalar_stride`: between the components of a vector; 0: consecutive.
    void append_offsets(Id id, const MatrixLayout& matrix, std::uint32_t scalar_stride, std::uint32_t base,
                        std::vector<std::uint32_t>& offsets) const;

  private:
    void add(const shader::Instruction& instruction, std::uint32_t length);

    std::map<Id, Type> types_;
    std::map<Id, std::uint32_t> strides_;
    std::map<std::pair<Id, std::uint32_t>, Type::Member> members_;
};

template <class LengthOf>
void Types::read(const shader::Instruction& instruction, LengthOf&& length_of) {
    constexpr std::uint32_t type_array = 28;  // OpTypeArray, whose length is a constant
    add(instruction, instruction.opcode == type_array ? length_of(instruction.word(3)) : 0);
}

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
    std::vector<std::uint64_t> bits;
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
    // Whether invocations wait for each other somewhere: at a barrier, a derivative, or another operation of
    // a quad or group.
    [[nodiscard]] bool meets() const { return meets_; }
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
    bool meets_ = false;
    std::optional<shader::Instruction> line_;  // the last line instruction outside of functions
};

}  // namespace gloam::interpreter::internal
