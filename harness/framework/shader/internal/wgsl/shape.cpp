// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/function_writer.hpp"

#include <algorithm>

namespace gloam::shader::internal::wgsl {
namespace {

class Folder {
  public:
    Folder(const Module& module, const Facts& facts, const Function& function, Shape& shape)
        : module_(module), facts_(facts), function_(function), shape_(shape) {
        for (const Variable& variable : function.variables)
            if (module.name_of(variable.id).empty()) nameless_.insert(variable.id);
        for (const auto& [label, block] : function.blocks)
            for (const Instruction& i : block.body)
                if (i.opcode == SpvOpStore) ++stores_[i.word(1)];
    }

    void run() {
        for (const Id label : function_.order) (void)fold_at(label);
    }

  private:
    // A branch without effects from a block to the merge: its blocks, and what it stores into a variable
    // without a name.
    struct Arm {
        std::vector<Id> blocks;
        Id last = 0;
        Id variable = 0;
        Id value = 0;
        bool calls = false;
    };

    const Fold* fold_at(Id label) {
        const auto known = shape_.folds.find(label);
        if (known != shape_.folds.end()) return &known->second;
        if (!tried_.insert(label).second) return nullptr;
        const Block& block = function_.block(label);
        if (!block.merge || block.merge->opcode != SpvOpSelectionMerge ||
            block.end.opcode != SpvOpBranchConditional)
            return nullptr;
        std::optional<Fold> fold = fold_of(block, block.merge->word(1));
        if (!fold) return nullptr;
        shape_.fold_results.insert(fold->result);
        if (fold->negation != 0) shape_.idle_values.insert(fold->negation);
        return &(shape_.folds[label] = *fold);
    }

    std::optional<Fold> fold_of(const Block& block, Id merge) {
        const Id yes = block.end.word(2);
        const Id no = block.end.word(3);
        const Block& end = function_.block(merge);
        const bool has_phi = !end.body.empty() && end.body.front().opcode == SpvOpPhi;
        if (has_phi && end.body.size() > 1 && end.body[1].opcode == SpvOpPhi) return std::nullopt;
        if (has_phi && (yes == merge || no == merge)) return logic_of(block, end, yes == merge ? no : yes);
        if (yes == merge || no == merge) return std::nullopt;
        const std::optional<Arm> first = arm_of(yes, merge);
        const std::optional<Arm> second = first ? arm_of(no, merge) : std::nullopt;
        if (!first || !second || first->calls || second->calls) return std::nullopt;
        Fold fold{.condition = block.end.word(1), .blocks = first->blocks, .merge = merge};
        fold.blocks.insert(fold.blocks.end(), second->blocks.begin(), second->blocks.end());
        if (has_phi) {
            const Instruction& phi = end.body.front();
            if (!can_select(phi.word(1)) || first->variable != 0 || second->variable != 0)
                return std::nullopt;
            fold.result = phi.word(2);
            fold.yes = incoming(phi, first->last);
            fold.no = incoming(phi, second->last);
            return fold;
        }
        if (first->variable == 0 || first->variable != second->variable) return std::nullopt;
        if (!can_select(module_.pointee(first->variable)) || stores_[first->variable] != 2)
            return std::nullopt;
        fold.result = first->variable;
        fold.yes = first->value;
        fold.no = second->value;
        return fold;
    }

    // `c && x` where only one branch calculates something; the phi has c, or what is known of it, from here.
    std::optional<Fold> logic_of(const Block& block, const Block& end, Id start) {
        const std::optional<Arm> arm = arm_of(start, end.label);
        const Instruction& phi = end.body.front();
        if (!arm || arm->variable != 0 || module_.type(phi.word(1)).kind != Type::Kind::boolean)
            return std::nullopt;
        const Id condition = block.end.word(1);
        const bool taken_when_true = block.end.word(2) == start;
        const Id known = incoming(phi, block.label);
        Fold fold{.result = phi.word(2), .condition = condition, .yes = incoming(phi, arm->last)};
        fold.blocks = arm->blocks;
        fold.merge = end.label;
        if (known == condition && taken_when_true) {
            fold.kind = Fold::Kind::conjunction;
        } else if (known == condition) {
            fold.kind = Fold::Kind::disjunction;
        } else if (is_negation(block, condition, known) && taken_when_true) {
            fold.kind = Fold::Kind::disjunction;
            fold.condition = known;
            fold.negation = condition;
        } else {
            return std::nullopt;
        }
        return fold;
    }

    static bool is_negation(const Block& block, Id condition, Id of) {
        return std::ranges::any_of(block.body, [&](const Instruction& i) {
            return i.opcode == SpvOpLogicalNot && i.word(2) == condition && i.word(3) == of;
        });
    }

    static Id incoming(const Instruction& phi, Id from) {
        for (std::size_t w = 3; w + 1 < phi.words.size(); w += 2)
            if (phi.word(w + 1) == from) return phi.word(w);
        return 0;
    }

    [[nodiscard]] bool can_select(Id type) const {
        const Type::Kind kind = module_.type(type).kind;
        return kind != Type::Kind::structure && kind != Type::Kind::array && kind != Type::Kind::matrix;
    }

    std::optional<Arm> arm_of(Id start, Id merge) {
        Arm arm;
        for (Id label = start; label != merge;) {
            const Block& block = function_.block(label);
            arm.blocks.push_back(label);
            arm.last = label;
            for (const Instruction& i : block.body)
                if (!takes(i, arm)) return std::nullopt;
            if (block.merge) {
                const Fold* inner = fold_at(label);
                if (inner == nullptr) return std::nullopt;
                arm.blocks.insert(arm.blocks.end(), inner->blocks.begin(), inner->blocks.end());
                label = inner->merge;
            } else if (block.end.opcode == SpvOpBranch && block.end.word(1) == merge) {
                break;
            } else {
                return std::nullopt;
            }
        }
        return arm.blocks.empty() ? std::nullopt : std::optional(arm);
    }

    // Whether the instruction has no effect. Stores of inner folds are in other blocks.
    bool takes(const Instruction& i, Arm& arm) {
        switch (i.opcode) {
            case SpvOpStore:
                if (arm.variable != 0 || !nameless_.contains(i.word(1))) return is_bound_store(i);
                arm.variable = i.word(1);
                arm.value = i.word(2);
                return true;
            case SpvOpFunctionCall: {
                const FunctionFacts& callee = facts_.of(i.word(3));
                arm.calls = true;
                return !callee.changes_memory && callee.pointers_written.empty();
            }
            case SpvOpImageRead:
            case SpvOpImageFetch:
            case SpvOpImageSampleExplicitLod:
            case SpvOpImageGather:
                arm.calls = true;
                return true;
            case SpvOpPhi:
                return shape_.fold_results.contains(i.word(2));
            default:
                return result_of(i) != 0 && !is_subgroup_operation(i.opcode) && !is_derivative(i.opcode) &&
                       (i.opcode < SpvOpAtomicLoad || i.opcode > SpvOpAtomicXor);
        }
    }

    [[nodiscard]] bool is_bound_store(const Instruction& i) const { return shape_.bound.contains(i.word(1)); }

    const Module& module_;
    const Facts& facts_;
    const Function& function_;
    Shape& shape_;
    std::set<Id> tried_;
    std::set<Id> nameless_;
    std::map<Id, int> stores_;
};

}  // namespace

void find_folds(const Module& module, const Facts& facts, const Function& function, Shape& shape) {
    Folder(module, facts, function, shape).run();
}

}  // namespace gloam::shader::internal::wgsl
