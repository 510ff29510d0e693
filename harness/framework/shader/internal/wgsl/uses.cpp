// SPDX-License-Identifier: MIT
#include <algorithm>

#include "shader/internal/wgsl/function_writer.hpp"

namespace gloam::shader::internal::wgsl {

void find_folds(const Module& module, const Facts& facts, const Function& function, Shape& shape);

namespace {

// The block, a call in it, and the position of an argument.
struct Given {
    const Block* block = nullptr;
    std::size_t call = 0;  // in the block
    std::size_t parameter = 0;
};

class Arguments {
  public:
    Arguments(const Module& module, const Facts& facts, const Function& function, Shape& shape)
        : module_(module), facts_(facts), function_(function), shape_(shape) {}

    void run() {
        for (const auto& [label, block] : function_.blocks)
            for (std::size_t k = 0; k < block.body.size(); ++k)
                if (block.body[k].opcode == SpvOpFunctionCall) run_call(block, k);
    }

  private:
    void run_call(const Block& block, std::size_t at) {
        const Instruction& call = block.body[at];
        const std::vector<Passing>& passing = facts_.of(call.word(3)).passing;
        std::set<Id> given;
        for (std::size_t p = 0; p < passing.size(); ++p) {
            const Id argument = call.word(p + 4);
            if (std::ranges::find(function_.variables, argument, &Variable::id) == function_.variables.end())
                continue;
            const VariableUses& uses = facts_.uses_of(argument);
            const std::optional<std::size_t> stored = store_before(block, at, argument);
            if (passing[p] != Passing::pointer) {
                if (uses.calls == 1 && uses.stores == 1 && uses.parts == 0 && uses.loads == 0 && stored)
                    shape_.bound.insert(argument);
            } else {
                replace(block, {&block, at, p}, argument, stored, given);
            }
        }
    }

    // Looks for: the variable is set from another one before the call, if at all, and copied to the same one
    // behind it, and not used otherwise.
    void replace(const Block& block, const Given& given, Id argument, std::optional<std::size_t> stored,
                 std::set<Id>& taken) {
        const VariableUses& uses = facts_.uses_of(argument);
        if (uses.calls != 1 || uses.loads != 1 || uses.parts != 0 || uses.stores > 1) return;
        if ((uses.stores == 1) != stored.has_value()) return;
        std::size_t load = given.call + 1;
        while (load < block.body.size() &&
               !(block.body[load].opcode == SpvOpLoad && block.body[load].word(3) == argument))
            ++load;
        if (load + 1 >= block.body.size()) return;
        const Instruction& store = block.body[load + 1];
        if (store.opcode != SpvOpStore || store.word(2) != block.body[load].word(2)) return;
        if (!is_used_once(store.word(2))) return;
        const Id other = store.word(1);
        if (!is_local(other) || facts_.base_of(other) != other) return;
        if (!only_copies(block, given.call + 1, load)) return;
        if (stored && !is_load_of(block, *stored, other)) return;
        if (mentions(block.body[given.call], other) || !taken.insert(other).second) return;
        shape_.same[argument] = other;
        shape_.idle.insert(block.body[load].at);
        shape_.idle.insert(store.at);
        if (stored) shape_.idle.insert(block.body[*stored].at);
    }

    [[nodiscard]] bool is_used_once(Id value) const {
        std::ptrdiff_t uses = 0;
        for (const auto& [label, block] : function_.blocks) {
            for (const Instruction& i : block.body) uses += std::ranges::count(operands(i), value);
            uses += std::ranges::count(operands(block.end), value);
        }
        return uses == 1;
    }

    // A variable of the function, or one of its parameters that is a pointer in WGSL.
    [[nodiscard]] bool is_local(Id id) const {
        if (std::ranges::find(function_.variables, id, &Variable::id) != function_.variables.end())
            return true;
        const auto parameter = std::ranges::find(function_.parameters, id);
        if (parameter == function_.parameters.end()) return false;
        const auto p = static_cast<std::size_t>(parameter - function_.parameters.begin());
        return facts_.of(function_.id).passing.at(p) != Passing::value;
    }

    static bool only_copies(const Block& block, std::size_t first, std::size_t end) {
        for (std::size_t k = first; k < end; ++k) {
            const std::uint32_t opcode = block.body[k].opcode;
            if (opcode != SpvOpLoad && opcode != SpvOpStore) return false;
        }
        return true;
    }

    static bool mentions(const Instruction& call, Id variable) {
        return std::ranges::find(call.words.subspan(4), variable) != call.words.end();
    }

    static bool is_load_of(const Block& block, std::size_t store, Id variable) {
        if (store == 0) return false;
        const Instruction& load = block.body[store - 1];
        return load.opcode == SpvOpLoad && load.word(3) == variable &&
               load.word(2) == block.body[store].word(2);
    }

    static std::optional<std::size_t> store_before(const Block& block, std::size_t at, Id variable) {
        for (std::size_t k = at; k-- > 0;)
            if (block.body[k].opcode == SpvOpStore && block.body[k].word(1) == variable) return k;
        return std::nullopt;
    }

