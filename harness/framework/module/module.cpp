// SPDX-License-Identifier: MIT
#include "module/module.hpp"

#define SPV_ENABLE_UTILITY_CODE  // which instructions have results; so this is the first source of its group
#include <spirv.h>

#include <fmt/format.h>

namespace gloam::module::spirv {
namespace {

// A type but for what other instructions say of it; nothing for an instruction that declares none of these.
std::optional<Type> type_of(const Instruction& i) {
    using Kind = Type::Kind;
    switch (i.opcode) {
        case SpvOpTypeVoid:
            return Type{.kind = Kind::void_};
        case SpvOpTypeBool:
            return Type{.kind = Kind::boolean};
        case SpvOpTypeInt:
            return Type{.kind = Kind::integer, .width = i.word(2), .is_signed = i.word(3) != 0};
        case SpvOpTypeFloat:
            return Type{.kind = Kind::real, .width = i.word(2)};
        case SpvOpTypeVector:
            return Type{.kind = Kind::vector, .element = i.word(2), .count = i.word(3)};
        case SpvOpTypeMatrix:
            return Type{.kind = Kind::matrix, .element = i.word(2), .count = i.word(3)};
        case SpvOpTypeArray:
            return Type{.kind = Kind::array, .element = i.word(2), .length = i.word(3)};
        case SpvOpTypeRuntimeArray:
            return Type{.kind = Kind::runtime_array, .element = i.word(2)};
        case SpvOpTypeStruct:
            return Type{.kind = Kind::structure};
        case SpvOpTypePointer:
            return Type{.kind = Kind::pointer, .element = i.word(3), .storage = i.word(2)};
        case SpvOpTypeImage:
            return Type{.kind = Kind::image,
                        .element = i.word(2),
                        .dimension = i.word(3),
                        .depth = i.word(4) == 1,
                        .arrayed = i.word(5) != 0,
                        .multisampled = i.word(6) != 0,
                        .stored = i.word(7) == 2,
                        .format = i.word(8)};
        case SpvOpTypeSampler:
            return Type{.kind = Kind::sampler};
        case SpvOpTypeSampledImage:
            return Type{.kind = Kind::sampled_image, .element = i.word(2)};
        case SpvOpTypeFunction:
            return Type{.kind = Kind::function, .element = i.word(2)};
        default:
            return std::nullopt;
    }
}

}  // namespace

ResultShape result_shape(std::uint32_t opcode) {
    ResultShape shape;
    SpvHasResultAndType(static_cast<SpvOp>(opcode), &shape.result, &shape.type);
    return shape;
}

const Type* Declarations::read(const Instruction& i) {
    switch (i.opcode) {
        case SpvOpName:
            names[i.word(1)] = literal_string(i, 2);
            return nullptr;
        case SpvOpMemberName:
            members_[{i.word(1), i.word(2)}].name = literal_string(i, 3);
            return nullptr;
        case SpvOpExtInstImport:
            if (literal_string(i, 2) == "GLSL.std.450") extended_sets.insert(i.word(1));
            return nullptr;
        case SpvOpDecorate:
            decorate(i);
            return nullptr;
        case SpvOpMemberDecorate:
            decorate_member(i);
            return nullptr;
        default:
            break;
    }
    std::optional<Type> type = type_of(i);
    if (!type) return nullptr;
    const Id id = i.word(1);
    if (types.contains(id))
        throw std::runtime_error(fmt::format("no SPIR-V module: type {} is declared twice", id));
    if (const auto stride = strides_.find(id); stride != strides_.end()) type->array_stride = stride->second;
    for (std::uint32_t m = 0; type->kind == Type::Kind::structure && m + 2 < i.words.size(); ++m) {
        type->members.push_back(members_[{id, m}]);
        type->members.back().type = i.word(m + 2);
    }
    return &(types[id] = std::move(*type));
}

Decorations Declarations::decorations_of(Id id) const {
    const auto found = decorations_.find(id);
    return found == decorations_.end() ? Decorations{} : found->second;
}

std::string Declarations::name_of(Id id) const {
    const auto found = names.find(id);
    return found == names.end() ? std::string() : found->second.substr(0, found->second.find('('));
}

void Declarations::decorate(const Instruction& i) {
    Decorations& all = decorations_[i.word(1)];
    const std::uint32_t decoration = i.word(2);
    if (decoration == SpvDecorationNoContraction) all.no_contraction = true;
    if (decoration == SpvDecorationRelaxedPrecision) all.relaxed = true;
    if (decoration == SpvDecorationNonReadable) all.not_readable = true;
    if (decoration == SpvDecorationNonWritable) all.not_writable = true;
    if (decoration == SpvDecorationSpecId) all.spec_id = i.word(3);
    if (decoration == SpvDecorationBuiltIn) all.built_in = i.word(3);
    if (decoration == SpvDecorationDescriptorSet) all.set = i.word(3);
    if (decoration == SpvDecorationBinding) all.binding = i.word(3);
    if (decoration == SpvDecorationArrayStride) strides_[i.word(1)] = i.word(3);
}

void Declarations::decorate_member(const Instruction& i) {
    Member& member = members_[{i.word(1), i.word(2)}];
    const std::uint32_t decoration = i.word(3);
    if (decoration == SpvDecorationOffset) member.offset = i.word(4);
    if (decoration == SpvDecorationMatrixStride) member.matrix.stride = i.word(4);
    if (decoration == SpvDecorationRowMajor) member.matrix.row_major = true;
    if (decoration == SpvDecorationNonReadable) member.not_readable = true;
    if (decoration == SpvDecorationNonWritable) member.not_writable = true;
}

std::string other_number(const Type& type) {
    if (type.kind == Type::Kind::real && type.width == 64) return "double";
    if (type.kind != Type::Kind::integer || type.width == 32) return {};
    return fmt::format("{}int{}_t", type.is_signed ? "" : "u", type.width);
}

std::string other_number(const Spirv& module) {
    Declarations declared;
    for (const Instruction& one : instructions(module))
        if (const Type* type = declared.read(one))
            if (std::string other = other_number(*type); !other.empty()) return other;
    return {};
}

std::string not_judged(const std::string& number) {
    return number + " is not judged: gloam judges float, float16_t, int, uint and bool";
}

}  // namespace gloam::module::spirv
