// SPDX-License-Identifier: MIT
#include "shader/spirv.hpp"

#include <spirv.h>

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include "shader/instructions.hpp"

namespace gloam::shader {
namespace {

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

}  // namespace

void validate(const Spirv& module) {
    std::string messages;
    spvtools::SpirvTools tools(environment);
    tools.SetMessageConsumer(collect_into(messages));
    if (!tools.Validate(module)) throw std::runtime_error("invalid SPIR-V: " + messages);
}

Spirv optimize(const Spirv& module, Optimization optimization) {
    if (optimization == Optimization::none) return module;
    std::string messages;
    spvtools::Optimizer optimizer(environment);
    optimizer.SetMessageConsumer(collect_into(messages));
    if (optimization == Optimization::size)
        optimizer.RegisterSizePasses();
    else
        optimizer.RegisterPerformancePasses();
    if (optimization == Optimization::hoisting || optimization == Optimization::unrolling) {
        optimizer.RegisterPass(spvtools::CreateLoopInvariantCodeMotionPass());
        optimizer.RegisterPass(spvtools::CreateRedundancyEliminationPass());
        optimizer.RegisterPass(spvtools::CreateAggressiveDCEPass());
    }
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    Spirv optimized;
    if (!optimizer.Run(module.data(), module.size(), &optimized, options))
        throw std::runtime_error("cannot optimise the SPIR-V module: " + messages);
    if (optimization == Optimization::unrolling) ask_to_unroll(optimized);
    return optimized;
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

}  // namespace gloam::shader
