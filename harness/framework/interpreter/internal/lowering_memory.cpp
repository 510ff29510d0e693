// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "interpreter/internal/lowering.hpp"
#include "interpreter/internal/opcodes.hpp"
#include "interpreter/machine.hpp"

// Variables, access chains, loads and stores, atomics and images.
namespace gloam::interpreter::internal {
namespace {

using Space = PointerInfo::Space;

// A partly resolved access chain: the target so far, and the steps that depend on run-time indices.
struct Walk {
    const Types& types;
    PointerInfo at;
    std::vector<Chain::Step> steps;

    // Whether scalars follow one another, without offsets and strides of the module.
    [[nodiscard]] bool in_slots() const { return at.space != Space::memory; }
    // Of a pointer's offset, for each slot.
    [[nodiscard]] std::uint32_t unit() const { return at.space == Space::shared ? sizeof(Word) : 1; }

    // The distance between elements of the pointee, and their number (0: unknown).
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> element() const {
        const Type& type = types.at(at.pointee);
        if (in_slots()) return {types.slots(type.element) * unit(), type.count};
        switch (type.kind) {
            case Type::Kind::vector:
                return {at.scalar_stride == 0 ? types.scalar_bytes(type.element) : at.scalar_stride,
                        type.count};
            case Type::Kind::matrix:
                return {at.matrix.row_major ? types.scalar_bytes(type.element) : at.matrix.stride,
                        type.count};
            default:
                return {type.array_stride, type.count};
        }
    }

    void enter_member(std::uint32_t index) {
        const Type& type = types.at(at.pointee);
        if (index >= type.members.size())
            throw Error(Error::Kind::malformed, "a structure without such a member");
        const module::spirv::Member& member = type.members[index];
        if (in_slots()) {
            for (std::uint32_t m = 0; m < index; ++m)
                at.target.offset += types.slots(type.members[m].type) * unit();
        } else {
            at.target.offset += member.offset;
            at.matrix = member.matrix;
        }
        at.pointee = member.type;
    }

