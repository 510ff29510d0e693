// SPDX-License-Identifier: MIT
#include "interpreter/internal/module.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "interpreter/internal/conversions.hpp"
#include "interpreter/internal/opcodes.hpp"

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

[[noreturn]] void malformed(const std::string& message) {
    throw Error(Error::Kind::malformed, message);
}

std::vector<module::Instruction> split(const module::Spirv& words) {
    try {
        return module::instructions(words);
    } catch (const std::runtime_error& error) {
        malformed(error.what());
    }
}

bool samples_implicitly(std::uint32_t opcode) {
    return opcode == SpvOpImageSampleImplicitLod || opcode == SpvOpImageSampleProjImplicitLod ||
           opcode == SpvOpImageSampleDrefImplicitLod || opcode == SpvOpImageSampleProjDrefImplicitLod;
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

void Types::add(Id id, const module::spirv::Type& declared, std::uint32_t length) {
    using Kind = Type::Kind;
    Type type{declared};
    if (type.kind == Kind::array) type.count = length;
    switch (type.kind) {
        case Kind::boolean:
        case Kind::integer:
        case Kind::real:
        case Kind::image:
        case Kind::sampler:
        case Kind::sampled_image:
            type.slots = 1;
            break;
        case Kind::vector:
        case Kind::matrix:
        case Kind::array:
            type.slots = bounded(std::uint64_t{slots(type.element)} * type.count);
            break;
        case Kind::structure: {
            std::uint64_t slots_in_all = 0;
            for (const module::spirv::Member& member : type.members) slots_in_all += slots(member.type);
            type.slots = bounded(slots_in_all);
            break;
        }
        default:
            break;
    }
    types_[id] = std::move(type);
}

std::uint32_t dimensions_of(const Type& image) {
    if (image.dimension == SpvDim1D) return 1;
    return image.dimension == SpvDim3D || image.dimension == SpvDimCube ? 3 : 2;
}

std::uint32_t channels_of(const Type& image) {
    constexpr std::array<std::uint32_t, 6> one{SpvImageFormatR32f, SpvImageFormatR32i,  SpvImageFormatR32ui,
                                               SpvImageFormatR16f, SpvImageFormatR16ui, SpvImageFormatR8};
    constexpr std::array<std::uint32_t, 5> two{SpvImageFormatRg32f, SpvImageFormatRg32i, SpvImageFormatRg32ui,
                                               SpvImageFormatRg16f, SpvImageFormatRg16ui};
    if (std::ranges::find(one, image.format) != one.end()) return 1;
    return std::ranges::find(two, image.format) != two.end() ? 2 : 4;
}

void Types::append_offsets(Id id, const module::spirv::MatrixLayout& matrix, std::uint32_t scalar_stride,
                           std::uint32_t base, std::vector<std::uint32_t>& offsets) const {
    const Type& type = at(id);
    const auto every = [&](std::uint32_t stride, std::uint32_t inner_scalar_stride) {
        for (std::uint32_t i = 0; i < type.count; ++i)
            append_offsets(type.element, matrix, inner_scalar_stride, base + i * stride, offsets);
    };
    switch (type.kind) {
        case Type::Kind::integer:
        case Type::Kind::real:
            return offsets.push_back(type.width == 16 ? base | 1U : base);
        case Type::Kind::vector:
            return every(scalar_stride == 0 ? scalar_bytes(type.element) : scalar_stride, 0);
        case Type::Kind::matrix:
            return matrix.row_major ? every(scalar_bytes(type.element), matrix.stride)
                                    : every(matrix.stride, 0);
        case Type::Kind::array:
            return every(type.array_stride, 0);
        case Type::Kind::structure:
            for (const module::spirv::Member& member : type.members)
                append_offsets(member.type, member.matrix, 0, base + member.offset, offsets);
            return;
        default:
            throw Error(Error::Kind::unknown_instruction,
                        "a load of something that is neither a number nor made of numbers");
    }
}

Module::Module(const module::Spirv& words, std::span<const Constant> specialized) {
    for (const Constant& constant : specialized) specialized_[constant.id] = constant.bits;
    for (const module::Instruction& instruction : split(words)) {
        if (open_ != nullptr || instruction.opcode == SpvOpFunction) {
            read_function(instruction);
        } else {
            read_declaration(instruction);
        }
    }
    if (open_ != nullptr) malformed("a function without an end");
}

Id Module::entry_point(const std::string& name) const {
    const auto found = entry_points_.find(name);
    if (found == entry_points_.end())
        throw Error(Error::Kind::missing, fmt::format("no entry point \"{}\" in the module", name));
    return found->second;
}

const Function& Module::function(Id id) const {
    const auto found = functions_.find(id);
    if (found == functions_.end()) malformed(fmt::format("ID {} is no function", id));
    return found->second;
}

std::string Module::name_of(Id id) const {
    return declared.names.contains(id) ? declared.name_of(id) : fmt::format("%{}", id);
}

std::string Module::string_of(Id id) const {
    const auto found = strings_.find(id);
    return found == strings_.end() ? std::string() : found->second;
}

std::optional<std::uint32_t> Module::integer(Id id) const {
    const auto found = constants.find(id);
    if (found == constants.end() || found->second.bits.size() != 1) return std::nullopt;
    return found->second.bits.front();
}

void Module::read_declaration(const module::Instruction& i) {
    switch (i.opcode) {
        case SpvOpString:
            strings_[i.word(1)] = module::literal_string(i, 2);
            break;
        case SpvOpLine:
            line_ = i;
            break;
        case SpvOpEntryPoint:
            entry_points_[module::literal_string(i, 3)] = i.word(2);
            break;
        case SpvOpGroupDecorate:
        case SpvOpGroupMemberDecorate:
            throw Error(Error::Kind::unknown_instruction, "a group of decorations");
        case SpvOpVariable:
            variables.push_back(i);
            break;
        case SpvOpUndef:
            undefined[i.word(2)] = i.word(1);
            break;
        case SpvOpSpecConstantOp:
            computed_constants.push_back(i);
            break;
        default:
            if (i.opcode >= SpvOpConstantTrue && i.opcode <= SpvOpSpecConstantComposite) {
                read_constant(i);
            } else if (const module::spirv::Type* type = declared.read(i)) {
                if (const std::string other = module::spirv::other_number(*type); !other.empty())
                    throw Error(Error::Kind::unknown_instruction, module::spirv::not_judged(other));
                types.add(i.word(1), *type, length_of(*type));
            }
    }
}

std::uint32_t Module::length_of(const module::spirv::Type& type) const {
    if (type.kind != Type::Kind::array) return 0;
    const auto value = integer(type.length);
    if (!value) throw Error(Error::Kind::unknown_instruction, "an array whose length is computed");
    return *value;
}

void Module::read_constant(const module::Instruction& i) {
    ConstantValue value{.type = i.word(1), .bits = {}};
    switch (i.opcode) {
        case SpvOpConstantTrue:
        case SpvOpSpecConstantTrue:
            value.bits = {1};
            break;
        case SpvOpConstantFalse:
        case SpvOpSpecConstantFalse:
            value.bits = {0};
            break;
        case SpvOpConstant:
        case SpvOpSpecConstant:
            value.bits = {types.at(value.type).kind == Type::Kind::real && types.at(value.type).width == 16
                              ? float_of_half(i.word(3) & 0xffffU)
                              : i.word(3)};
            break;
        case SpvOpConstantComposite:
        case SpvOpSpecConstantComposite:
            for (const Id part : i.from(3)) {
                const auto found = constants.find(part);
                if (found == constants.end()) return computed_constants.push_back(i);
                value.bits.insert(value.bits.end(), found->second.bits.begin(), found->second.bits.end());
            }
            break;
        case SpvOpConstantNull:
            value.bits.assign(types.slots(i.word(1)), 0);
            break;
        default:
            throw Error(Error::Kind::unknown_instruction, fmt::format("a constant by opcode {}", i.opcode));
    }
    if (const auto spec_id = declared.decorations_of(i.word(2)).spec_id;
        spec_id && specialized_.contains(*spec_id))
        value.bits = {specialized_.at(*spec_id)};
    if (value.bits.size() != types.slots(value.type)) malformed("a constant that does not fit its type");
    constants[i.word(2)] = std::move(value);
}

void Module::read_function(const module::Instruction& i) {
    if (i.opcode == SpvOpFunction) {
        if (open_ != nullptr) malformed("a function inside a function");
        open_ = &functions_[i.word(2)];
        *open_ = {.id = i.word(2), .result_type = i.word(1), .parameters = {}, .body = {}};
        if (line_) open_->body.push_back(*line_);
        line_.reset();
    } else if (i.opcode == SpvOpFunctionEnd) {
        open_ = nullptr;
    } else if (i.opcode == SpvOpFunctionParameter) {
        open_->parameters.push_back(i.word(2));
        open_->body.push_back(i);
    } else {
        open_->body.push_back(i);
        meets_ = meets_ || samples_implicitly(i.opcode) || i.opcode == SpvOpControlBarrier ||
                 (i.opcode >= SpvOpDPdx && i.opcode <= SpvOpFwidthCoarse) ||
                 (i.opcode >= SpvOpGroupNonUniformElect && i.opcode <= SpvOpGroupNonUniformQuadSwap);
    }
}

}  // namespace gloam::interpreter::internal
