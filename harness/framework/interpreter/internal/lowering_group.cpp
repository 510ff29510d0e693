// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "interpreter/internal/lowering.hpp"
#include "interpreter/internal/opcodes.hpp"

// What invocations of a quad or a group do together: derivatives, barriers, subgroup operations.
namespace gloam::interpreter::internal {

bool Lowering::is_used(Id result) const {
    // A literal of the same value counts, too; it does no harm.
    return std::ranges::any_of(scope_.function->body, [result](const module::Instruction& i) {
        const auto [has_result, has_type] = module::spirv::result_shape(i.opcode);
        const bool makes_it = has_result && has_type && i.word(2) == result;
        return std::ranges::count(i.words, result) > (makes_it ? 1 : 0);
    });
}

void Lowering::lower_group(const module::Instruction& i) {
    const auto constant = [&](std::size_t word) {
        const auto value = module_.integer(i.word(word));
        if (!value) fail(Error::Kind::unknown_instruction, "a barrier of a computed scope");
        return *value;
    };
    if (i.opcode == SpvOpControlBarrier) {
        emit(barrier, 0, 0, 0, 0, constant(3)).extra = constant(1);
        return;
    }
    if (i.opcode == SpvOpMemoryBarrier) {
        emit(fence, 0, 0, 0, 0, constant(2));
        return;
    }
    if (i.opcode >= SpvOpDPdx && i.opcode <= SpvOpFwidthCoarse) return lower_derivative(i);
    if (i.opcode >= SpvOpGroupNonUniformElect && i.opcode <= SpvOpGroupNonUniformQuadSwap)
        return lower_collective(i);
    lower_operation(i);
}

constexpr std::uint8_t of_derivative = flags::no_contraction | flags::derivative;

// The difference between the two invocations of a row or a column of the quad.
Slot Lowering::lower_difference(Slot of, std::uint32_t count, std::uint32_t pick, std::uint8_t how) {
    const Slot low = new_slots(count);
    const Slot high = new_slots(count);
    const Slot result = new_slots(count);
    emit(neighbour, count, low, of).extra = pick;
    emit(neighbour, count, high, of).extra = pick | second;
    emit(SpvOpFSub, count, result, high, low).flags = how | of_derivative;
    return result;
}

// A fine derivative is that of the invocation's own row or column; another may be of either one.
Slot Lowering::lower_slope(Slot of, std::uint32_t count, std::uint32_t axis, std::uint8_t how, bool fine) {
    const Slot own = lower_difference(of, count, axis, how);
    if (fine) return own;
    const Slot other = lower_difference(of, count, axis | other_line, how);
    const Slot any = new_slots(count);
    emit(either, count, any, own, other).flags = how;
    return any;
}

void Lowering::lower_derivative(const module::Instruction& i) {
    constexpr std::uint32_t kinds = 3;  // along x, along y, the sum of both magnitudes
    const std::uint32_t kind = (i.opcode - SpvOpDPdx) % kinds;
    const bool fine = (i.opcode - SpvOpDPdx) / kinds == 1;
    const std::uint32_t count = module_.types.slots(i.word(1));
    const Slot of = slot_of(i.word(3));
    const Slot result = slot_of(i.word(2));
    const std::uint8_t how = flags_of(i.word(2), i.word(1));
    if (kind < 2) {
        emit(copy, count, result, lower_slope(of, count, kind == 0 ? row : column, how, fine));
        return;
    }
    std::array<Slot, 2> magnitudes{};
    for (std::uint32_t axis = 0; axis < 2; ++axis) {
        const Slot slope = lower_slope(of, count, axis == 0 ? row : column, how, fine);
        magnitudes.at(axis) = new_slots(count);
        emit(extended + GLSLstd450FAbs, count, magnitudes.at(axis), slope).flags = how;
    }
    emit(SpvOpFAdd, count, result, magnitudes[0], magnitudes[1]).flags = how | of_derivative;
}

// Of a sampler without a level: its coordinates, divided if they are projected, whose derivatives select the
// level.
Lowering::Coordinates Lowering::lower_gradients(const module::Instruction& i, Coordinates at, Sampling& how) {
    const Type& sampled = module_.types.at(type_of(i.word(3)));
    how.gradients = dimensions_of(module_.types.at(sampled.element));
    if (std::exchange(how.projected, false)) {
        const Slot divided = new_slots(how.gradients);
        const Slot divisor = at.first + at.count - 1;
        emit(SpvOpFDiv, how.gradients, divided, at.first, divisor).stride = 0;
        at = {divided, how.gradients};
        if (how.reference) {
            const Slot reference = new_slots(1);
            emit(SpvOpFDiv, 1, reference, *how.reference, divisor);
            how.reference = reference;
        }
    }
    how.implicit = true;
    how.dx = lower_slope(at.first, how.gradients, row, 0, false);
    how.dy = lower_slope(at.first, how.gradients, column, 0, false);
    return at;
}

void Lowering::lower_collective(const module::Instruction& i) {
    constexpr std::size_t first_operand = 4;  // behind the type, the result and the scope
    const auto constant = module_.integer(i.word(3));
    if (!constant || *constant != SpvScopeSubgroup)
        fail(Error::Kind::unknown_instruction, "an operation of a group that is no subgroup");
    std::size_t word = first_operand;
    const bool reduces = i.opcode >= SpvOpGroupNonUniformIAdd && i.opcode <= SpvOpGroupNonUniformLogicalXor;
    std::uint32_t operation = 0;
    if (reduces || i.opcode == SpvOpGroupNonUniformBallotBitCount) operation = i.word(word++);
    std::array<Slot, 2> operands{};
    std::uint32_t components = 0;
    for (std::size_t k = 0; k < operands.size() && word < i.words.size(); ++k, ++word) {
        if (k == 0) components = module_.types.slots(type_of(i.word(word)));
        operands.at(k) = slot_of(i.word(word));
    }
    if (operation > SpvGroupOperationClusteredReduce)
        fail(Error::Kind::unknown_instruction, fmt::format("the group operation {}", operation));
    Instruction& instruction = emit_for(i, collective, operands[0], operands[1], i.opcode);
    instruction.stride = static_cast<std::uint8_t>(components);
    instruction.extra = operation;
}

}  // namespace gloam::interpreter::internal
