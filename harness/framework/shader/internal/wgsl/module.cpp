// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/module.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

// Blocks that follow, and those that merges name.
std::vector<Id> targets_of(const Block& block) {
    std::vector<Id> targets;
    const Instruction& end = block.end;
    if (end.opcode == SpvOpBranch) targets = {end.word(1)};
    if (end.opcode == SpvOpBranchConditional) targets = {end.word(2), end.word(3)};
    if (end.opcode == SpvOpSwitch) {
        targets = {end.word(2)};
        for (std::size_t w = 4; w < end.words.size(); w += 2) targets.push_back(end.word(w));
    }
    if (!block.merge) return targets;
    targets.push_back(block.merge->word(1));
    if (block.merge->opcode == SpvOpLoopMerge) targets.push_back(block.merge->word(2));
    return targets;
}

// Throws WgslError for numbers that WGSL does not have.
void refuse_widths(const Instruction& type) {
    const std::uint32_t width = type.word(2);
    if (type.opcode == SpvOpTypeInt && width != 32)
        throw WgslError("integers of " + std::to_string(width) + " bits");
    if (type.opcode == SpvOpTypeFloat && width != 32 && width != 16)
        throw WgslError("floats of " + std::to_string(width) + " bits");
}

}  // namespace

Module::Module(const Spirv& words) {
    for (const Instruction& instruction : instructions(words)) {
        const auto [has_result, has_type] = spirv::result_shape(instruction.opcode);
        if (has_type && has_result) value_types_[instruction.word(2)] = instruction.word(1);
        if (in_function_ || instruction.opcode == SpvOpFunction) {
            read_in_function(instruction);
        } else {
            read_global(instruction);
        }
    }
    for (Function& function : functions) drop_dead_blocks(function);
}

// Branches by a constant, which GLSL's preprocessor leaves, go one way only.
void Module::drop_dead_blocks(Function& function) {
    for (auto& [label, block] : function.blocks) {
        if (block.end.opcode != SpvOpBranchConditional) continue;
        const Instruction* known = constant(block.end.word(1));
        if (known == nullptr || (known->opcode != SpvOpConstantTrue && known->opcode != SpvOpConstantFalse))
            continue;
        const Id to = block.end.word(known->opcode == SpvOpConstantTrue ? 2 : 3);
        branches_.push_back({(2U << 16U) | SpvOpBranch, to});
        block.end = {.at = block.end.at, .opcode = SpvOpBranch, .words = branches_.back()};
        if (block.merge && block.merge->opcode == SpvOpSelectionMerge) block.merge.reset();
    }
    std::set<Id> reached;
    std::vector<Id> open{function.order.begin(), function.order.begin() + (function.order.empty() ? 0 : 1)};
    while (!open.empty()) {
        const Id label = open.back();
        open.pop_back();
        if (!reached.insert(label).second) continue;
        const Block& block = function.block(label);
        for (const Id to : targets_of(block)) open.push_back(to);
    }
    std::erase_if(function.blocks, [&](const auto& entry) { return !reached.contains(entry.first); });
    std::erase_if(function.order, [&](Id label) { return !reached.contains(label); });
}

const Type& Module::type(Id id) const {
    const auto found = types.find(id);
    if (found == types.end())
        throw NotTranslated("a type that is no number, vector, matrix, array, structure or image");
    return found->second;
}

Id Module::type_of(Id value) const {
    if (const Instruction* known = constant(value)) return known->word(1);
    const auto found = value_types_.find(value);
    if (found == value_types_.end()) throw std::runtime_error("a value without a type");
    return found->second;
}

const Instruction* Module::constant(Id id) const {
    const auto found = constants.find(id);
    return found == constants.end() ? nullptr : &found->second;
}

std::optional<std::uint32_t> Module::integer(Id id) const {
    const Instruction* found = constant(id);
    if (found == nullptr || found->opcode != SpvOpConstant) return std::nullopt;
    return found->word(3);
}

bool Module::is_float(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::real ||
           ((t.kind == Type::Kind::vector || t.kind == Type::Kind::matrix) && is_float(t.element));
}

bool Module::is_opaque(Id id) const {
    const Type::Kind kind = type(id).kind;
    return kind == TypeKind::image || kind == TypeKind::sampled_image || kind == TypeKind::sampler;
}

bool Module::is_half(Id id) const {
    const Type& t = type(id);
    if (t.kind == Type::Kind::vector || t.kind == Type::Kind::matrix) return is_half(t.element);
    return t.kind == Type::Kind::real && t.width == 16;
}

const Type& Module::image_type(Id id) const {
    const Type& declared = type(id);
    return declared.kind == TypeKind::sampled_image ? type(declared.element) : declared;
}

bool Module::is_signed(Id id) const {
    const Type& t = type(id);
    return (t.kind == Type::Kind::integer && t.is_signed) ||
           (t.kind == Type::Kind::vector && is_signed(t.element));
}

bool Module::is_bool(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::boolean || (t.kind == Type::Kind::vector && is_bool(t.element));
}

std::uint32_t Module::components(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::vector ? t.count : 1;
}

void Module::read_global(const Instruction& i) {
    switch (i.opcode) {
        case SpvOpEntryPoint:
            entry_points[i.word(1)] = i.word(2);
            break;
        case SpvOpExecutionMode:
            if (i.word(2) == SpvExecutionModeLocalSize) local_size = {i.word(3), i.word(4), i.word(5)};
            break;
        case SpvOpVariable:
            variables.push_back({i.word(2), type(i.word(1)).element, i.word(3), i.word(4)});
            break;
        default:
            if ((i.opcode >= SpvOpConstantTrue && i.opcode <= SpvOpSpecConstantOp) ||
                i.opcode == SpvOpUndef) {
                constants[i.word(2)] = i;
                constant_order.push_back(i.word(2));
            } else {
                refuse_widths(i);
                Declarations::read(i);
            }
    }
}

void Module::read_in_function(const Instruction& i) {
    switch (i.opcode) {
        case SpvOpFunction:
            functions.push_back({.id = i.word(2), .result = i.word(1)});
            in_function_ = true;
            return;
        case SpvOpFunctionEnd:
            in_function_ = false;
            return;
        case SpvOpFunctionParameter:
            functions.back().parameters.push_back(i.word(2));
            return;
        case SpvOpLabel:
            block_ = i.word(1);
            functions.back().order.push_back(block_);
            functions.back().blocks[block_].label = block_;
            return;
        case SpvOpVariable:
            functions.back().variables.push_back(
                {i.word(2), type(i.word(1)).element, SpvStorageClassFunction, i.word(4)});
            return;
        case SpvOpLine:
        case SpvOpNoLine:
        case SpvOpNop:
            return;
        default:
            break;
    }
    Block& block = functions.back().blocks[block_];
    if (i.opcode == SpvOpSelectionMerge || i.opcode == SpvOpLoopMerge) {
        block.merge = i;
    } else if ((i.opcode >= SpvOpBranch && i.opcode <= SpvOpUnreachable) ||
               i.opcode == SpvOpTerminateInvocation) {
        block.end = i;
    } else {
        block.body.push_back(i);
    }
}

}  // namespace gloam::shader::internal::wgsl
