// SPDX-License-Identifier: MIT
#pragma once

#include <GLSL.std.450.h>
#include <spirv.h>
#include <algorithm>
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

struct CompilerFault {
    std::string name;
    std::function<Spirv(const Spirv&)> plant;
    // Whether a driver shows it. Not one that only changes a rounding, or what a comparison makes of NaN,
    // which Vulkan leaves open to a driver (the first wordings of SignedZeroInfNanPreserve list no
    // comparison); and not one that makes loops that never end, which some drivers do not survive.
    bool in_a_driver = true;
};

// A fault that changes words in place: visit(instruction, its words).
using InPlace = std::function<void(const Instruction& at, std::uint32_t* words)>;

inline CompilerFault in_place(std::string name, InPlace visit) {
    return {std::move(name), [visit = std::move(visit)](const Spirv& module) {
                Spirv changed = module;
                for (const Instruction& one : shader::instructions(module))
                    visit(one, changed.data() + one.at);
                return changed;
            }};
}

inline CompilerFault other_opcode(std::string name, std::uint32_t from, std::uint32_t to,
                                  bool in_a_driver = true) {
    CompilerFault fault = in_place(std::move(name), [from, to](const Instruction& at, std::uint32_t* words) {
        if (at.opcode == from) words[0] = (words[0] & 0xffff0000U) | to;
    });
    fault.in_a_driver = in_a_driver;
    return fault;
}

inline CompilerFault swapped(std::string name, std::uint32_t opcode, std::size_t a, std::size_t b) {
    return in_place(std::move(name), [opcode, a, b](const Instruction& at, std::uint32_t* words) {
        if (at.opcode == opcode && at.words.size() > std::max(a, b)) std::swap(words[a], words[b]);
    });
}

inline CompilerFault other_function(std::string name, std::uint32_t from, std::uint32_t to) {
    return in_place(std::move(name), [from, to](const Instruction& at, std::uint32_t* words) {
        if (at.opcode == SpvOpExtInst && at.word(4) == from) words[4] = to;
    });
}

// A fault that leaves instructions out.
inline CompilerFault dropped(std::string name,
                             std::function<bool(const Instruction&, std::size_t number)> drops) {
    return {std::move(name), [drops = std::move(drops)](const Spirv& module) {
                Spirv changed(module.begin(), module.begin() + 5);
                std::size_t number = 0;
                for (const Instruction& one : shader::instructions(module))
                    if (!drops(one, number++))
                        changed.insert(changed.end(), one.words.begin(), one.words.end());
                return changed;
            }};
}

// The instruction that defines each ID.
inline std::map<std::uint32_t, Instruction> definitions(const Spirv& module) {
    std::map<std::uint32_t, Instruction> found;
    for (const Instruction& one : shader::instructions(module)) {
        const auto [result, type] = shader::spirv::result_shape(one.opcode);
        if (result) found[one.word(type ? 2 : 1)] = one;
    }
    return found;
}

inline CompilerFault with_definitions(
    std::string name,
    std::function<void(const Instruction&, std::uint32_t* words, const std::map<std::uint32_t, Instruction>&)>
        visit) {
    return {std::move(name), [visit = std::move(visit)](const Spirv& module) {
                Spirv changed = module;
                const auto all = definitions(module);
                for (const Instruction& one : shader::instructions(module))
                    visit(one, changed.data() + one.at, all);
                return changed;
            }};
}

// Whether an ID is a variable of a function.
inline bool is_local(std::uint32_t id, const std::map<std::uint32_t, Instruction>& all) {
    const auto found = all.find(id);
    return found != all.end() && found->second.opcode == SpvOpVariable &&
           found->second.word(3) == SpvStorageClassFunction;
}

inline CompilerFault constants_changed(std::string name, std::uint32_t type_opcode,
                                       std::uint32_t difference) {
    return with_definitions(
        std::move(name), [=](const Instruction& at, std::uint32_t* words, const auto& all) {
            if (at.opcode == SpvOpConstant && all.at(at.word(1)).opcode == type_opcode && at.word(3) > 7)
                words[3] += difference;
        });
}

// (a + b) + c as a + (b + c), although each sum is `precise`.
inline CompilerFault reassociated() {
    return {"sums reassociated although precise", [](const Spirv& module) {
                Spirv changed = module;
                const auto all = definitions(module);
                for (const Instruction& sum : shader::instructions(module)) {
                    if (sum.opcode != SpvOpFAdd) continue;
                    const auto inner = all.find(sum.word(3));
                    if (inner == all.end() || inner->second.opcode != SpvOpFAdd) continue;
                    const auto other = all.find(sum.word(4));
                    if (other == all.end() || other->second.at > inner->second.at) continue;
                    const std::uint32_t a = inner->second.word(3);
                    changed[inner->second.at + 3] = sum.word(4);
                    changed[sum.at + 4] = a;
                }
                return changed;
            }};
}

// a * b + c as one rounding, although both are `precise`.
inline CompilerFault contracted() {
    return {"product and sum contracted although precise",
            [](const Spirv& module) {
                const auto all = definitions(module);
                std::uint32_t glsl = 0;
                for (const auto& [id, one] : all)
                    if (one.opcode == SpvOpExtInstImport) glsl = id;
                Spirv changed(module.begin(), module.begin() + 5);
                for (const Instruction& sum : shader::instructions(module)) {
                    const auto product = sum.opcode == SpvOpFAdd ? all.find(sum.word(3)) : all.end();
                    const bool contracts = product != all.end() && product->second.opcode == SpvOpFMul;
                    Spirv words{sum.words.begin(), sum.words.end()};
                    if (contracts)
                        words = shader::instruction(
                            SpvOpExtInst, std::vector<std::uint32_t>{sum.word(1), sum.word(2), glsl,
                                                                     GLSLstd450Fma, product->second.word(3),
                                                                     product->second.word(4), sum.word(4)});
                    changed.insert(changed.end(), words.begin(), words.end());
                }
                return changed;
            },
            false};
}