    const Module& module_;
    const Facts& facts_;
    const Function& function_;
    Shape& shape_;
};

void join(Shape& shape, const std::vector<Id>& blocks) {
    const Id first = shape.straight[blocks.front()];
    std::set<Id> old;
    for (const Id block : blocks) old.insert(shape.straight[block]);
    for (auto& [block, head] : shape.straight)
        if (old.contains(head)) head = first;
}

// How many branches lead to each block; the targets of merges count as many.
std::map<Id, int> ways_to_blocks(const Function& function) {
    std::map<Id, int> ways;
    for (const auto& [label, block] : function.blocks) {
        const Instruction& end = block.end;
        const bool branches = end.opcode == SpvOpBranch || end.opcode == SpvOpBranchConditional;
        for (std::size_t w = end.opcode == SpvOpBranch ? 1 : 2; branches && w < end.words.size() && w < 4;
             ++w)
            ++ways[end.word(w)];
        for (std::size_t w = 2; end.opcode == SpvOpSwitch && w < end.words.size(); w += 2)
            ways[end.word(w)] += 2;
        if (!block.merge) continue;
        ways[block.merge->word(1)] += 2;
        if (block.merge->opcode == SpvOpLoopMerge) {
            ways[block.merge->word(2)] += 2;
            ways[label] += 2;
        }
    }
    return ways;
}

// Blocks that run one after another: those of a fold, and one that only follows another.
void join_blocks(const Function& function, Shape& shape) {
    for (const Id label : function.order) shape.straight[label] = label;
    for (const Id label : function.order) {
        const auto fold = shape.folds.find(label);
        if (fold == shape.folds.end()) continue;
        std::vector<Id> joined{label};
        joined.insert(joined.end(), fold->second.blocks.begin(), fold->second.blocks.end());
        joined.push_back(fold->second.merge);
        join(shape, joined);
    }
    const std::map<Id, int> ways = ways_to_blocks(function);
    for (const auto& [label, block] : function.blocks)
        if (block.end.opcode == SpvOpBranch && !block.merge &&
            entry_of(ways, block.end.word(1), "a branch to a block of another function") == 1)
            join(shape, {label, block.end.word(1)});
}

bool leads_to(const Block& block, Id target) {
    const std::size_t first = block.end.opcode == SpvOpBranch ? 1 : 2;
    return std::ranges::find(block.end.words.subspan(std::min(first, block.end.words.size())), target) !=
           block.end.words.end();
}

// The value of a phi that only one block gives, or 0.
Id only_value(const Function& function, const Instruction& phi, Id here) {
    Id value = 0;
    for (std::size_t w = 3; w + 1 < phi.words.size(); w += 2) {
        const auto from = function.blocks.find(phi.word(w + 1));
        if (from == function.blocks.end() || !leads_to(from->second, here)) continue;
        if (value != 0) return 0;
        value = phi.word(w);
    }
    return value;
}

void count(Shape& shape, Id value, Id block) {
    const Id here = entry_of(shape.straight, block, "a value of a block that is not reached");
    const int uses = ++shape.uses[value];
    Id& home = shape.home[value];
    home = uses == 1 || home == here ? here : 0;
}

// Without repetitions where a vector is made of one scalar alone: it is written once.
std::vector<Id> written_operands(const Instruction& i) {
    std::vector<Id> ids = operands(i);
    const bool equal = std::ranges::all_of(ids, [&](Id id) { return id == ids.front(); });
    if (i.opcode == SpvOpCompositeConstruct && equal) ids.resize(1);
    return ids;
}

void count_uses(const Function& function, Shape& shape) {
    for (const auto& [label, block] : function.blocks) {
        for (const Instruction& i : block.body) {
            if (const Id result = result_of(i); result != 0)
                shape.defined_in[result] =
                    entry_of(shape.straight, label, "a value of a block that is not reached");
            if (shape.idle.contains(i.at) || shape.idle_values.contains(result_of(i))) continue;
            if (i.opcode == SpvOpPhi && shape.fold_results.contains(i.word(2))) continue;
            if (const Id only = i.opcode == SpvOpPhi ? only_value(function, i, label) : 0; only != 0) {
                shape.only_values[i.word(2)] = only;
                count(shape, only, label);
                continue;
            }
            if (i.opcode == SpvOpPhi) {
                for (std::size_t w = 3; w + 1 < i.words.size(); w += 2)
                    if (function.blocks.contains(i.word(w + 1))) count(shape, i.word(w), i.word(w + 1));
                continue;
            }
            if (i.opcode == SpvOpStore && shape.fold_results.contains(i.word(1))) continue;
            for (const Id id : written_operands(i)) count(shape, id, label);
        }
        const auto fold = shape.folds.find(label);
        if (fold == shape.folds.end()) {
            for (const Id id : operands(block.end)) count(shape, id, label);
            continue;
        }
        count(shape, fold->second.condition, label);
        count(shape, fold->second.yes, label);
        if (fold->second.kind == Fold::Kind::either) count(shape, fold->second.no, label);
    }
}

}  // namespace

Shape shape_of(const Module& module, const Facts& facts, const Function& function) {
    Shape shape;
    Arguments(module, facts, function, shape).run();
    find_folds(module, facts, function, shape);
    join_blocks(function, shape);
    count_uses(function, shape);
    return shape;
}

}  // namespace gloam::shader::internal::wgsl
