// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// An instruction of a module. The module must outlive it.
struct Instruction {
    std::size_t at = 0;  // index of its first word in the module
    std::uint32_t opcode = 0;
    std::span<const std::uint32_t> words;  // including the first one (length and opcode)

    // The word at that index; 0 behind the end.
    [[nodiscard]] std::uint32_t word(std::size_t index) const {
        return index < words.size() ? words[index] : 0;
    }
};

// The instructions behind the five words of the header. Throws std::runtime_error for words that are not a
// SPIR-V module.
[[nodiscard]] std::vector<Instruction> instructions(const Spirv& module);

// A literal string operand that starts at this word: UTF-8, ended by NUL or by the instruction's end.
[[nodiscard]] std::string literal_string(const Instruction& instruction, std::size_t index);

// The words of an instruction; the first one combines the opcode and the length.
[[nodiscard]] Spirv instruction(std::uint32_t opcode, std::span<const std::uint32_t> operands);

}  // namespace gloam::shader
