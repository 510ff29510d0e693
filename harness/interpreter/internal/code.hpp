// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/error.hpp"

// What a module is decoded to: a flat list of instructions on numbered slots. Every scalar has a slot;
// vectors, matrices, arrays and structures have as many in a row as they have scalars. Since SPIR-V has no
// recursion, every value and variable has its slots for good: a call is replaced by a copy of the function.
namespace gloam::interpreter::internal {

using Slot = std::uint32_t;

// Operations of SPIR-V on scalars (OpFAdd ...) keep their opcodes; the functions of GLSL.std.450 begin here.
inline constexpr std::uint16_t extended = 0x4000;

// What an Instruction does else.
enum Operation : std::uint16_t {
    copy = 0x8000,    // count slots from a
    to_float,         // count slots from a, whose bits become floats
    gather,           // count slots, from those of the list at `extra`
    undefine,         // count slots
    select,           // b or c as a says; `stride`: 0 where one bool stands for all components
    extract_dynamic,  // of the count components at a, that of index b
    insert_dynamic,   // the count components at a, that of index c replaced by b
    jump,             // edge `extra`
    branch,           // edge `extra` if a, else edge b
    switch_on,        // switch `extra` on a
    finish,           // ends the run
    unreachable,      //
    chain,            // pointer `result` by chain `extra`
    load_slots,       // count slots from where pointer a points
    store_slots,      // count slots at b to where pointer a points
    load_memory,    // count slots; their offsets from pointer a, as append_offsets() has them, are at `extra`
    store_memory,   // the same from the slots at b
    array_length,   // elements behind pointer a; `extra`: bytes of one
    load_resource,  // which image stands behind pointer a
    image_load,   // count components of image a at b, whose components are c; `extra`: slot of the level + 1
    image_store,  // the count components at c to image a at b, whose components are `extra`
    image_size,   // of image a; `extra`: slot of the level + 1
    atomic,       // c: the SPIR-V opcode; on pointer a with b (and `extra`, for a comparison)
};

namespace flags {
inline constexpr std::uint8_t no_contraction = 1;
inline constexpr std::uint8_t relaxed = 2;    // may be done in half precision
inline constexpr std::uint8_t half = 4;       // 16-bit floats
inline constexpr std::uint8_t is_signed = 8;  // integers
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

// From one block to another: what the phi instructions there take, all at once.
struct Edge {
    struct Copy {
        Slot to;
        Slot from;
        std::uint32_t count;
    };
    std::uint32_t target = 0;     // instruction
    bool through_memory = false;  // a copy overwrites what another takes
    std::vector<Copy> copies;
};

struct Switch {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cases;  // literal, edge
    std::uint32_t otherwise = 0;                                 // edge
};

// Where a pointer points: slots, or bytes of a resource.
struct Pointer {
    std::uint32_t resource = 0;
    std::uint32_t offset = 0;  // slot, or byte
};

// An access chain with indices that are known when it runs only.
struct Chain {
    struct Step {
        Slot index;
        bool is_signed;
        std::uint32_t stride;  // slots or bytes
        std::uint32_t length;  // of the array; 0: as long as its buffer
    };
    bool from_static = true;  // from `base`, else from a pointer plus base.offset
    std::uint32_t from = 0;
    Pointer base;
    std::vector<Step> steps;
};

struct ConstantSlot {
    Slot slot;
    std::uint32_t bits;
    bool is_float;
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
};

// A variable that the pipeline gives a value.
struct BuiltIn {
    std::uint32_t built_in;  // SpvBuiltIn...
    Slot slot;
    std::uint32_t count;
};

struct Code {
    std::vector<Instruction> instructions;
    std::vector<std::uint32_t> origins;  // of each instruction: the word of the module that it was made of
    std::vector<Edge> edges;
    std::vector<Switch> switches;
    std::vector<Chain> chains;
    std::vector<Pointer> pointers;  // as they are before the run
    std::vector<std::uint32_t> lists;
    std::vector<ConstantSlot> constants;
    std::vector<Resource> resources;
    std::vector<BuiltIn> built_ins;
    std::vector<Place> places;  // one for each line, or each instruction of a module without lines
    std::uint32_t slots = 0;
    std::uint32_t most_copies = 0;  // slots that the copies of one edge take
    bool may_be_rearranged = false;
};

}  // namespace gloam::interpreter::internal
