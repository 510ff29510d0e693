// SPDX-License-Identifier: MIT
#include "module/spirv.hpp"

#include <spirv.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <set>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>
#include <stdexcept>

#include "module/module.hpp"

namespace gloam::module {
namespace {

constexpr std::uint32_t magic = 0x07230203u;
constexpr std::size_t header_words = 5;
constexpr std::uint32_t length_shift = 16;
constexpr std::uint32_t opcode_mask = 0xffffu;

constexpr spv_target_env environment = SPV_ENV_VULKAN_1_2;

// Collects what SPIRV-Tools says, one message after the other.
spvtools::MessageConsumer collect_into(std::string& messages) {
    return [&messages](spv_message_level_t level, const char*, const spv_position_t& position,
                       const char* message) {
        if (level > SPV_MSG_ERROR) return;
        if (!messages.empty()) messages += "; ";
        messages += message + std::string(" (word ") + std::to_string(position.index) + ")";
    };
}

// Sets Unroll on every loop that says nothing about unrolling.
void ask_to_unroll(Spirv& module) {
    constexpr std::size_t control = 3;  // the operand's word
    for (const Instruction& i : instructions(module)) {
        if (i.opcode == SpvOpLoopMerge && i.word(control) == SpvLoopControlMaskNone)
            module[i.at + control] = SpvLoopControlUnrollMask;
    }
}

// The module after the passes that `add` registers, not validated.
Spirv after_passes(const Spirv& module, const std::function<void(spvtools::Optimizer&)>& add) {
    std::string messages;
    spvtools::Optimizer optimizer(environment);
    optimizer.SetMessageConsumer(collect_into(messages));
    add(optimizer);
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    Spirv result;
    if (!optimizer.Run(module.data(), module.size(), &result, options))
        throw std::runtime_error("cannot optimise the SPIR-V module: " + messages);
    return result;
}

using spirv::Id;

// FRem to Dot are the remainders, and the products of vectors and matrices.
bool is_float_arithmetic(const Instruction& instruction) {
    constexpr std::array opcodes{SpvOpFNegate, SpvOpFAdd, SpvOpFSub, SpvOpFMul, SpvOpFDiv};
    return std::ranges::find(opcodes, instruction.opcode) != opcodes.end() ||
           (instruction.opcode >= SpvOpFRem && instruction.opcode <= SpvOpDot);
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
    const auto [result, type] = spirv::result_shape(instruction.opcode);
    return result && type && instruction.words.size() > 2;
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
    std::set<Id> already;
    for (const Instruction& i : instructions)
        if (i.opcode == SpvOpDecorate && i.word(2) == static_cast<std::uint32_t>(decoration))
            already.insert(i.word(1));
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

std::string bytes_of(const Spirv& module) {
    return {reinterpret_cast<const char*>(module.data()), module.size() * sizeof(Spirv::value_type)};
}

std::optional<Spirv> module_of(std::string_view bytes) {
    if (bytes.empty() || bytes.size() % sizeof(Spirv::value_type) != 0) return std::nullopt;
    Spirv module(bytes.size() / sizeof(Spirv::value_type));
    std::memcpy(module.data(), bytes.data(), bytes.size());
    return module;
}

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

Spirv without_names(const Spirv& module) {
    Spirv bare;
    for (const Instruction& one : instructions(module))
        if (one.opcode < SpvOpSourceContinued || one.opcode > SpvOpLine)
            bare.insert(bare.end(), one.words.begin(), one.words.end());
    return bare;
}

bool has_float16(const Spirv& module) {
    return std::ranges::any_of(instructions(module), [](const Instruction& one) {
        return one.opcode == SpvOpCapability && one.word(1) == SpvCapabilityFloat16;
    });
}

bool has_loop(const Spirv& module) {
    return std::ranges::any_of(instructions(module),
                               [](const Instruction& one) { return one.opcode == SpvOpLoopMerge; });
}

bool preserves_specials(const Spirv& module) {
    return std::ranges::any_of(instructions(module), [](const Instruction& one) {
        return one.opcode == SpvOpExecutionMode && one.word(2) == SpvExecutionModeSignedZeroInfNanPreserve;
    });
}

std::vector<float> float_constants(const Spirv& module) {
    constexpr std::uint32_t width = 32;
    std::uint32_t type = 0;
    std::set<float> numbers;
    for (const Instruction& one : instructions(module)) {
        if (one.opcode == SpvOpTypeFloat && one.word(2) == width) type = one.word(1);
        if (one.opcode != SpvOpConstant || one.word(1) != type) continue;
        const auto number = std::bit_cast<float>(one.word(3));
        if (std::isfinite(number)) numbers.insert(number + 0.0F);  // -0 as 0, whichever comes first
    }
    return {numbers.begin(), numbers.end()};
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

void validate(const Spirv& module) {
    std::string messages;
    spvtools::SpirvTools tools(environment);
    tools.SetMessageConsumer(collect_into(messages));
    if (!tools.Validate(module)) throw std::runtime_error("invalid SPIR-V: " + messages);
}

Spirv optimize(const Spirv& module, Optimization optimization) {
    if (optimization == Optimization::none) return module;
    Spirv optimized = after_passes(module, [optimization](spvtools::Optimizer& optimizer) {
        if (optimization == Optimization::size)
            optimizer.RegisterSizePasses();
        else
            optimizer.RegisterPerformancePasses();
        if (optimization == Optimization::hoisting || optimization == Optimization::unrolling) {
            optimizer.RegisterPass(spvtools::CreateLoopInvariantCodeMotionPass());
            optimizer.RegisterPass(spvtools::CreateRedundancyEliminationPass());
            optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
        }
    });
    if (optimization == Optimization::unrolling) ask_to_unroll(optimized);
    return optimized;
}

Spirv with_passes(const Spirv& module, const std::vector<std::string>& passes) {
    return after_passes(module, [&passes](spvtools::Optimizer& optimizer) {
        for (const std::string& pass : passes)
            if (!optimizer.RegisterPassFromFlag(pass))
                throw std::runtime_error(pass + " is no pass of SPIRV-Tools");
    });
}

bool is_pass(const std::string& option) {
    spvtools::Optimizer optimizer(environment);
    optimizer.SetMessageConsumer({});
    return optimizer.RegisterPassFromFlag(option);
}

std::string disassemble(const Spirv& module) {
    std::string messages;
    spvtools::SpirvTools tools(environment);
    tools.SetMessageConsumer(collect_into(messages));
    std::string text;
    if (!tools.Disassemble(module, &text))
        throw std::runtime_error("cannot disassemble the SPIR-V module: " + messages);
    return text;
}

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

}  // namespace gloam::module
