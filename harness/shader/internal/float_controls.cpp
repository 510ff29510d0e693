// SPDX-License-Identifier: MIT
#include "shader/internal/float_controls.hpp"

#include <spirv.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "shader/instructions.hpp"

namespace gloam::shader::internal {
namespace {

bool is_mode(const Instruction& i) {
    constexpr std::array modes{SpvExecutionModeDenormPreserve, SpvExecutionModeDenormFlushToZero,
                               SpvExecutionModeSignedZeroInfNanPreserve, SpvExecutionModeRoundingModeRTE,
                               SpvExecutionModeRoundingModeRTZ};
    return i.opcode == SpvOpExecutionMode && std::ranges::find(modes, i.word(2)) != modes.end();
}

bool is_capability(const Instruction& i) {
    constexpr std::array capabilities{SpvCapabilityDenormPreserve, SpvCapabilityDenormFlushToZero,
                                      SpvCapabilitySignedZeroInfNanPreserve, SpvCapabilityRoundingModeRTE,
                                      SpvCapabilityRoundingModeRTZ};
    return i.opcode == SpvOpCapability && std::ranges::find(capabilities, i.word(1)) != capabilities.end();
}

bool is_extension(const Instruction& i) {
    if (i.opcode != SpvOpExtension) return false;
    const std::span<const std::byte> bytes = std::as_bytes(i.words.subspan(1));
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    return std::string_view(text, strnlen(text, bytes.size())) == "SPV_KHR_float_controls";
}

std::uint32_t entry_point_of(const std::vector<Instruction>& instructions) {
    const auto found = std::ranges::find(instructions, std::uint32_t{SpvOpEntryPoint}, &Instruction::opcode);
    if (found == instructions.end()) throw std::runtime_error("SPIR-V module without an entry point");
    return found->word(2);
}

// The float controls of `original` that are missing in `present`, with their entry point replaced.
Spirv missing(const std::vector<Instruction>& original, const std::vector<Instruction>& present,
              std::uint32_t entry_point, const std::function<bool(const Instruction&)>& wanted) {
    Spirv result;
    for (const Instruction& i : original) {
        if (!wanted(i)) continue;
        Spirv words(i.words.begin(), i.words.end());
        if (i.opcode == SpvOpExecutionMode) words[1] = entry_point;
        const bool there = std::ranges::any_of(
            present, [&words](const Instruction& other) { return std::ranges::equal(other.words, words); });
        if (!there) result.insert(result.end(), words.begin(), words.end());
    }
    return result;
}

// Index behind the last instruction of one of these kinds.
std::size_t behind(const std::vector<Instruction>& instructions, std::initializer_list<SpvOp> kinds) {
    std::size_t at = 0;
    for (const Instruction& i : instructions)
        if (std::ranges::find(kinds, static_cast<SpvOp>(i.opcode)) != kinds.end()) at = i.at + i.words.size();
    return at;
}

}  // namespace

Spirv with_float_controls_of(const Spirv& original, const Spirv& module) {
    const std::vector<Instruction> from = instructions(original);
    const std::vector<Instruction> to = instructions(module);
    const std::uint32_t entry_point = entry_point_of(to);
    Spirv result = module;
    const auto insert = [&](std::initializer_list<SpvOp> kinds, auto wanted) {
        const Spirv words = missing(from, to, entry_point, wanted);
        result.insert(result.begin() + static_cast<std::ptrdiff_t>(behind(to, kinds)), words.begin(),
                      words.end());
    };
    // Inserts from the last section to the first, so that earlier indices stay valid.
    insert({SpvOpEntryPoint, SpvOpExecutionMode, SpvOpExecutionModeId}, is_mode);
    insert({SpvOpCapability, SpvOpExtension}, is_extension);
    insert({SpvOpCapability}, is_capability);
    return result;
}

}  // namespace gloam::shader::internal
