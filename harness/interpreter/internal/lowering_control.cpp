// SPDX-License-Identifier: MIT
// Blocks, branches and calls.
#include <fmt/format.h>
#include "interpreter/internal/opcodes.hpp"

#include "interpreter/internal/lowering.hpp"

namespace gloam::interpreter::internal {

bool Lowering::lower_control(const shader::Instruction& i, Scope& scope) {
    switch (i.opcode) {
        case SpvOpLabel:
            scope.block = i.word(1);
            scope.blocks[i.word(1)] = static_cast<std::uint32_t>(code_.instructions.size());
            return true;
        case SpvOpPhi: {
            const Id type = i.word(1);
            if (module_.types.at(type).kind == Type::Kind::pointer)
                fail(Error::Kind::unknown_instruction, "OpPhi of pointers");
            Scope::Phi phi{slot_of(i.word(2), scope), module_.types.slots(type), {}};
            for (std::size_t k = 3; k + 1 < i.words.size(); k += 2)
                phi.values.emplace_back(i.word(k), i.word(k + 1));
            scope.phis[scope.block].push_back(std::move(phi));
            return true;
        }
        case SpvOpBranch: {
            const std::uint32_t edge = edge_to(i.word(1), scope);
            emit(jump, 0, 0).extra = edge;
            return true;
        }
        case SpvOpBranchConditional: {
            const std::uint32_t yes = edge_to(i.word(2), scope);
            const std::uint32_t no = edge_to(i.word(3), scope);
            emit(branch, 0, 0, slot_of(i.word(1), scope), no).extra = yes;
            return true;
        }
        case SpvOpSwitch:
            lower_switch(i, scope);
            return true;
        case SpvOpReturnValue:
            emit(copy, module_.types.slots(scope.function->result_type), scope.result,
                 slot_of(i.word(1), scope));
            [[fallthrough]];
        case SpvOpReturn:
            scope.returns.push_back(new_edge());
            emit(jump, 0, 0).extra = scope.returns.back();
            return true;
        case SpvOpKill:
        case SpvOpTerminateInvocation:
            emit(finish, 0, 0);
            return true;
        case SpvOpUnreachable:
            emit(unreachable, 0, 0);
            return true;
        case SpvOpFunctionCall:
            lower_call(i, scope);
            return true;
        default:
            return false;
    }
}

void Lowering::lower_switch(const shader::Instruction& i, Scope& scope) {
    Switch cases;
    cases.otherwise = edge_to(i.word(2), scope);
    for (std::size_t k = 3; k + 1 < i.words.size(); k += 2)
        cases.cases.emplace_back(i.word(k), edge_to(i.word(k + 1), scope));
    code_.switches.push_back(std::move(cases));
    emit(switch_on, 0, 0, slot_of(i.word(1), scope)).extra =
        static_cast<std::uint32_t>(code_.switches.size() - 1);
}

// Values do not change, so a parameter shares the slots of its argument. A pointer parameter has its
// argument's target.
void Lowering::lower_call(const shader::Instruction& i, Scope& scope) {
    const Function& callee = module_.function(i.word(3));
    if (callee.parameters.size() + 4 != i.words.size())
        fail(Error::Kind::malformed,
             fmt::format("a call of {} with {} arguments, expected {}", module_.name_of(callee.id),
                         i.words.size() - 4, callee.parameters.size()));
    Scope inner;
    for (std::size_t p = 0; p < callee.parameters.size(); ++p) {
        const Id argument = i.word(p + 4);
        inner.types[callee.parameters[p]] = type_of(argument, scope);
        if (module_.types.at(type_of(argument, scope)).kind == Type::Kind::pointer) {
            inner.pointers[callee.parameters[p]] = pointer_of(argument, scope);
        } else {
            inner.slots[callee.parameters[p]] = slot_of(argument, scope);
        }
    }
    if (module_.types.at(callee.result_type).kind != Type::Kind::void_)
        inner.result = slot_of(i.word(2), scope);
    lower_function(callee, inner);
}

}  // namespace gloam::interpreter::internal
