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

}  // namespace

Module::Module(const Spirv& words) {
    for (const Instruction& instruction : instructions(words)) {
        bool has_result = false;
        bool has_type = false;
        SpvHasResultAndType(static_cast<SpvOp>(instruction.opcode), &has_result, &has_type);
        if (has_type && has_result) value_types_[instruction.word(2)] = instruction.word(1);
        if (in_function_ || instruction.opcode == SpvOpFunction) {
            read_in_function(instruction);
        } else {
            read(instruction);
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

Decorations Module::decorations_of(Id id) const {
    const auto found = decorations_.find(id);
    return found == decorations_.end() ? Decorations{} : found->second;
}

std::string Module::name_of(Id id) const {
    const auto found = names_.find(id);
    return found == names_.end() ? std::string() : found->second.substr(0, found->second.find('('));
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
    return t.kind == Type::Kind::float_ ||
           ((t.kind == Type::Kind::vector || t.kind == Type::Kind::matrix) && is_float(t.element));
}

bool Module::is_opaque(Id id) const {
    const Type::Kind kind = type(id).kind;
    return kind == TypeKind::image || kind == TypeKind::sampled_image || kind == TypeKind::sampler;
}

bool Module::is_half(Id id) const {
    const Type& t = type(id);
    if (t.kind == Type::Kind::vector || t.kind == Type::Kind::matrix) return is_half(t.element);
    return t.kind == Type::Kind::float_ && t.bits == 16;
}

const Type& Module::image_type(Id id) const {
    const Type& declared = type(id);
    return declared.kind == TypeKind::sampled_image ? type(declared.element) : declared;
}

bool Module::is_signed(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::int_ || (t.kind == Type::Kind::vector && is_signed(t.element));
}

bool Module::is_bool(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::bool_ || (t.kind == Type::Kind::vector && is_bool(t.element));
}

std::uint32_t Module::components(Id id) const {
    const Type& t = type(id);
    return t.kind == Type::Kind::vector ? t.count : 1;
}

void Module::read(const Instruction& i) {
    switch (i.opcode) {
        case SpvOpName:
            names_[i.word(1)] = literal_string(i, 2);
            break;
        case SpvOpMemberName:
            member_names_[i.word(1)][i.word(2)] = literal_string(i, 3);
            break;
        case SpvOpExtInstImport:
            if (literal_string(i, 2) == "GLSL.std.450") extended.insert(i.word(1));
            break;
        case SpvOpEntryPoint:
            entry_points[i.word(1)] = i.word(2);
            break;
        case SpvOpExecutionMode:
            if (i.word(2) == SpvExecutionModeLocalSize) local_size = {i.word(3), i.word(4), i.word(5)};
            break;
        case SpvOpDecorate:
            read_decoration(i);
            break;
        case SpvOpMemberDecorate:
            read_member_decoration(i);
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
                read_type(i);
            }
    }
}

void Module::read_decoration(const Instruction& i) {
    Decorations& all = decorations_[i.word(1)];
    switch (i.word(2)) {
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
        case SpvDecorationLocation:
            all.location = i.word(3);
            break;
        case SpvDecorationFlat:
            all.flat = true;
            break;
        case SpvDecorationNoPerspective:
            all.no_perspective = true;
            break;
        case SpvDecorationComponent:
        case SpvDecorationIndex:
            all.special_location = i.word(3) != 0;
            break;
        case SpvDecorationCentroid:
        case SpvDecorationSample:
            all.special_location = true;
            break;
        case SpvDecorationArrayStride:
            strides_[i.word(1)] = i.word(3);
            break;
        default:
            break;
    }
}

void Module::read_member_decoration(const Instruction& i) {
    Member& member = member_decorations_[i.word(1)][i.word(2)];
    switch (i.word(3)) {
        case SpvDecorationOffset:
            member.offset = i.word(4);
            break;
        case SpvDecorationRowMajor:
            member.row_major = true;
            break;
        case SpvDecorationBuiltIn:
            member.built_in = i.word(4);
            break;
        default:
            break;
    }
}

void Module::read_type(const Instruction& i) {
    Type t;
    if (!read_scalar_type(i, t) && !read_composite_type(i, t) && !read_opaque_type(i, t)) return;
    types[i.word(1)] = t;
    type_order.push_back(i.word(1));
}

bool Module::read_scalar_type(const Instruction& i, Type& t) {
    switch (i.opcode) {
        case SpvOpTypeVoid:
            return true;
        case SpvOpTypeBool:
            t.kind = TypeKind::bool_;
            return true;
        case SpvOpTypeInt:
            if (i.word(2) != 32) throw WgslError("integers of " + std::to_string(i.word(2)) + " bits");
            t.kind = i.word(3) == 0 ? TypeKind::uint_ : TypeKind::int_;
            return true;
        case SpvOpTypeFloat:
            if (i.word(2) != 32 && i.word(2) != 16)
                throw WgslError("floats of " + std::to_string(i.word(2)) + " bits");
            t.kind = TypeKind::float_;
            t.bits = i.word(2);
            return true;
        default:
            return false;
    }
}

bool Module::read_composite_type(const Instruction& i, Type& t) {
    switch (i.opcode) {
        case SpvOpTypeVector:
        case SpvOpTypeMatrix:
            t.kind = i.opcode == SpvOpTypeVector ? TypeKind::vector : TypeKind::matrix;
            t.element = i.word(2);
            t.count = i.word(3);
            return true;
        case SpvOpTypeArray:
        case SpvOpTypeRuntimeArray:
            t.kind = i.opcode == SpvOpTypeArray ? TypeKind::array : TypeKind::runtime_array;
            t.element = i.word(2);
            t.length = i.word(3);
            t.stride = strides_[i.word(1)];
            return true;
        case SpvOpTypeStruct:
            t.kind = TypeKind::structure;
            for (std::uint32_t m = 0; m + 2 < i.words.size(); ++m) {
                Member member = member_decorations_[i.word(1)][m];
                member.type = i.word(m + 2);
                member.name = member_names_[i.word(1)][m];
                t.members.push_back(member);
            }
            return true;
        default:
            return false;
    }
}

bool Module::read_opaque_type(const Instruction& i, Type& t) {
    switch (i.opcode) {
        case SpvOpTypePointer:
            t.kind = TypeKind::pointer;
            t.storage = i.word(2);
            t.element = i.word(3);
            return true;
        case SpvOpTypeImage:
            t.kind = TypeKind::image;
            t.element = i.word(2);
            t.dimension = i.word(3);
            t.depth = i.word(4) == 1;
            t.arrayed = i.word(5) != 0;
            t.multisampled = i.word(6) != 0;
            t.stored = i.word(7) == 2;
            t.format = i.word(8);
            return true;
        case SpvOpTypeSampledImage:
            t.kind = TypeKind::sampled_image;
            t.element = i.word(2);
            return true;
        case SpvOpTypeSampler:
            t.kind = TypeKind::sampler;
            return true;
        case SpvOpTypeFunction:
            t.kind = TypeKind::function;
            t.element = i.word(2);
            return true;
        default:
            return false;
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
