// SPDX-License-Identifier: MIT
#include "check/internal/gl_rules.hpp"

#include <algorithm>

#include "shader/instructions.hpp"

namespace gloam::check::internal {
namespace {

// Of SPIR-V: OpExtInst, and the numbers of its set GLSL.std.450 from Sin to Atan2, and of two for matrices.
constexpr std::uint32_t extended = 12;
constexpr std::uint32_t sine = 13;
constexpr std::uint32_t arc_tangent_of_two = 25;
constexpr std::uint32_t determinant = 33;
constexpr std::uint32_t inverse = 34;

}  // namespace

bool has_precision_rules(shader::Language language) {
    return language == shader::Language::vulkan450 || language == shader::Language::es320;
}

bool calls_undefined_precision(const shader::Spirv& module) {
    const auto all = shader::instructions(module);
    return std::ranges::any_of(all, [](const shader::Instruction& instruction) {
        if (instruction.opcode != extended) return false;
        const std::uint32_t function = instruction.word(4);
        return (function >= sine && function <= arc_tangent_of_two) || function == determinant ||
               function == inverse;
    });
}

}  // namespace gloam::check::internal
