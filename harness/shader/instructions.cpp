// SPDX-License-Identifier: MIT
#include "shader/instructions.hpp"

#include <stdexcept>
#include <string>

namespace gloam::shader {
namespace {

constexpr std::uint32_t magic = 0x07230203u;
constexpr std::size_t header_words = 5;
constexpr std::uint32_t length_shift = 16;
constexpr std::uint32_t opcode_mask = 0xffffu;

}  // namespace

std::vector<Instruction> instructions(const Spirv& module) {
    if (module.size() < header_words || module[0] != magic)
        throw std::runtime_error("no SPIR-V module: its first word is not 0x07230203");
    std::vector<Instruction> all;
    for (std::size_t at = header_words; at < module.size();) {
        const std::size_t length = module[at] >> length_shift;
        if (length == 0 || length > module.size() - at)
            throw std::runtime_error("no SPIR-V module: instruction of " + std::to_string(length) +
                                     " words at word " + std::to_string(at) + " of " +
                                     std::to_string(module.size()));
        all.push_back({at, module[at] & opcode_mask, std::span(module).subspan(at, length)});
        at += length;
    }
    return all;
}

std::string literal_string(const Instruction& instruction, std::size_t index) {
    std::string text;
    for (std::size_t i = index; i < instruction.words.size(); ++i) {
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            const auto character = static_cast<char>(instruction.word(i) >> shift & 0xffu);
            if (character == '\0') return text;
            text.push_back(character);
        }
    }
    return text;
}

Spirv instruction(std::uint32_t opcode, std::span<const std::uint32_t> operands) {
    Spirv words{static_cast<std::uint32_t>(operands.size() + 1) << length_shift | opcode};
    words.insert(words.end(), operands.begin(), operands.end());
    return words;
}

}  // namespace gloam::shader
