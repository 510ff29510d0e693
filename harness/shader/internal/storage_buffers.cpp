// SPDX-License-Identifier: MIT
#include "shader/internal/storage_buffers.hpp"

#include <spirv.h>

#include <set>
#include <stdexcept>

#include "shader/instructions.hpp"

namespace gloam::shader::internal {

Spirv with_storage_buffers(Spirv module) {
    // Words of an instruction, the first one included.
    constexpr std::size_t decorated = 1;
    constexpr std::size_t decoration = 2;
    constexpr std::size_t class_of_pointer = 2;
    constexpr std::size_t pointee = 3;
    constexpr std::size_t class_of_variable = 3;
    std::set<std::uint32_t> uniform_blocks;
    const Spirv before = module;
    for (const Instruction& i : instructions(before)) {
        const bool decorates = i.opcode == SpvOpDecorate;
        if (decorates && i.word(decoration) == SpvDecorationBufferBlock)
            module[i.at + decoration] = SpvDecorationBlock;
        if (decorates && i.word(decoration) == SpvDecorationBlock) uniform_blocks.insert(i.word(decorated));
        if (i.opcode == SpvOpTypePointer && i.word(class_of_pointer) == SpvStorageClassUniform) {
            if (uniform_blocks.contains(i.word(pointee)))
                throw std::runtime_error("uniform buffers beside storage buffers: expected push constants");
            module[i.at + class_of_pointer] = SpvStorageClassStorageBuffer;
        }
        if (i.opcode == SpvOpVariable && i.word(class_of_variable) == SpvStorageClassUniform)
            module[i.at + class_of_variable] = SpvStorageClassStorageBuffer;
    }
    return module;
}

}  // namespace gloam::shader::internal
