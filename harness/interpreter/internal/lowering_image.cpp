// SPDX-License-Identifier: MIT
// Images: fetches, loads, stores and sizes, without filtering.
#include "interpreter/internal/lowering.hpp"
#include "interpreter/internal/opcodes.hpp"

namespace gloam::interpreter::internal {

bool Lowering::lower_image(const shader::Instruction& i, Scope& scope) {
    const auto operand = [&](std::size_t word) { return slot_of(i.word(word), scope); };
    const auto components = [&](std::size_t word) {
        return module_.types.slots(type_of(i.word(word), scope));
    };
    switch (i.opcode) {
        case SpvOpImage:
        case SpvOpSampledImage:
            emit(copy, 1, operand(2), operand(3));
            return true;
        case SpvOpImageFetch:
        case SpvOpImageRead: {
            // How integers of fewer bits become 32: texels are given with 32.
            constexpr std::uint32_t extensions =
                SpvImageOperandsSignExtendMask | SpvImageOperandsZeroExtendMask;
            const std::uint32_t operands = i.words.size() > 5 ? i.word(5) & ~extensions : 0;
            if (operands != SpvImageOperandsLodMask && operands != SpvImageOperandsMaskNone)
                fail(Error::Kind::unknown_instruction, "a fetch with an offset, a sample or a gradient");
            Instruction& instruction =
                emit(image_load, module_.types.slots(i.word(1)), operand(2), operand(3), operand(4));
            instruction.c = components(4);
            instruction.flags = flags_of(i.word(2), i.word(1));
            // Without a level operand it reads level 0.
            instruction.extra = operands == SpvImageOperandsLodMask ? operand(6) + 1 : 0;
            return true;
        }
        case SpvOpImageWrite: {
            Instruction& instruction =
                emit(image_store, components(3), 0, operand(1), operand(2), operand(3));
            instruction.extra = components(2);
            for (Resource& resource : code_.resources)
                resource.written = resource.written || resource.kind == Resource::Kind::image;
            return true;
        }
        case SpvOpImageQuerySize:
        case SpvOpImageQuerySizeLod: {
            Instruction& instruction =
                emit(image_size, module_.types.slots(i.word(1)), operand(2), operand(3));
            instruction.extra = i.opcode == SpvOpImageQuerySizeLod ? operand(4) + 1 : 0;
            return true;
        }
        default:
            return false;
    }
}

}  // namespace gloam::interpreter::internal
