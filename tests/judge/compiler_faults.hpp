// SPDX-License-Identifier: MIT
#pragma once

#include <GLSL.std.450.h>
#include <spirv.h>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "module/module.hpp"
#include "module/spirv.hpp"

// Faults as compilers have them, planted in modules: each changes every instruction that it applies to.
namespace gloam::test {

using shader::Instruction;
using shader::Spirv;

// An instruction of a module.
struct Place {
    const Instruction& at;
    std::size_t number;                               // among those of its opcode, from 1
    const std::map<std::uint32_t, Instruction>& all;  // the instruction that defines each ID

    // The definition of an operand, if it has that opcode; else null.
    [[nodiscard]] const Instruction* operand(std::size_t word, std::uint32_t opcode) const {
        const auto found = all.find(at.word(word));
        return found == all.end() || found->second.opcode != opcode ? nullptr : &found->second;
    }
};

struct CompilerFault {
    std::string name;
    std::uint32_t opcode;
    std::function<void(const Place&, Spirv& words)> change;  // to no words: the instruction is left out
    // Whether a driver shows it. Not one that only changes a rounding, and not one that makes loops that
    // never end, which some drivers do not survive.
    bool in_a_driver = true;

    [[nodiscard]] Spirv plant(const Spirv& module) const {
        std::map<std::uint32_t, Instruction> all;
        for (const Instruction& one : shader::instructions(module)) {
            const auto [result, type] = shader::spirv::result_shape(one.opcode);
            if (result) all[one.word(type ? 2 : 1)] = one;
        }
        Spirv changed(module.begin(), module.begin() + 5);
        std::size_t number = 0;
        for (const Instruction& one : shader::instructions(module)) {
            Spirv words(one.words.begin(), one.words.end());
            if (one.opcode == opcode) change({one, ++number, all}, words);
            changed.insert(changed.end(), words.begin(), words.end());
        }
        return changed;
    }
};

// Changes of an instruction.

inline auto swap(std::size_t a, std::size_t b) {
    return [=](const Place&, Spirv& words) {
        if (words.size() > std::max(a, b)) std::swap(words[a], words[b]);
    };
}
inline auto opcode(std::uint32_t other) {
    return [=](const Place&, Spirv& words) { words[0] = (words[0] & 0xffff0000U) | other; };
}
inline auto function(std::uint32_t from, std::uint32_t to) {
    return [=](const Place&, Spirv& words) {
        if (words[4] == from) words[4] = to;
    };
}
inline auto added(std::uint32_t type_opcode, std::uint32_t difference) {
    return [=](const Place& place, Spirv& words) {
        if (place.operand(1, type_opcode) != nullptr && words[3] > 7) words[3] += difference;
    };
}
inline auto every(std::size_t nth) {
    return [=](const Place& place, Spirv& words) {
        if (place.number % nth == 0) words.clear();
    };
}

// The first sum of (a + b) + c, if c is known where that is made; else null.
inline const Instruction* inner_sum(const Place& sum) {
    const Instruction* const inner = sum.operand(3, SpvOpFAdd);
    const auto other = sum.all.find(sum.at.word(4));
    const bool known = inner != nullptr && other != sum.all.end() && other->second.at < inner->at;
    return known ? inner : nullptr;
}
// (a + b) + c as (c + b) + a.
inline void reassociate(const Place& sum, Spirv& words) {
    for (const auto& [id, outer] : sum.all) {
        const Instruction* const inner = outer.opcode == SpvOpFAdd ? inner_sum({outer, 0, sum.all}) : nullptr;
        if (inner != nullptr && inner->at == sum.at.at) words[3] = outer.word(4);
    }
    if (const Instruction* const inner = inner_sum(sum)) words[4] = inner->word(3);
}
// a * b + c as one rounding.
inline void contract(const Place& sum, Spirv& words) {
    const Instruction* const product = sum.operand(3, SpvOpFMul);
    if (product == nullptr) return;
    for (const auto& [id, one] : sum.all)
        if (one.opcode == SpvOpExtInstImport)
            words = shader::instruction(
                SpvOpExtInst, std::vector<std::uint32_t>{sum.at.word(1), sum.at.word(2), id, GLSLstd450Fma,
                                                         product->word(3), product->word(4), sum.at.word(4)});
}
inline void transpose(const Place& place, Spirv& words) {
    opcode(SpvOpVectorTimesMatrix)(place, words);
    std::swap(words[3], words[4]);
}
inline void swap_bounds(const Place&, Spirv& words) {
    if (words[4] == GLSLstd450FClamp) std::swap(words[6], words[7]);
}
inline void swap_sources(const Place&, Spirv& words) {
    if (words.size() == 7) std::swap(words[3], words[5]);
}
inline void extract_other(const Place&, Spirv& words) {
    if (words.size() == 5 && words[4] < 2) words[4] ^= 1U;
}
inline void swap_arguments(const Place& place, Spirv& words) {
    for (std::size_t a = 4; a + 1 < words.size(); ++a)
        if (place.all.at(words[a]).word(1) == place.all.at(words[a + 1]).word(1))
            std::swap(words[a], words[a + 1]);
}
// Of a variable of the function: the constant before, of the same type.
inline void other_element(const Place& place, Spirv& words) {
    const Instruction* const variable = place.operand(3, SpvOpVariable);
    const Instruction* const index = place.operand(4, SpvOpConstant);
    if (variable == nullptr || variable->word(3) != SpvStorageClassFunction || index == nullptr ||
        words.size() != 5)
        return;
    for (const auto& [id, other] : place.all)
        if (other.opcode == SpvOpConstant && other.word(1) == index->word(1) &&
            other.word(3) + 1 == index->word(3))
            words[4] = id;
}

inline std::vector<CompilerFault> compiler_faults() {
    return {{"operands of an integer difference swapped", SpvOpISub, swap(3, 4)},
            {"operands of a difference swapped", SpvOpFSub, swap(3, 4)},
            {"operands of a select swapped", SpvOpSelect, swap(4, 5)},
            {"quotient of the operands swapped", SpvOpSDiv, swap(3, 4)},
            {"signed quotient as unsigned", SpvOpSDiv, opcode(SpvOpUDiv)},
            {"signed shift as unsigned", SpvOpShiftRightArithmetic, opcode(SpvOpShiftRightLogical)},
            {"signed less as unsigned", SpvOpSLessThan, opcode(SpvOpULessThan)},
            {"less as less or equal", SpvOpSLessThan, opcode(SpvOpSLessThanEqual)},
            {"greater turned round without its operands", SpvOpSGreaterThan, opcode(SpvOpSLessThan)},
            {"and as or", SpvOpLogicalAnd, opcode(SpvOpLogicalOr)},
            {"bits of and as or", SpvOpBitwiseAnd, opcode(SpvOpBitwiseOr)},
            {"not left out", SpvOpLogicalNot, opcode(SpvOpCopyObject)},
            {"product as a sum", SpvOpIMul, opcode(SpvOpIAdd)},
            {"signed number read as unsigned", SpvOpConvertSToF, opcode(SpvOpConvertUToF)},
            {"signed field as unsigned", SpvOpBitFieldSExtract, opcode(SpvOpBitFieldUExtract)},
            {"matrix transposed", SpvOpMatrixTimesVector, transpose},
            {"smaller as larger", SpvOpExtInst, function(GLSLstd450FMin, GLSLstd450FMax)},
            {"floor as trunc", SpvOpExtInst, function(GLSLstd450Floor, GLSLstd450Trunc)},
            {"sign for magnitude", SpvOpExtInst, function(GLSLstd450FAbs, GLSLstd450FSign)},
            {"bounds of a clamp swapped", SpvOpExtInst, swap_bounds},
            {"float constants folded one bit off", SpvOpConstant, added(SpvOpTypeFloat, 1)},
            {"integer constants folded one off", SpvOpConstant, added(SpvOpTypeInt, 1)},
            {"sums reassociated although precise", SpvOpFAdd, reassociate},
            {"product and sum contracted although precise", SpvOpFAdd, contract, false},
            {"ways of a branch swapped", SpvOpBranchConditional, swap(2, 3)},
            {"default and case of a switch swapped", SpvOpSwitch, swap(2, 4)},
            {"operands of a phi swapped", SpvOpPhi, swap_sources, false},
            {"other component extracted", SpvOpCompositeExtract, extract_other},
            {"components shuffled otherwise", SpvOpVectorShuffle, swap(5, 6)},
            {"element of an array one off", SpvOpAccessChain, other_element},
            {"arguments of a call swapped", SpvOpFunctionCall, swap_arguments},
            {"every third store dropped", SpvOpStore, every(3)},
            {"every fifth store dropped", SpvOpStore, every(5)}};
}

}  // namespace gloam::test
