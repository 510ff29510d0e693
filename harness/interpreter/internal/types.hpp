// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "shader/instructions.hpp"

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
    struct Member {
        Id type = 0;
        std::uint32_t offset = 0;  // bytes
        MatrixLayout matrix;
    };
    std::vector<Member> members;
};

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

}  // namespace gloam::interpreter::internal
