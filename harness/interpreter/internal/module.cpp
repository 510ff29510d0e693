// SPDX-License-Identifier: MIT
#include "interpreter/internal/module.hpp"

#include <fmt/format.h>
#include "interpreter/internal/opcodes.hpp"

#include <bit>

#include "interpreter/error.hpp"
#include "interpreter/internal/conversions.hpp"

namespace gloam::interpreter::internal {
namespace {

[[noreturn]] void malformed(const std::string& message) {
    throw Error(Error::Kind::malformed, message);
}

bool is_half(const Type& type) {
    return type.kind == Type::Kind::real && type.width == 16;
}

std::vector<shader::Instruction> split(const shader::Spirv& words) {
    try {
        return shader::instructions(words);
    } catch (const std::runtime_error& error) {
        malformed(error.what());
    }
}

// "blend" from "blend(f1;f1;": the front end appends the types of the parameters.
std::string without_types(const std::string& name) {
    return name.substr(0, name.find('('));
}

}  // namespace

Module::Module(const shader::Spirv& words, std::span<const Constant> specialized) {
    for (const Constant& constant : specialized) specialized_[constant.id] = constant.bits;
    for (const shader::Instruction& instruction : split(words)) {
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
    const auto found = names_.find(id);
    return found == names_.end() ? fmt::format("%{}", id) : without_types(found->second);
}

std::string Module::string_of(Id id) const {
    const auto found = strings_.find(id);
    return found == strings_.end() ? std::string() : found->second;
}

Decorations Module::decorations_of(Id id) const {
    const auto found = decorations_.find(id);
    return found == decorations_.end() ? Decorations{} : found->second;
}

std::optional<std::uint32_t> Module::integer(Id id) const {
    const auto found = constants.find(id);
    if (found == constants.end() || found->second.bits.size() != 1) return std::nullopt;
    return found->second.bits.front();
}

void Module::read_declaration(const shader::Instruction& i) {
    switch (i.opcode) {
        case SpvOpName:
            names_[i.word(1)] = shader::literal_string(i, 2);
            break;
        case SpvOpString:
            strings_[i.word(1)] = shader::literal_string(i, 2);
            break;
        case SpvOpLine:
            line_ = i;
            break;
        case SpvOpExtInstImport:
            if (shader::literal_string(i, 2) == "GLSL.std.450") extended_sets.insert(i.word(1));
            break;
        case SpvOpEntryPoint:
            entry_points_[shader::literal_string(i, 3)] = i.word(2);
            break;
        case SpvOpDecorate:
            decorate(i);
            break;
        case SpvOpMemberDecorate:
            decorate_member(i);
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
            } else {
                types.read(i, [this](Id length) {
                    const auto value = integer(length);
                    if (!value)
                        throw Error(Error::Kind::unknown_instruction, "an array whose length is computed");
                    return *value;
                });
            }
    }
}

void Module::decorate(const shader::Instruction& i) {
    Decorations& all = decorations_[i.word(1)];
    switch (i.word(2)) {
        case SpvDecorationNoContraction:
            all.no_contraction = true;
            break;
        case SpvDecorationRelaxedPrecision:
            all.relaxed = true;
            break;
        case SpvDecorationSpecId:
            all.spec_id = i.word(3);
            break;
        case SpvDecorationBuiltIn:
            all.built_in = i.word(3);
            break;
        case SpvDecorationDescriptorSet:
            all.set = i.word(3);
            break;
        case SpvDecorationBinding:
            all.binding = i.word(3);
            break;
        case SpvDecorationArrayStride:
            types.decorate(i.word(1), i.word(3));
            break;
        default:
            break;
    }
}

void Module::decorate_member(const shader::Instruction& i) {
    Type::Member& member = types.member(i.word(1), i.word(2));
    switch (i.word(3)) {
        case SpvDecorationOffset:
            member.offset = i.word(4);
            break;
        case SpvDecorationMatrixStride:
            member.matrix.stride = i.word(4);
            break;
        case SpvDecorationRowMajor:
            member.matrix.row_major = true;
            break;
        default:
            break;
    }
}

void Module::read_constant(const shader::Instruction& i) {
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
            if (i.words.size() != 4)
                throw Error(Error::Kind::unknown_instruction, "a constant of more than 32 bits");
            value.bits = {is_half(types.at(value.type)) ? std::bit_cast<Word>(half_value(i.word(3) & 0xffffU))
                                                        : i.word(3)};
            break;
        case SpvOpConstantComposite:
        case SpvOpSpecConstantComposite:
            for (const Id part : i.words.subspan(3)) {
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
    if (const auto spec_id = decorations_of(i.word(2)).spec_id; spec_id && specialized_.contains(*spec_id))
        value.bits = {specialized_.at(*spec_id)};
    if (value.bits.size() != types.slots(value.type)) malformed("a constant that does not fit its type");
    constants[i.word(2)] = std::move(value);
}

void Module::read_function(const shader::Instruction& i) {
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
    }
}

}  // namespace gloam::interpreter::internal
