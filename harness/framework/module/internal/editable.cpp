// SPDX-License-Identifier: MIT
#include "module/internal/editable.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "module/module.hpp"
#include "module/spirv.hpp"

namespace gloam::shader::internal {
namespace {

constexpr std::size_t header_words = 5;
constexpr std::size_t bound_word = 3;

std::size_t result_place(const spirv::ResultShape& shape) {
    return shape.type ? 1 : 0;
}

bool is_terminator(std::uint32_t opcode) {
    constexpr std::array ends{
        SpvOpBranch, SpvOpBranchConditional, SpvOpSwitch,      SpvOpKill,
        SpvOpReturn, SpvOpReturnValue,       SpvOpUnreachable, SpvOpTerminateInvocation};
    return std::ranges::find(ends, opcode) != ends.end();
}

bool is_decoration(std::uint32_t opcode) {
    return opcode >= SpvOpDecorate && opcode <= SpvOpGroupMemberDecorate;
}

bool is_of_types(std::uint32_t opcode) {
    return (opcode >= SpvOpTypeVoid && opcode <= SpvOpTypeForwardPointer) || opcode == SpvOpUndef ||
           (opcode >= SpvOpConstantTrue && opcode <= SpvOpSpecConstantOp) || opcode == SpvOpVariable;
}

// The operands that are IDs, counted from the first behind the result: none, the first few, or all.
std::optional<std::size_t> leading_ids(std::uint32_t opcode) {
    constexpr std::size_t all = ~std::size_t{0};
    if (opcode >= SpvOpConvertFToU && opcode <= SpvOpBitcast) return all;
    if (opcode >= SpvOpSNegate && opcode <= SpvOpBitCount) return all;
    if (opcode >= SpvOpAny && opcode <= SpvOpFUnordGreaterThanEqual) return all;
    static const std::map<std::uint32_t, std::size_t> others{{SpvOpAccessChain, all},
                                                             {SpvOpInBoundsAccessChain, all},
                                                             {SpvOpCompositeConstruct, all},
                                                             {SpvOpFunctionCall, all},
                                                             {SpvOpTranspose, all},
                                                             {SpvOpCopyObject, all},
                                                             {SpvOpExtInst, all},
                                                             {SpvOpVectorExtractDynamic, all},
                                                             {SpvOpVectorInsertDynamic, all},
                                                             {SpvOpLoad, 1},
                                                             {SpvOpCompositeExtract, 1},
                                                             {SpvOpStore, 2},
                                                             {SpvOpVectorShuffle, 2},
                                                             {SpvOpCompositeInsert, 2}};
    const auto found = others.find(opcode);
    return found == others.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Id Op::type() const {
    return spirv::result_shape(opcode).type ? words[0] : 0;
}

Id Op::result() const {
    const spirv::ResultShape shape = spirv::result_shape(opcode);
    return shape.result ? words[result_place(shape)] : 0;
}

void Op::set_result(Id id) {
    words[result_place(spirv::result_shape(opcode))] = id;
}

std::span<const std::uint32_t> Op::operands() const {
    const spirv::ResultShape shape = spirv::result_shape(opcode);
    return std::span(words).subspan((shape.type ? 1U : 0U) + (shape.result ? 1U : 0U));
}

bool Op::knows_ids() const {
    return leading_ids(opcode).has_value();
}

void Op::visit_ids(const std::function<void(std::uint32_t& id)>& visit) {
    const std::size_t begin = opcode == SpvOpExtInst ? 2 : 0;  // the set, then the number of the instruction
    const std::size_t first = words.size() - operands().size() + begin;
    const std::size_t ids = leading_ids(opcode).value_or(0);
    for (std::size_t i = first; i < words.size() && i - first < ids; ++i) visit(words[i]);
}

bool Block::is_loop_header() const {
    return std::ranges::any_of(ops, [](const Op& op) { return op.opcode == SpvOpLoopMerge; });
}

std::size_t Block::first_free() const {
    std::size_t at = 1;
    while (ops[at].opcode == SpvOpPhi || ops[at].opcode == SpvOpVariable || ops[at].opcode == SpvOpLine) ++at;
    return at;
}

std::size_t Block::last_free() const {
    const std::size_t end = ops.size() - 1;
    const bool merges = ops[end - 1].opcode == SpvOpSelectionMerge || ops[end - 1].opcode == SpvOpLoopMerge;
    return merges ? end - 1 : end;
}

Editable::Editable(const Spirv& module) {
    const std::vector<Instruction> all = instructions(module);
    header_.assign(module.begin(), module.begin() + header_words);
    bound_ = header_[bound_word];
    for (const Instruction& one : all) {
        const Op op{one.opcode, {one.words.begin() + 1, one.words.end()}};
        if (one.opcode == SpvOpFunction) {
            functions.push_back({.header = op, .parameters = {}, .blocks = {}});
        } else if (functions.empty()) {
            if (is_decoration(one.opcode)) {
                decorations_.push_back(op);
            } else if (!globals_.empty() || is_of_types(one.opcode)) {
                if (op.result() != 0) places_[op.result()] = globals_.size();
                globals_.push_back(op);
            } else {
                debug_.push_back(op);
            }
        } else if (one.opcode == SpvOpFunctionParameter) {
            functions.back().parameters.push_back(op);
        } else if (one.opcode == SpvOpLabel) {
            functions.back().blocks.push_back({{op}});
        } else if (one.opcode != SpvOpFunctionEnd && one.opcode != SpvOpLine && one.opcode != SpvOpNoLine) {
            if (functions.back().blocks.empty())
                throw std::runtime_error("no SPIR-V module: an instruction outside of a block");
            functions.back().blocks.back().ops.push_back(op);
        }
    }
    for (const FunctionBody& function : functions)
        for (const Block& block : function.blocks)
            if (!is_terminator(block.end().opcode))
                throw std::runtime_error("no SPIR-V module: a block without an end");
}

Spirv Editable::words() const {
    Spirv module = header_;
    module[bound_word] = bound_;
    const auto add = [&module](const std::vector<Op>& ops) {
        for (const Op& op : ops) {
            const Spirv words = instruction(op.opcode, op.words);
            module.insert(module.end(), words.begin(), words.end());
        }
    };
    for (const std::vector<Op>* section : {&debug_, &decorations_, &globals_}) add(*section);
    for (const FunctionBody& function : functions) {
        add({function.header});
        add(function.parameters);
        for (const Block& block : function.blocks) add(block.ops);
        add({Op{SpvOpFunctionEnd, {}}});
    }
    return module;
}

const Op* Editable::global(Id id) const {
    const auto found = places_.find(id);
    return found == places_.end() ? nullptr : &globals_[found->second];
}

const Op* Editable::find_global(const std::function<bool(const Op&)>& wanted) const {
    const auto found = std::ranges::find_if(globals_, wanted);
    return found == globals_.end() ? nullptr : &*found;
}

Id Editable::global_of(std::uint32_t opcode, Id type, const std::vector<std::uint32_t>& operands) {
    const Op* known = find_global([&](const Op& op) {
        return op.opcode == opcode && op.type() == type && std::ranges::equal(op.operands(), operands);
    });
    if (known != nullptr) return known->result();
    Op made{opcode, {}};
    if (type != 0) made.words.push_back(type);
    const Id id = fresh();
    made.words.push_back(id);
    made.words.insert(made.words.end(), operands.begin(), operands.end());
    places_[id] = globals_.size();
    globals_.push_back(std::move(made));
    return id;
}

bool Editable::is_of_numbers(Id type) const {
    const Op* op = global(type);
    if (op == nullptr) return false;
    if (op->opcode == SpvOpTypeVector || op->opcode == SpvOpTypeMatrix)
        return is_of_numbers(op->operands()[0]);
    return op->opcode == SpvOpTypeBool || op->opcode == SpvOpTypeInt || op->opcode == SpvOpTypeFloat;
}

std::map<Id, Id> Editable::types_of(const Spot& spot) const {
    std::map<Id, Id> types;
    const auto add = [&types](const Op& op) {
        if (op.type() != 0 && op.result() != 0) types[op.result()] = op.type();
    };
    for (const Op& op : globals_) add(op);
    for (const Op& op : functions[spot.function].parameters) add(op);
    for (const Block& block : blocks_of(*this, spot))
        for (const Op& op : block.ops) add(op);
    return types;
}

void Editable::share_decorations(Id from, Id to, bool moves) {
    const std::size_t count = decorations_.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (decorations_[i].opcode != SpvOpDecorate || decorations_[i].words[0] != from) continue;
        const bool of_arithmetic = decorations_[i].words[1] == SpvDecorationNoContraction;
        if (moves && of_arithmetic) {
            decorations_[i].words[0] = to;
        } else {
            Op copy = decorations_[i];
            copy.words[0] = to;
            decorations_.push_back(std::move(copy));
        }
    }
}

std::string Editable::name_of(Id id) const {
    for (const Op& op : debug_) {
        if (op.opcode != SpvOpName || op.words[0] != id) continue;
        const Spirv words = instruction(op.opcode, op.words);
        return literal_string({.opcode = SpvOpName, .words = words}, 2);
    }
    return {};
}

void Editable::insert(const Spot& spot, const std::vector<Op>& ops) {
    std::vector<Op>& all = block_of(*this, spot).ops;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(spot.op), ops.begin(), ops.end());
}

Id Editable::split(const Spot& spot) {
    std::vector<Block>& blocks = blocks_of(*this, spot);
    Block& first = blocks[spot.block];
    const Id label = fresh();
    Block second{{Op{SpvOpLabel, {label}}}};
    const auto cut = first.ops.begin() + static_cast<std::ptrdiff_t>(spot.op);
    second.ops.insert(second.ops.end(), cut, first.ops.end());
    first.ops.erase(cut, first.ops.end());
    const Id before = first.label();
    blocks.insert(blocks.begin() + static_cast<std::ptrdiff_t>(spot.block) + 1, std::move(second));
    for (Block& block : blocks)  // what came from the first part comes from the second now
        for (Op& op : block.ops)
            for (std::size_t w = 3; op.opcode == SpvOpPhi && w < op.words.size(); w += 2)
                if (op.words[w] == before) op.words[w] = label;
    return label;
}

}  // namespace gloam::shader::internal
