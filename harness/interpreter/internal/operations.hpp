// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gloam::interpreter::internal {

// What is known of the operations on numbers, by the opcode that an Instruction carries.

// How many operands it takes; nothing for an operation that the interpreter does not know.
[[nodiscard]] std::optional<std::uint8_t> arity_of(std::uint16_t opcode);

// "OpFAdd", "GLSL.std.450 Sqrt"; a number where the name is not known.
[[nodiscard]] std::string name_of(std::uint16_t opcode);

// Whether its components are those of its first operand, not those of its result: dot, any, length, ...
[[nodiscard]] bool takes_count_of_operand(std::uint16_t opcode);

// modf() and frexp() of GLSL: a second result goes where a pointer says.
[[nodiscard]] bool writes_through_pointer(std::uint16_t opcode);

// Arithmetic that NoContraction is about.
[[nodiscard]] bool is_float_arithmetic(std::uint16_t opcode);

}  // namespace gloam::interpreter::internal
