// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gloam::interpreter::internal {

// Properties of the operations on numbers, by the opcode of an Instruction.

// Number of operands; nullopt for an operation that the interpreter does not know.
[[nodiscard]] std::optional<std::uint8_t> arity_of(std::uint16_t opcode);

// "OpFAdd", "GLSL.std.450 Sqrt"; the number if the name is unknown.
[[nodiscard]] std::string name_of(std::uint16_t opcode);

// Whether the number of components is that of the first operand, not of the result: dot, any, length, ...
[[nodiscard]] bool takes_count_of_operand(std::uint16_t opcode);

// modf() and frexp() of GLSL store a second result through a pointer.
[[nodiscard]] bool writes_through_pointer(std::uint16_t opcode);

// Arithmetic to which NoContraction applies.
[[nodiscard]] bool is_float_arithmetic(std::uint16_t opcode);

}  // namespace gloam::interpreter::internal
