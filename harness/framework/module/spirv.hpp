// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"

namespace gloam::module {

// An instruction of a module. The module must outlive it.
struct Instruction {
    std::size_t at = 0;  // index of its first word in the module
    std::uint32_t opcode = 0;
    std::span<const std::uint32_t> words;  // including the first one (length and opcode)

    // The word at that index; 0 behind the end.
    [[nodiscard]] std::uint32_t word(std::size_t index) const {
        return index < words.size() ? words[index] : 0;
    }

    // The words from that index on; none behind the end.
    [[nodiscard]] std::span<const std::uint32_t> from(std::size_t index) const {
        return words.subspan(std::min(index, words.size()));
    }
};

// The instructions behind the five words of the header. Throws std::runtime_error for words that are not a
// SPIR-V module.
[[nodiscard]] std::vector<Instruction> instructions(const Spirv& module);

// A literal string operand that starts at this word: UTF-8, ended by NUL or by the instruction's end.
[[nodiscard]] std::string literal_string(const Instruction& instruction, std::size_t index);

// The words of an instruction; the first one combines the opcode and the length.
[[nodiscard]] Spirv instruction(std::uint32_t opcode, std::span<const std::uint32_t> operands);

// A module as bytes, and back; nullopt for bytes that are no whole words.
[[nodiscard]] std::string bytes_of(const Spirv& module);
[[nodiscard]] std::optional<Spirv> module_of(std::string_view bytes);

// The instructions of a module, one after another, without those that only name things and places.
[[nodiscard]] Spirv without_names(const Spirv& module);

// A compute module as GLSL for OpenGL, as SPIRV-Cross writes it. Its push constants are a uniform block with
// this binding; other bindings stay. Throws std::runtime_error with SPIRV-Cross's message.
[[nodiscard]] std::string opengl_text(const Spirv& module, source::Language language,
                                      unsigned push_constant_binding);

// Whether a module calculates in float16.
[[nodiscard]] bool has_float16(const Spirv& module);

// Whether a function of the module has a loop.
[[nodiscard]] bool has_loop(const Spirv& module);

// Whether a module declares SignedZeroInfNanPreserve.
[[nodiscard]] bool preserves_specials(const Spirv& module);

// The finite float32 constants of a module, each once, ascending: whatever order its text declares them in.
[[nodiscard]] std::vector<float> float_constants(const Spirv& module);

// Throws std::runtime_error with the validator's message if the module is not valid for Vulkan 1.2.
void validate(const Spirv& module);

// The module after the passes of the given kind; `none` returns it unchanged. Does not validate. Throws
// std::runtime_error with the optimizer's message if it cannot read the module.
[[nodiscard]] Spirv optimize(const Spirv& module, Optimization optimization);

// The module after passes of SPIRV-Tools in this order, each an option of its program spirv-opt: "--ccp",
// "-O",
// "--scalar-replacement=4". Does not validate. Throws std::runtime_error if one cannot read the module, and
// for an option that is no pass.
[[nodiscard]] Spirv with_passes(const Spirv& module, const std::vector<std::string>& passes);

// Whether SPIRV-Tools has a pass of this option.
[[nodiscard]] bool is_pass(const std::string& option);

// The module as assembly text with friendly names. Throws std::runtime_error when it cannot be decoded.
[[nodiscard]] std::string disassemble(const Spirv& module);

// Adds decorations to a module and changes nothing else. An existing decoration is kept, so a second call
// changes nothing. Both throw std::runtime_error for words that are not a SPIR-V module.

// Adds NoContraction to the result of every float arithmetic instruction (negation, sum, difference, product,
// quotient, remainder, modulo, dot and outer product, and products with matrices), so that it is neither
// contracted nor reordered. The extended instructions (sqrt, fma, ...) do not support this decoration.
[[nodiscard]] Spirv with_no_contraction(const Spirv& module);

// Adds RelaxedPrecision to every float32 scalar, vector or matrix result, so that it may be calculated with
// the range and precision of float16. Constants, and bit patterns that become floats (uintBitsToFloat), are
// not decorated.
[[nodiscard]] Spirv with_relaxed_precision(const Spirv& module);

// A buffer, an image, a sampler, or the push constants.
struct Resource {
    std::string kind;   // "uniform buffer", "storage buffer", "image or sampler", "push constants"
    std::string name;   // of the variable; empty if the text gives none
    std::string block;  // of the buffer's type
};

// The resources that main and the functions that it calls use. Throws std::runtime_error with SPIRV-Cross's
// message.
[[nodiscard]] std::vector<Resource> used_resources(const Spirv& module);

}  // namespace gloam::module