    void enter_element() {
        const Type& type = types.at(at.pointee);
        at.scalar_stride = type.kind == Type::Kind::matrix && at.matrix.row_major ? at.matrix.stride : 0;
        at.pointee = type.element;
    }
};

}  // namespace

void Lowering::lower_memory(const module::Instruction& i) {
    switch (i.opcode) {
        case SpvOpVariable:
            return lower_local_variable(i);
        case SpvOpAccessChain:
        case SpvOpInBoundsAccessChain:
            return lower_access_chain(i);
        case SpvOpLoad:
            load(slot_of(i.word(2)), pointer_of(i.word(3)), flags_of(i.word(2), i.word(1)));
            return;
        case SpvOpStore:
            store(pointer_of(i.word(1)), slot_of(i.word(2)));
            return;
        case SpvOpCopyMemory: {
            const PointerInfo& from = pointer_of(i.word(2));
            const Slot between = new_slots(module_.types.slots(from.pointee));
            load(between, from, 0);
            store(pointer_of(i.word(1)), between);
            return;
        }
        case SpvOpImageTexelPointer: {
            const PointerInfo& image = pointer_of(i.word(3));
            PointerInfo texel{.space = PointerInfo::Space::memory,
                              .is_static = false,
                              .target = image.target,
                              .index = new_pointer(),
                              .pointee = module_.types.at(i.word(1)).element};
            emit(image_texel, 1, texel.index, pointer_index(image), slot_of(i.word(4)),
                 module_.types.slots(type_of(i.word(4))));
            scope_.pointers[i.word(2)] = texel;
            return;
        }
        case SpvOpArrayLength: {
            Walk walk{module_.types, pointer_of(i.word(3)), {}};
            walk.enter_member(i.word(4));
            emit(array_length, 1, slot_of(i.word(2)), pointer_index(walk.at)).extra = walk.element().first;
            return;
        }
        default:
            return lower_composite(i);
    }
}

void Lowering::lower_local_variable(const module::Instruction& i) {
    PointerInfo info{.pointee = module_.types.at(i.word(1)).element};
    const std::uint32_t count = module_.types.slots(info.pointee);
    info.target.offset = new_slots(count);
    if (i.words.size() > 4) {
        emit(copy, count, info.target.offset, slot_of(i.word(4)));
    } else {
        undefine_variable(info, count, module_.name_of(i.word(2)));
    }
    scope_.pointers[i.word(2)] = info;
}

void Lowering::lower_access_chain(const module::Instruction& i) {
    Walk walk{module_.types, pointer_of(i.word(3)), {}};
    const bool from_static = walk.at.is_static;
    if (!from_static) walk.at.target.offset = 0;
    for (std::size_t k = 4; k < i.words.size(); ++k) {
        const Type& type = module_.types.at(walk.at.pointee);
        const auto constant = module_.integer(i.word(k));
        if (type.kind == Type::Kind::structure) {
            if (!constant || *constant >= type.members.size())
                fail(Error::Kind::malformed, "a structure without such a member");
            walk.enter_member(*constant);
            continue;
        }
        if (type.element == 0 || type.kind == Type::Kind::pointer || walk.at.space == Space::resource)
            fail(Error::Kind::unknown_instruction, "an access chain into something without elements");
        const auto [stride, length] = walk.element();
        // A constant outside is an error of the run that gets there.
        if (constant && (length == 0 || *constant < length)) {
            const std::uint64_t offset = walk.at.target.offset + std::uint64_t{*constant} * stride;
            if (offset > 0xffffffffU) fail(Error::Kind::out_of_bounds, fmt::format("element {}", *constant));
            walk.at.target.offset = static_cast<std::uint32_t>(offset);
        } else {
            const Type& index = module_.types.at(type_of(i.word(k)));
            walk.steps.push_back({slot_of(i.word(k)), index.is_signed, stride, length});
        }
        walk.enter_element();
    }
    if (!from_static || !walk.steps.empty()) {
        Chain chain_of{
            .from_static = from_static, .from = walk.at.index, .base = walk.at.target, .steps = walk.steps};
        walk.at.is_static = false;
        walk.at.index = new_pointer();
        code_.chains.push_back(std::move(chain_of));
        emit(chain, 0, walk.at.index).extra = static_cast<std::uint32_t>(code_.chains.size() - 1);
    }
    scope_.pointers[i.word(2)] = walk.at;
}

void Lowering::list_offsets(const PointerInfo& pointer, Instruction& instruction) {
    std::vector<std::uint32_t> offsets;
    if (pointer.space == Space::shared) {
        for (std::uint32_t k = 0; k < module_.types.slots(pointer.pointee); ++k)
            offsets.push_back(k * static_cast<std::uint32_t>(sizeof(Word)));
    } else {
        module_.types.append_offsets(pointer.pointee, pointer.matrix, pointer.scalar_stride, 0, offsets);
    }
    instruction.extra = new_list(offsets);
}

void Lowering::load(Slot result, const PointerInfo& from, std::uint8_t how) {
    const std::uint32_t count = module_.types.slots(from.pointee);
    if (from.space == Space::resource) {
        emit(load_resource, 1, result, pointer_index(from));
    } else if (from.space != Space::slots) {
        Instruction& instruction = emit(load_memory, count, result, pointer_index(from));
        instruction.flags = how;
        list_offsets(from, instruction);
    } else if (from.is_static) {
        emit(copy, count, result, from.target.offset).flags = how;
    } else {
        emit(load_slots, count, result, from.index).flags = how;
    }
}

void Lowering::store(const PointerInfo& to, Slot value) {
    const std::uint32_t count = module_.types.slots(to.pointee);
    if (to.space == Space::resource) fail(Error::Kind::malformed, "a store to an image's variable");
    if (to.space != Space::slots) {
        list_offsets(to, emit(store_memory, count, 0, pointer_index(to), value));
        code_.resources[to.target.resource].written = true;
    } else if (to.is_static) {
        emit(copy, count, to.target.offset, value);
    } else {
        emit(store_slots, count, 0, to.index, value);
    }
}

void Lowering::lower_atomic(const module::Instruction& i) {
    const bool is_known = i.opcode >= SpvOpAtomicLoad && i.opcode <= SpvOpAtomicXor &&
                          i.opcode != SpvOpAtomicCompareExchangeWeak;
    if (!is_known) return lower_image(i);
    const bool is_store = i.opcode == SpvOpAtomicStore;
    const PointerInfo& pointer = pointer_of(i.word(is_store ? 1 : 3));
    if (pointer.space == Space::resource)
        fail(Error::Kind::unknown_instruction, "an atomic operation on an image");
    const Slot result = is_store ? new_slots(1) : slot_of(i.word(2));
    const bool in_memory = pointer.space != Space::slots;
    Instruction& instruction = emit(atomic, in_memory ? 1 : 0, result, pointer_index(pointer), 0, i.opcode);
    if (in_memory) code_.resources[pointer.target.resource].written = true;
    if (!is_store && is_used(i.word(2))) instruction.flags |= flags::result_is_used;
    const bool has_no_operand =
        i.opcode == SpvOpAtomicLoad || i.opcode == SpvOpAtomicIIncrement || i.opcode == SpvOpAtomicIDecrement;
    const bool compares = i.opcode == SpvOpAtomicCompareExchange;
    if (!has_no_operand) instruction.b = slot_of(i.word(is_store ? 4 : compares ? 7 : 6));
    if (compares) instruction.extra = slot_of(i.word(8));
}

// Blocks, branches and calls.

void Lowering::lower_control(const module::Instruction& i) {
    switch (i.opcode) {
        case SpvOpLabel:
            scope_.block = i.word(1);
            scope_.blocks[i.word(1)] = static_cast<std::uint32_t>(code_.instructions.size());
            return;
        case SpvOpPhi: {
            const Id type = i.word(1);
            if (module_.types.at(type).kind == Type::Kind::pointer)
                fail(Error::Kind::unknown_instruction, "OpPhi of pointers");
            Scope::Phi phi{slot_of(i.word(2)), module_.types.slots(type), {}};
            for (std::size_t k = 3; k + 1 < i.words.size(); k += 2)
                phi.values.emplace_back(i.word(k), i.word(k + 1));
            scope_.phis[scope_.block].push_back(std::move(phi));
            return;
        }
        case SpvOpSelectionMerge:
        case SpvOpLoopMerge:
            if (module_.meets()) {
                const std::uint32_t behind = edge_to(i.word(1));
                const std::uint32_t continues = i.opcode == SpvOpLoopMerge ? edge_to(i.word(2)) + 1 : 0;
                emit(construct, 0, 0, 0, continues).extra = behind;
            }
            return;
        case SpvOpBranch: {
            const std::uint32_t edge = edge_to(i.word(1));
            emit(jump, 0, 0).extra = edge;
            return;
        }
        case SpvOpBranchConditional: {
            const std::uint32_t yes = edge_to(i.word(2));
            const std::uint32_t no = edge_to(i.word(3));
            emit(branch, 0, 0, slot_of(i.word(1)), no).extra = yes;
            return;
        }
        case SpvOpSwitch:
            return lower_switch(i);
        case SpvOpReturnValue:
            if (module_.undefined.contains(i.word(1)))  // the end of a function, without a value
                emit(undefine, module_.types.slots(scope_.function->result_type), scope_.result);
            else
                emit(copy, module_.types.slots(scope_.function->result_type), scope_.result,
                     slot_of(i.word(1)));
            [[fallthrough]];
        case SpvOpReturn:
            scope_.returns.push_back(new_edge());
            emit(jump, 0, 0).extra = scope_.returns.back();
            return;
        case SpvOpKill:
        case SpvOpTerminateInvocation:
            emit(finish, 0, 0);
            return;
        case SpvOpUnreachable:
            emit(unreachable, 0, 0);
            return;
        case SpvOpFunctionCall:
            return lower_call(i);
        default:
            return lower_memory(i);
    }
}

void Lowering::lower_switch(const module::Instruction& i) {
    Switch cases;
    cases.otherwise = edge_to(i.word(2));
    for (std::size_t k = 3; k + 1 < i.words.size(); k += 2)
        cases.cases.emplace_back(i.word(k), edge_to(i.word(k + 1)));
    code_.switches.push_back(std::move(cases));
    emit(switch_on, 0, 0, slot_of(i.word(1))).extra = static_cast<std::uint32_t>(code_.switches.size() - 1);
}

// Values do not change, so a parameter shares the slots of its argument. A pointer parameter has its
// argument's target.
void Lowering::lower_call(const module::Instruction& i) {
    const Function& callee = module_.function(i.word(3));
    if (callee.parameters.size() + 4 != i.words.size())
        fail(Error::Kind::malformed,
             fmt::format("a call of {} with {} arguments, expected {}", module_.name_of(callee.id),
                         i.words.size() - 4, callee.parameters.size()));
    Scope inner;
    for (std::size_t p = 0; p < callee.parameters.size(); ++p) {
        const Id argument = i.word(p + 4);
        inner.types[callee.parameters[p]] = type_of(argument);
        if (module_.types.at(type_of(argument)).kind == Type::Kind::pointer) {
            const PointerInfo& to = inner.pointers[callee.parameters[p]] = pointer_of(argument);
            // The front end passes out parameters by a variable that the source does not have.
            if (to.variable != 0 && module_.name_of(argument) == "param")
                code_.variables[to.variable] = module_.name_of(callee.parameters[p]);
        } else {
            inner.slots[callee.parameters[p]] = slot_of(argument);
        }
    }
    if (module_.types.at(callee.result_type).kind != Type::Kind::void_) inner.result = slot_of(i.word(2));
    std::swap(scope_, inner);
    lower_function(callee);
    scope_ = std::move(inner);
}

}  // namespace gloam::interpreter::internal
