// SPDX-License-Identifier: MIT
#include "shader/decorate.hpp"

#define SPV_ENABLE_UTILITY_CODE
#include <spirv.h>

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include "shader/instructions.hpp"

namespace gloam::shader {
namespace {

using Id = std::uint32_t;

bool is_float_arithmetic(const Instruction& instruction) {
    constexpr std::array opcodes{SpvOpFNegate,
                                 SpvOpFAdd,
                                 SpvOpFSub,
                                 SpvOpFMul,
                                 SpvOpFDiv,
                                 SpvOpFRem,
                                 SpvOpFMod,
                                 SpvOpVectorTimesScalar,
                                 SpvOpMatrixTimesScalar,
                                 SpvOpVectorTimesMatrix,
                                 SpvOpMatrixTimesVector,
                                 SpvOpMatrixTimesMatrix,
                                 SpvOpOuterProduct,
                                 SpvOpDot};
    return std::ranges::find(opcodes, instruction.opcode) != opcodes.end();
}

// Whether the instruction yields a given value, not a calculated one: a constant, or a bit pattern.
bool is_given(std::uint32_t opcode) {
    return opcode == SpvOpUndef || opcode == SpvOpBitcast ||
           (opcode >= SpvOpConstantTrue && opcode <= SpvOpSpecConstantOp);
}

// The IDs of float32 and of its vectors and matrices.
std::set<Id> float32_types(const std::vector<Instruction>& instructions) {
    constexpr std::uint32_t width = 32;
    std::set<Id> types;
    for (const Instruction& i : instructions) {
        const bool is_scalar = i.opcode == SpvOpTypeFloat && i.word(2) == width;
        const bool is_compound =
            (i.opcode == SpvOpTypeVector || i.opcode == SpvOpTypeMatrix) && types.contains(i.word(2));
        if (is_scalar || is_compound) types.insert(i.word(1));
    }
    return types;
}

// Whether the instruction has a result (word 2) with a type (word 1).
bool has_typed_result(const Instruction& instruction) {
    bool result = false;
    bool type = false;
    SpvHasResultAndType(static_cast<SpvOp>(instruction.opcode), &result, &type);
    return result && type && instruction.words.size() > 2;
}

std::set<Id> decorated_ids(const std::vector<Instruction>& instructions, SpvDecoration decoration) {
    std::set<Id> ids;
    for (const Instruction& i : instructions) {
        if (i.opcode == SpvOpDecorate && i.word(2) == static_cast<std::uint32_t>(decoration))
            ids.insert(i.word(1));
    }
    return ids;
}

// Index at which annotations begin: behind all sections that precede them in a module.
std::size_t annotations_begin(const std::vector<Instruction>& instructions, std::size_t end) {
    constexpr std::array before{SpvOpCapability,      SpvOpExtension,       SpvOpExtInstImport,
                                SpvOpMemoryModel,     SpvOpEntryPoint,      SpvOpExecutionMode,
                                SpvOpExecutionModeId, SpvOpString,          SpvOpSourceExtension,
                                SpvOpSource,          SpvOpSourceContinued, SpvOpName,
                                SpvOpMemberName,      SpvOpModuleProcessed};
    const auto first = std::ranges::find_if(instructions, [&](const Instruction& i) {
        return std::ranges::find(before, i.opcode) == before.end();
    });
    return first == instructions.end() ? end : first->at;
}

Spirv decorate(const Spirv& module, SpvDecoration decoration, const std::vector<Instruction>& instructions,
               const std::function<bool(const Instruction&)>& wanted) {
    const std::set<Id> already = decorated_ids(instructions, decoration);
    Spirv added;
    for (const Instruction& i : instructions) {
        if (!has_typed_result(i) || !wanted(i) || already.contains(i.word(2))) continue;
        const std::array operands{i.word(2), static_cast<std::uint32_t>(decoration)};
        const Spirv words = instruction(SpvOpDecorate, operands);
        added.insert(added.end(), words.begin(), words.end());
    }
    Spirv result = module;
    const std::size_t at = annotations_begin(instructions, module.size());
    result.insert(result.begin() + static_cast<std::ptrdiff_t>(at), added.begin(), added.end());
    return result;
}

}  // namespace

Spirv with_no_contraction(const Spirv& module) {
    return decorate(module, SpvDecorationNoContraction, instructions(module), is_float_arithmetic);
}

Spirv with_relaxed_precision(const Spirv& module) {
    const std::vector<Instruction> all = instructions(module);
    const std::set<Id> types = float32_types(all);
    return decorate(module, SpvDecorationRelaxedPrecision, all, [&types](const Instruction& i) {
        return types.contains(i.word(1)) && !is_given(i.opcode);
    });
}

}  // namespace gloam::shader
