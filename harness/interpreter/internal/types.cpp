// SPDX-License-Identifier: MIT
#include "interpreter/internal/types.hpp"

#include <fmt/format.h>
#include "interpreter/internal/opcodes.hpp"

#include "interpreter/error.hpp"

namespace gloam::interpreter::internal {
namespace {

// Limit of scalars in a variable; no real shader has more.
constexpr std::uint64_t most_scalars = 1U << 22;

std::uint32_t bounded(std::uint64_t slots) {
    if (slots > most_scalars)
        throw Error(Error::Kind::malformed,
                    fmt::format("a type of {} scalars, expected at most {}", slots, most_scalars));
    return static_cast<std::uint32_t>(slots);
}

}  // namespace

const Type& Types::at(Id id) const {
    const auto found = types_.find(id);
    if (found == types_.end()) throw Error(Error::Kind::malformed, fmt::format("ID {} is no type", id));
    return found->second;
}

const Type& Types::scalar_of(Id id) const {
    const Type* type = &at(id);
    while (type->kind == Type::Kind::vector || type->kind == Type::Kind::matrix ||
           type->kind == Type::Kind::array)
        type = &at(type->element);
    return *type;
}

void Types::add(const shader::Instruction& i, std::uint32_t length) {
    using Kind = Type::Kind;
    Type type;
    const auto composite = [&](Kind kind, std::uint32_t count) {
        type.kind = kind;
        type.element = i.word(2);
        type.count = count;
        type.slots = bounded(std::uint64_t{slots(type.element)} * count);
    };
    switch (i.opcode) {
        case SpvOpTypeVoid:
            type = {.kind = Kind::void_};
            break;
        case SpvOpTypeBool:
            type = {.kind = Kind::boolean, .slots = 1};
            break;
        case SpvOpTypeInt:
            type = {.kind = Kind::integer, .width = i.word(2), .is_signed = i.word(3) != 0, .slots = 1};
            break;
        case SpvOpTypeFloat:
            type = {.kind = Kind::real, .width = i.word(2), .slots = 1};
            break;
        case SpvOpTypeVector:
            composite(Kind::vector, i.word(3));
            break;
        case SpvOpTypeMatrix:
            composite(Kind::matrix, i.word(3));
            break;
        case SpvOpTypeArray:
            composite(Kind::array, length);
            break;
        case SpvOpTypeRuntimeArray:
            type = {.kind = Kind::runtime_array, .element = i.word(2)};
            break;
        case SpvOpTypeStruct: {
            type.kind = Kind::structure;
            std::uint64_t slots_in_all = 0;
            for (std::uint32_t m = 0; m + 2 < i.words.size(); ++m) {
                Type::Member member = members_[{i.word(1), m}];
                member.type = i.word(m + 2);
                slots_in_all += slots(member.type);
                type.members.push_back(member);
            }
            type.slots = bounded(slots_in_all);
            break;
        }
        case SpvOpTypePointer:
            type = {.kind = Kind::pointer, .element = i.word(3), .storage = i.word(2)};
            break;
        case SpvOpTypeImage:
            type = {.kind = Kind::image, .element = i.word(2), .slots = 1, .dimension = i.word(3)};
            break;
        case SpvOpTypeSampler:
            type = {.kind = Kind::sampler, .slots = 1};
            break;
        case SpvOpTypeSampledImage:
            type = {.kind = Kind::sampled_image, .element = i.word(2), .slots = 1};
            break;
        case SpvOpTypeFunction:
            type = {.kind = Kind::function, .element = i.word(2)};
            break;
        default:
            return;
    }
    type.array_stride = strides_[i.word(1)];
    types_[i.word(1)] = std::move(type);
}

void Types::append_offsets(Id id, const MatrixLayout& matrix, std::uint32_t scalar_stride, std::uint32_t base,
                           std::vector<std::uint32_t>& offsets) const {
    const Type& type = at(id);
    const auto every = [&](std::uint32_t stride, std::uint32_t inner_scalar_stride) {
        for (std::uint32_t i = 0; i < type.count; ++i)
            append_offsets(type.element, matrix, inner_scalar_stride, base + i * stride, offsets);
    };
    switch (type.kind) {
        case Type::Kind::integer:
        case Type::Kind::real:
            if (type.width != 32 && !(type.width == 16 && type.kind == Type::Kind::real))
                throw Error(
                    Error::Kind::unknown_instruction,
                    fmt::format("{} of {} bits in a buffer, expected 32",
                                type.kind == Type::Kind::real ? "a float" : "an integer", type.width));
            return offsets.push_back(type.width == 16 ? base | 1U : base);
        case Type::Kind::vector:
            return every(scalar_stride == 0 ? scalar_bytes(type.element) : scalar_stride, 0);
        case Type::Kind::matrix:
            return matrix.row_major ? every(scalar_bytes(type.element), matrix.stride)
                                    : every(matrix.stride, 0);
        case Type::Kind::array:
            return every(type.array_stride, 0);
        case Type::Kind::structure:
            for (const Type::Member& member : type.members)
                append_offsets(member.type, member.matrix, 0, base + member.offset, offsets);
            return;
        default:
            throw Error(Error::Kind::unknown_instruction,
                        "a load of something that is neither a number nor made of numbers");
    }
}

}  // namespace gloam::interpreter::internal
