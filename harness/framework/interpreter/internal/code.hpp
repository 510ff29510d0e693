// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/program.hpp"

// A decoded module: a flat list of instructions on numbered slots. Every scalar has a slot; vectors,
// matrices, arrays and structures have consecutive slots for their scalars. SPIR-V has no recursion, so every
// value and variable has fixed slots, and a call is replaced by a copy of the function.
namespace gloam::interpreter::internal {

using Slot = std::uint32_t;

// Scalar operations of SPIR-V (OpFAdd ...) keep their opcodes; the functions of GLSL.std.450 begin here.
inline constexpr std::uint16_t extended = 0x4000;

// The other operations of an Instruction.
enum Operation : std::uint16_t {
    copy = 0x8000,    // count slots from a
    to_float,         // count slots from a, whose bits become floats
    pack_halves,      // count slots, each from the bits of two halves at a; b: whether they become floats
    unpack_halves,    // count slots, two halves from the bits of each slot at a
    gather,           // count slots, from those of the list at `extra`
    undefine,         // count slots, of the variable `extra` of Code::variables
    select,           // b or c, selected by a; `stride`: 0 if one bool is for all components
    extract_dynamic,  // component b of the count components at a
    insert_dynamic,   // the count components at a, with component c replaced by b
    jump,             // edge `extra`
    branch,           // edge `extra` if a, else edge b
    switch_on,        // switch `extra` on a
    finish,           // ends the run
    unreachable,      //
    chain,            // pointer `result` by chain `extra`
    load_slots,       // count slots, from the target of pointer a
    store_slots,      // count slots at b, to the target of pointer a
    load_memory,      // count slots; `extra`: their offsets from pointer a, as append_offsets() lists them
    store_memory,     // the same from the slots at b
    array_length,     // number of elements behind pointer a; `extra`: bytes of an element
    load_resource,    // the image to which pointer a points
    image_load,    // count components of image a at b, which has c components; `extra`: slot of the level + 1
    image_store,   // the count components at c, to image a at b, which has `extra` components
    image_size,    // of image a; `extra`: slot of the level + 1
    image_sample,  // count components of image a at b, which has c components; by sampling `extra`
    image_levels,  // of image a
    image_texel,  // pointer `result` to the texel at b, which has c components, of the image to which pointer
                  // a points
    atomic,       // c: the SPIR-V opcode; on pointer a with b (and `extra`, for a comparison)
    fence,        // c: its memory semantics
    construct,  // a selection, loop or call begins: edge `extra` leads behind it, edge b - 1 to its continue
                // target
    // Invocations wait here for others (internal/group.hpp).
    barrier,     // c: its memory semantics; `extra`: SpvScope
    neighbour,   // count slots at a, of the invocation of the quad that `extra` names (QuadPick)
    collective,  // count slots from a (and b), by the SPIR-V opcode c and the group operation `extra`
    // count components of a or of b, as a driver chooses
    either,
};

// The invocation of a quad from which a `neighbour` comes: the first or the second of a row, or of a column;
// of the reader's own row or column, or of the other one.
enum QuadPick : std::uint32_t { row = 0, second = 1, other_line = 2, column = 4 };

namespace flags {
inline constexpr std::uint8_t no_contraction = 1;
inline constexpr std::uint8_t relaxed = 2;         // may be done in half precision
inline constexpr std::uint8_t half = 4;            // 16-bit floats
inline constexpr std::uint8_t result_is_used = 8;  // of an atomic operation
inline constexpr std::uint8_t reads_first = 16;    // all operands before the first result
inline constexpr std::uint8_t derivative = 32;     // a part of one, though the operation is arithmetic
}  // namespace flags

struct Instruction {
    std::uint16_t op = 0;
    std::uint8_t flags = 0;
    std::uint8_t stride = 1;  // 0: the second operand is one scalar for all components
    std::uint32_t count = 1;  // components
    Slot result = 0;
    Slot a = 0;
    Slot b = 0;
    Slot c = 0;
    std::uint32_t extra = 0;
    std::uint32_t place = 0;  // index into Code::places
};

// A transition between blocks, with the copies for the phi instructions of the target, all at once.
struct Edge {
    struct Copy {
        Slot to;
        Slot from;
        std::uint32_t count;
    };
    std::uint32_t target = 0;     // instruction
    bool through_memory = false;  // a copy overwrites the source of another
    std::vector<Copy> copies;
};

struct Switch {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cases;  // literal, edge
    std::uint32_t otherwise = 0;                                 // edge
};

// Target of a pointer: slots, or bytes of a resource.
struct Pointer {
    std::uint32_t resource = 0;
    std::uint32_t offset = 0;  // slot, or byte
};

// An access chain with indices that are known only at run time.
struct Chain {
    struct Step {
        Slot index;
        bool is_signed;
        std::uint32_t stride;  // slots or bytes
        std::uint32_t length;  // of the array; 0: as long as its buffer
    };
    bool from_static = true;  // from `base`; otherwise from a pointer plus base.offset
    std::uint32_t from = 0;
    Pointer base;
    std::vector<Step> steps;
};

struct ConstantSlot {
    Slot slot;
    std::uint32_t bits;
    bool is_float;
};

// How a sampler reads.
struct Sampling {
    bool projected = false;  // the last coordinate divides the others, and the reference
    std::optional<Slot> level{};
    std::optional<Slot> bias{};  // of the level that follows from dx and dy
    std::optional<Slot> dx{};
    Slot dy = 0;
    std::uint32_t gradients = 0;  // components of dx and dy
    bool implicit = false;        // dx and dy are differences in a quad
    std::optional<Slot> offset{};
    std::uint32_t offsets = 0;  // components
    bool gathers = false;
    std::optional<Slot> component{};  // of a gather that does not compare
    std::optional<Slot> reference{};  // of a comparison
};

// Something outside the module.
struct Resource {
    enum class Kind { memory, image };
    Kind kind = Kind::memory;
    std::uint32_t set = 0;
    std::uint32_t binding = 0;
    bool is_push_constant = false;
    bool written = false;
    std::string name;
    std::uint32_t shared_words = 0;  // of a variable that a group shares, which nobody binds

