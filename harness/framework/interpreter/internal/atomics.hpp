// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "interpreter/internal/integers.hpp"
#include "interpreter/internal/opcodes.hpp"

namespace gloam::interpreter::internal {

// What an atomic operation leaves.
[[nodiscard]] inline Word exchanged(std::uint32_t opcode, Word before, Word operand, Word expected) {
    switch (opcode) {
        case SpvOpAtomicIIncrement:
            return before + 1U;
        case SpvOpAtomicIDecrement:
            return before - 1U;
        case SpvOpAtomicIAdd:
            return before + operand;
        case SpvOpAtomicISub:
            return before - operand;
        case SpvOpAtomicSMin:
            return as_int(operand) < as_int(before) ? operand : before;
        case SpvOpAtomicUMin:
            return std::min(before, operand);
        case SpvOpAtomicSMax:
            return as_int(operand) > as_int(before) ? operand : before;
        case SpvOpAtomicUMax:
            return std::max(before, operand);
        case SpvOpAtomicAnd:
            return before & operand;
        case SpvOpAtomicOr:
            return before | operand;
        case SpvOpAtomicXor:
            return before ^ operand;
        case SpvOpAtomicCompareExchange:
            return before == expected ? operand : before;
        default:
            return operand;  // store and exchange
    }
}

}  // namespace gloam::interpreter::internal