inline std::vector<CompilerFault> faults_of_values() {
    return {
        swapped("operands of an integer difference swapped", SpvOpISub, 3, 4),
        swapped("operands of a difference swapped", SpvOpFSub, 3, 4),
        swapped("operands of a select swapped", SpvOpSelect, 4, 5),
        swapped("quotient of the operands swapped", SpvOpSDiv, 3, 4),
        other_opcode("signed quotient as unsigned", SpvOpSDiv, SpvOpUDiv),
        other_opcode("signed shift as unsigned", SpvOpShiftRightArithmetic, SpvOpShiftRightLogical),
        other_opcode("signed less as unsigned", SpvOpSLessThan, SpvOpULessThan),
        other_opcode("less as less or equal", SpvOpSLessThan, SpvOpSLessThanEqual),
        other_opcode("greater turned round without its operands", SpvOpSGreaterThan, SpvOpSLessThan),
        other_opcode("ordered less as unordered: NaN lost", SpvOpFOrdLessThan, SpvOpFUnordLessThan, false),
        other_opcode("and as or", SpvOpLogicalAnd, SpvOpLogicalOr),
        other_opcode("bits of and as or", SpvOpBitwiseAnd, SpvOpBitwiseOr),
        other_opcode("not left out", SpvOpLogicalNot, SpvOpCopyObject),
        other_opcode("product as a sum", SpvOpIMul, SpvOpIAdd),
        other_opcode("signed number read as unsigned", SpvOpConvertSToF, SpvOpConvertUToF),
        other_opcode("signed field as unsigned", SpvOpBitFieldSExtract, SpvOpBitFieldUExtract),
        in_place("matrix transposed",
                 [](const Instruction& at, std::uint32_t* words) {
                     if (at.opcode != SpvOpMatrixTimesVector) return;
                     words[0] = (words[0] & 0xffff0000U) | SpvOpVectorTimesMatrix;
                     std::swap(words[3], words[4]);
                 }),
        other_function("smaller as larger", GLSLstd450FMin, GLSLstd450FMax),
        other_function("floor as trunc", GLSLstd450Floor, GLSLstd450Trunc),
        other_function("sign for magnitude", GLSLstd450FAbs, GLSLstd450FSign),
        in_place("bounds of a clamp swapped",
                 [](const Instruction& at, std::uint32_t* words) {
                     if (at.opcode == SpvOpExtInst && at.word(4) == GLSLstd450FClamp)
                         std::swap(words[6], words[7]);
                 }),
        constants_changed("float constants folded one bit off", SpvOpTypeFloat, 1),
        constants_changed("integer constants folded one off", SpvOpTypeInt, 1),
        reassociated(),
        contracted()};
}

inline CompilerFault phis_swapped() {
    CompilerFault fault =
        in_place("operands of a phi swapped", [](const Instruction& at, std::uint32_t* words) {
            if (at.opcode == SpvOpPhi && at.words.size() == 7) std::swap(words[3], words[5]);
        });
    fault.in_a_driver = false;
    return fault;
}

inline std::vector<CompilerFault> faults_of_memory_and_flow() {
    const auto extract = [](const Instruction& at, std::uint32_t* words) {
        if (at.opcode == SpvOpCompositeExtract && at.words.size() == 5 && at.word(4) < 2) words[4] ^= 1U;
    };
    const auto shuffle = [](const Instruction& at, std::uint32_t* words) {
        if (at.opcode == SpvOpVectorShuffle) std::swap(words[5], words[6]);
    };
    const auto arguments = [](const Instruction& at, std::uint32_t* words, const auto& all) {
        if (at.opcode != SpvOpFunctionCall) return;
        for (std::size_t a = 4; a + 1 < at.words.size(); ++a)
            if (all.at(words[a]).word(1) == all.at(words[a + 1]).word(1)) std::swap(words[a], words[a + 1]);
    };
    const auto index = [](const Instruction& at, std::uint32_t* words, const auto& all) {
        const bool one = at.opcode == SpvOpAccessChain && at.words.size() == 5 && is_local(at.word(3), all);
        if (!one || all.at(at.word(4)).opcode != SpvOpConstant) return;
        for (const auto& [id, other] : all)  // the constant before, of the same type
            if (other.opcode == SpvOpConstant && other.word(1) == all.at(at.word(4)).word(1) &&
                other.word(3) + 1 == all.at(at.word(4)).word(3))
                words[4] = id;
    };
    const auto every = [](std::uint32_t opcode, std::size_t nth) {
        return [opcode, nth, seen = std::size_t{0}](const Instruction& at, std::size_t number) mutable {
            if (number == 0) seen = 0;
            return at.opcode == opcode && ++seen % nth == 0;
        };
    };
    return {swapped("ways of a branch swapped", SpvOpBranchConditional, 2, 3),
            swapped("default and case of a switch swapped", SpvOpSwitch, 2, 4),
            phis_swapped(),
            in_place("other component extracted", extract),
            in_place("components shuffled otherwise", shuffle),
            with_definitions("element of an array one off", index),
            with_definitions("arguments of a call swapped", arguments),
            dropped("every third store dropped", every(SpvOpStore, 3)),
            dropped("every fifth store dropped", every(SpvOpStore, 5))};
}

}  // namespace gloam::test