    [[nodiscard]] bool is_at(std::uint32_t of_set, std::uint32_t at_binding) const {
        return !is_push_constant && shared_words == 0 && set == of_set && binding == at_binding;
    }
};

// A variable whose value the pipeline sets.
struct BuiltIn {
    std::uint32_t built_in;  // SpvBuiltIn...
    Slot slot;
    std::uint32_t count;
};

struct Code {
    std::vector<Instruction> instructions;
    std::vector<std::uint32_t> origins;  // of each instruction: its word in the module
    std::vector<Edge> edges;
    std::vector<Switch> switches;
    std::vector<Chain> chains;
    std::vector<Sampling> samplings;
    std::vector<Pointer> pointers;  // initial values
    std::vector<std::uint32_t> lists;
    std::vector<ConstantSlot> constants;
    std::vector<Resource> resources;
    std::vector<BuiltIn> built_ins;
    std::vector<std::string> variables;  // names; those of the front end are empty
    std::vector<Location> places;        // one for each line, or each instruction of a module without lines
    std::uint32_t slots = 0;
    std::uint32_t most_copies = 0;  // largest number of slots that the copies of one edge need
    bool may_be_rearranged = false;
};

// Properties of the operations on numbers, by the opcode of an Instruction.

// What is the same for all operations of a form.
enum class Form {
    plain,
    arithmetic,    // on floats: NoContraction applies
    at_once,       // it reads all its operands before its first result
    truth,         // a bool for each component
    to_one,        // of as many components as the first operand has, one result: length, ...
    to_one_truth,  // the same, a bool: any, all
    pair           // of as many, two results each, after all operands are read: a sum and its carry, ...
};

struct Known {
    std::uint8_t arity = 0;
    const char* name = "";
    Form form = Form::plain;

    // Whether the number of components is that of the first operand, not of the result.
    [[nodiscard]] bool gives_one() const { return form == Form::to_one || form == Form::to_one_truth; }
    [[nodiscard]] bool has_count_of_operand() const { return gives_one() || form == Form::pair; }
    [[nodiscard]] bool reads_all_first() const { return form == Form::at_once || form == Form::pair; }
};

// Null for an operation that the interpreter does not know.
[[nodiscard]] const Known* known_operation(std::uint16_t opcode);

// "OpFAdd", "GLSL.std.450 Sqrt"; the number if the name is unknown.
[[nodiscard]] std::string name_of(std::uint16_t opcode);

// How many slots from its result an operation on scalars, vectors or matrices sets.
[[nodiscard]] std::uint32_t results_of(const Instruction& instruction);

// modf() and frexp() of GLSL store a second result through a pointer.
[[nodiscard]] bool writes_through_pointer(std::uint16_t opcode);

}  // namespace gloam::interpreter::internal
