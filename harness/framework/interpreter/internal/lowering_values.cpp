// SPDX-License-Identifier: MIT
#include "interpreter/internal/lowering.hpp"

#include <fmt/format.h>

#include "interpreter/internal/conversions.hpp"
#include "interpreter/internal/opcodes.hpp"

// Composites, matrices and all operations on single components.
namespace gloam::interpreter::internal {
namespace {

// Slot and type of the part that literal indices select.
std::pair<Slot, Id> part_of(const Types& types, Slot slot, Id type_id,
                            std::span<const std::uint32_t> indices) {
    for (const std::uint32_t index : indices) {
        const Type& type = types.at(type_id);
        if (type.kind == Type::Kind::structure) {
            if (index >= type.members.size())
                throw Error(Error::Kind::malformed, "a structure without such a member");
            for (std::uint32_t m = 0; m < index; ++m) slot += types.slots(type.members[m].type);
            type_id = type.members[index].type;
        } else {
            if (index >= type.count)
                throw Error(Error::Kind::malformed, "a composite without such a component");
            slot += index * types.slots(type.element);
            type_id = type.element;
        }
    }
    return {slot, type_id};
}

// What an instruction asks of a sampler.
struct SamplingForm {
    bool implicit = false;  // the level
    bool compares = false;
    bool projected = false;
    bool gathers = false;
};

std::optional<SamplingForm> form_of(std::uint32_t opcode) {
    if (opcode == SpvOpImageGather || opcode == SpvOpImageDrefGather)
        return SamplingForm{.compares = opcode == SpvOpImageDrefGather, .gathers = true};
    if (opcode < SpvOpImageSampleImplicitLod || opcode > SpvOpImageSampleProjDrefExplicitLod)
        return std::nullopt;
    // They alternate: with an implicit level, with an explicit one; two that compare follow two that do not.
    const std::uint32_t form = opcode - SpvOpImageSampleImplicitLod;
    return SamplingForm{.implicit = form % 2 == 0, .compares = form % 4 >= 2, .projected = form >= 4};
}

}  // namespace

void Lowering::lower_composite(const module::Instruction& i) {
    const Types& types = module_.types;
    const auto result = [&] { return slot_of(i.word(2)); };
    const auto operand = [&](std::size_t word) { return slot_of(i.word(word)); };
    switch (i.opcode) {
        case SpvOpUndef:
            emit_for(i, undefine);
            return;
        case SpvOpCopyObject:
        case SpvOpCopyLogical:
        case SpvOpBitcast:
            if (types.at(i.word(1)).kind == Type::Kind::pointer) {
                scope_.pointers[i.word(2)] = pointer_of(i.word(3));
                return;
            }
            if (i.opcode == SpvOpBitcast) return lower_bits(i);
            emit_for(i, copy, operand(3));
            return;
        case SpvOpCompositeConstruct: {
            Slot to = result();
            for (std::size_t k = 3; k < i.words.size(); ++k) {
                const std::uint32_t count = types.slots(type_of(i.word(k)));
                emit(copy, count, to, operand(k)).flags = flags_of(i.word(2), i.word(1));
                to += count;
            }
            return;
        }
        case SpvOpCompositeExtract:
            emit_for(i, copy, part_of(types, operand(3), type_of(i.word(3)), i.from(4)).first);
            return;
        case SpvOpCompositeInsert: {
            emit_for(i, copy, operand(4));
            const auto [to, type] = part_of(types, result(), i.word(1), i.from(5));
            emit(copy, types.slots(type), to, operand(3)).flags = flags_of(i.word(2), i.word(1));
            return;
        }
        case SpvOpVectorShuffle:
            return lower_shuffle(i);
        case SpvOpVectorExtractDynamic:
            emit(extract_dynamic, types.slots(type_of(i.word(3))), result(), operand(3), operand(4));
            return;
        case SpvOpVectorInsertDynamic:
            emit_for(i, insert_dynamic, operand(3), operand(4), operand(5));
            return;
        case SpvOpSelect:
            if (types.at(i.word(1)).kind == Type::Kind::pointer)
                fail(Error::Kind::unknown_instruction, "OpSelect of pointers");
            emit_for(i, select, operand(3), operand(4), operand(5)).stride =
                types.slots(type_of(i.word(3))) > 1 ? 1 : 0;
            return;
        default:
            return lower_matrix(i);
    }
}

void Lowering::lower_bits(const module::Instruction& i) {
    const Type& from = module_.types.scalar_of(type_of(i.word(3)));
    const Type& to = module_.types.scalar_of(i.word(1));
    const bool is_float = to.kind == Type::Kind::real;
    const Operation halves = to.width == 32 ? pack_halves : unpack_halves;
    emit_for(i,
             from.width != to.width ? halves
             : is_float             ? to_float
                                    : copy,
             slot_of(i.word(3)), is_float ? 1 : 0)
        .flags = 0;
}

void Lowering::lower_shuffle(const module::Instruction& i) {
    constexpr std::uint32_t undefined = 0xffffffffU;
    const Slot first = slot_of(i.word(3));
    const Slot second = slot_of(i.word(4));
    const std::uint32_t components = module_.types.slots(type_of(i.word(3)));
    const std::uint32_t in_all = components + module_.types.slots(type_of(i.word(4)));
    std::vector<std::uint32_t> from;
    for (const std::uint32_t component : i.from(5)) {
        if (component != undefined && component >= in_all)
            fail(Error::Kind::malformed, "a shuffle of a component that is not there");
        const std::uint32_t taken = component == undefined ? 0 : component;
        from.push_back(taken < components ? first + taken : second + taken - components);
    }
    emit_for(i, gather).extra = new_list(from);
}

// Matrices: `count` is the number of rows of a result column, `extra` the number of products in a sum, c the
// number of columns.
void Lowering::lower_matrix(const module::Instruction& i) {
    const Types& types = module_.types;
    const auto shape = [&](std::size_t word) -> std::pair<std::uint32_t, std::uint32_t> {
        const Type& type = types.at(type_of(i.word(word)));
        if (type.kind == Type::Kind::matrix) return {type.count, types.slots(type.element)};
        return {1, type.slots};
    };
    const auto product = [&](std::uint32_t rows, std::uint32_t sum, std::uint32_t columns) {
        Instruction& instruction = emit(static_cast<std::uint16_t>(i.opcode), rows, slot_of(i.word(2)),
                                        slot_of(i.word(3)), slot_of(i.word(4)), columns);
        instruction.extra = sum;
        instruction.flags = flags_of(i.word(2), i.word(1));
        if ((instruction.flags & flags::no_contraction) == 0) code_.may_be_rearranged = true;
    };
    switch (i.opcode) {
        case SpvOpTranspose: {
            const auto [columns, rows] = shape(3);
            const Slot first = slot_of(i.word(3));
            std::vector<std::uint32_t> from;
            for (std::uint32_t row = 0; row < rows; ++row)
                for (std::uint32_t column = 0; column < columns; ++column)
                    from.push_back(first + column * rows + row);
            emit_for(i, gather).extra = new_list(from);
            return;
        }
        case SpvOpMatrixTimesVector:
            return product(shape(3).second, shape(3).first, 1);
        case SpvOpVectorTimesMatrix:
            return product(shape(4).second, shape(4).second, shape(4).first);
        case SpvOpMatrixTimesMatrix:
            return product(shape(3).second, shape(3).first, shape(4).first);
        case SpvOpOuterProduct:
            return product(shape(3).second, 1, shape(4).second);
        case SpvOpDot:
            return product(1, shape(3).second, 1);
        default:
            return lower_atomic(i);
    }
}

// An operation of SPIR-V or of GLSL.std.450 on numbers.
void Lowering::lower_operation(const module::Instruction& i) {
    const bool is_extended = i.opcode == SpvOpExtInst;
    if (is_extended && (!module_.declared.extended_sets.contains(i.word(3)) || i.word(4) >= GLSLstd450Count))
        fail(Error::Kind::unknown_instruction,
             "an extended instruction that is not of GLSL.std.450 (debugPrintfEXT)");
    const std::size_t first = is_extended ? 5 : 3;
    const auto opcode = static_cast<std::uint16_t>(is_extended ? extended + i.word(4) : i.opcode);
    const Known* known = known_operation(opcode);
    if (known == nullptr || i.words.size() < known->arity + first)
        fail(Error::Kind::unknown_instruction,
             fmt::format("{} is not known to the interpreter", name_of(opcode)));
    const bool by_pointer = writes_through_pointer(opcode);
    std::array<Slot, 4> operands{};
    for (std::size_t k = 0; k < (by_pointer ? 1U : known->arity); ++k)
        operands.at(k) = slot_of(i.word(first + k));
    const Id operand_type = type_of(i.word(first));
    const Type& to = module_.types.at(i.word(1));
    const std::uint32_t count = module_.types.slots(known->has_count_of_operand() ? operand_type : i.word(1));
    const Slot result = by_pointer ? new_slots(2 * count) : slot_of(i.word(2));
    Instruction& instruction = emit(opcode, count, result, operands[0], operands[1], operands[2]);
    instruction.extra = operands[3];
    const bool to_two = to.kind == Type::Kind::structure || by_pointer;
    instruction.flags = flags_of(i.word(2), to_two ? operand_type : i.word(1));
    if (known->reads_all_first()) instruction.flags |= flags::reads_first;
    if (opcode == SpvOpVectorTimesScalar || opcode == SpvOpMatrixTimesScalar) instruction.stride = 0;
    const bool compares = module_.types.scalar_of(i.word(1)).kind == Type::Kind::boolean &&
                          module_.types.scalar_of(operand_type).kind == Type::Kind::real;
    for (std::size_t k = 0; compares && k < known->arity; ++k)
        if (module_.declared.decorations_of(i.word(first + k)).relaxed) instruction.flags |= flags::relaxed;
    if (known->form == Form::arithmetic && (instruction.flags & flags::no_contraction) == 0)
        code_.may_be_rearranged = true;
    if (!by_pointer) return;
    emit(copy, count, slot_of(i.word(2)), result);
    store(pointer_of(i.word(6)), result + count);
}

// Images: fetches, loads, stores and sizes, without filtering.

void Lowering::lower_fetch(const module::Instruction& i) {
    const auto operand = [&](std::size_t word) { return slot_of(i.word(word)); };
    const std::uint32_t components = module_.types.slots(type_of(i.word(4)));
    // How integers of fewer bits become 32: texels are given with 32.
    constexpr std::uint32_t extensions = SpvImageOperandsSignExtendMask | SpvImageOperandsZeroExtendMask;
    const std::uint32_t operands = i.words.size() > 5 ? i.word(5) & ~extensions : 0;
    const bool level = (operands & SpvImageOperandsLodMask) != 0;
    const bool offset = (operands & SpvImageOperandsConstOffsetMask) != 0;
    if ((operands & ~(SpvImageOperandsLodMask | SpvImageOperandsConstOffsetMask)) != 0)
        fail(Error::Kind::unknown_instruction, "a fetch of a sample, or with a variable offset");
    Slot at = operand(4);
    if (offset) {
        const Slot moved = new_slots(components);
        emit(SpvOpIAdd, components, moved, at, operand(level ? 7 : 6));
        at = moved;
    }
    // Without a level operand it reads level 0.
    emit_for(i, image_load, operand(3), at, components).extra = level ? operand(6) + 1 : 0;
}

void Lowering::lower_image(const module::Instruction& i) {
    const auto operand = [&](std::size_t word) { return slot_of(i.word(word)); };
    const auto components = [&](std::size_t word) { return module_.types.slots(type_of(i.word(word))); };
    switch (i.opcode) {
        case SpvOpImage:
        case SpvOpSampledImage:
            emit(copy, 1, operand(2), operand(3));
            return;
        case SpvOpImageFetch:
        case SpvOpImageRead:
            return lower_fetch(i);
        case SpvOpImageWrite: {
            const Type& image = module_.types.at(type_of(i.word(1)));
            emit(image_store, std::min(components(3), channels_of(image)), 0, operand(1), operand(2),
                 operand(3))
                .extra = components(2);
            for (Resource& resource : code_.resources)
                resource.written = resource.written || resource.kind == Resource::Kind::image;
            return;
        }
        case SpvOpImageQuerySize:
        case SpvOpImageQuerySizeLod:
            emit_for(i, image_size, operand(3)).extra =
                i.opcode == SpvOpImageQuerySizeLod ? operand(4) + 1 : 0;
            return;
        case SpvOpImageQueryLevels:
            emit_for(i, image_levels, operand(3));
            return;
        default:
            return lower_sampling(i);
    }
}

void Lowering::lower_sampling(const module::Instruction& i) {
    const auto form = form_of(i.opcode);
    if (!form) return lower_group(i);
    const auto [implicit, compares, projected, gathers] = *form;
    Sampling how{.projected = projected, .gathers = gathers};
    std::size_t word = gathers || compares ? 6 : 5;
    std::uint32_t operands = word < i.words.size() ? i.word(word++) : 0;
    const auto take = [&](std::uint32_t mask) -> std::optional<Slot> {
        if ((operands & mask) == 0) return std::nullopt;
        operands &= ~mask;
        return slot_of(i.word(word++));
    };
    const auto components = [&](std::size_t at) { return module_.types.slots(type_of(i.word(at))); };
    if (compares)
        how.reference = slot_of(i.word(5));
    else if (gathers)
        how.component = slot_of(i.word(5));
    how.bias = take(SpvImageOperandsBiasMask);
    how.level = take(SpvImageOperandsLodMask);
    how.dx = take(SpvImageOperandsGradMask);
    if (how.dx) {
        how.gradients = components(word);
        how.dy = slot_of(i.word(word++));
    }
    for (const auto mask : {SpvImageOperandsConstOffsetMask, SpvImageOperandsOffsetMask}) {
        const auto offset = take(mask);
        if (!offset) continue;
        how.offset = offset;
        how.offsets = components(word - 1);
    }
    operands &= ~static_cast<std::uint32_t>(SpvImageOperandsSignExtendMask | SpvImageOperandsZeroExtendMask);
    if (operands != 0)
        fail(Error::Kind::unknown_instruction,
             "a sampler with several offsets (textureGatherOffsets), or a least level");
    // Behind those there may be others, which are not used.
    const Type& image = module_.types.at(module_.types.at(type_of(i.word(3))).element);
    const std::uint32_t dimensions = dimensions_of(image) + (image.arrayed || how.projected ? 1 : 0);
    Coordinates at{slot_of(i.word(4)), dimensions};
    if (implicit) at = lower_gradients(i, at, how);
    code_.samplings.push_back(how);
    emit_for(i, image_sample, slot_of(i.word(3)), at.first, at.count).extra =
        static_cast<std::uint32_t>(code_.samplings.size() - 1);
}

}  // namespace gloam::interpreter::internal
