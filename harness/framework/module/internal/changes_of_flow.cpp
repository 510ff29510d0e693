// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>

#include "module/internal/changes.hpp"

namespace gloam::shader::internal {
namespace {

constexpr std::uint32_t none = 0;  // of SpvSelectionControlMask, SpvLoopControlMask

Op branch(Id to) {
    return {SpvOpBranch, {to}};
}

Op branch(Id condition, Id yes, Id no) {
    return {SpvOpBranchConditional, {condition, yes, no}};
}

Block labelled(Id label, std::vector<Op> ops) {
    Block block{{Op{SpvOpLabel, {label}}}};
    block.ops.insert(block.ops.end(), ops.begin(), ops.end());
    return block;
}

// Whether the spot is the label of a block that can be divided, with so many instructions. A loop begins at
// its header, and must end there.
bool is_divisible(const Editable& module, const Spot& spot, std::size_t least_ops) {
    const Block& block = block_of(module, spot);
    return spot.op == 0 && !block.is_loop_header() && block.last_free() >= block.first_free() + least_ops;
}

bool has_one(const Editable& module, const Spot& spot) {
    return is_divisible(module, spot, 1);
}

bool has_two(const Editable& module, const Spot& spot) {
    return is_divisible(module, spot, 2);
}

bool has_four(const Editable& module, const Spot& spot) {
    return is_divisible(module, spot, 4);
}

void append(Block& block, const std::vector<Op>& ops) {
    block.ops.insert(block.ops.end(), ops.begin(), ops.end());
}

// Inserts blocks behind that of the spot.
void insert_blocks(Editable& module, const Spot& spot, const std::vector<Block>& made) {
    std::vector<Block>& all = blocks_of(module, spot);
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(spot.block) + 1, made.begin(), made.end());
}

// A position between the instructions of a block.
Spot some_position(const Editable& module, const Spot& spot, Chance& chance) {
    const Block& block = block_of(module, spot);
    const std::size_t free = block.last_free() - block.first_free() + 1;
    return {spot.function, spot.block, block.first_free() + chance.below(free)};
}

bool divide(Editable& module, const Spot& spot, Chance& chance) {
    const Id rest = module.split(some_position(module, spot, chance));
    append(block_of(module, spot), {branch(rest)});
    return true;
}

// Instructions for a branch that is never taken: copies of those before it, and a store.
std::vector<Op> dead_code(Editable& module, const Spot& spot, Chance& chance) {
    std::vector<Op> code;
    const Block& block = block_of(module, spot);
    for (std::size_t i = block.first_free(); i < block.ops.size() && code.size() < 4; ++i) {
        Op copy = block.ops[i];
        const bool is_value = copy.type() != 0 && module.is_of_numbers(copy.type());
        if (!is_value || copy.opcode == SpvOpFunctionCall || !copy.knows_ids()) continue;
        if (chance.below(2) == 0) continue;
        copy.set_result(module.fresh());
        code.push_back(std::move(copy));
    }
    for (const Op& op : block.ops) {
        if (op.opcode != SpvOpLoad || chance.below(2) == 0) continue;
        const Op* pointer = module.global(module.types_of(spot).at(op.operands()[0]));
        if (pointer->operands()[0] != SpvStorageClassFunction) continue;
        code.push_back({SpvOpStore, {op.operands()[0], module.global_of(SpvOpConstantNull, op.type(), {})}});
        break;
    }
    return code;
}

bool never_taken(Editable& module, const Spot& spot, Chance& chance) {
    const Id rest = module.split(some_position(module, spot, chance));
    std::vector<Op> code = dead_code(module, spot, chance);
    const Id dead = module.fresh();
    code.push_back(branch(rest));
    const Opaque no = opaque_false(module, chance);
    append(block_of(module, spot), no.ops);
    append(block_of(module, spot), {{SpvOpSelectionMerge, {rest, none}}, branch(no.id, dead, rest)});
    insert_blocks(module, spot, {labelled(dead, std::move(code))});
    return true;
}

bool loop_once(Editable& module, const Spot& spot, Chance& chance) {
    const Id body = module.split(some_position(module, spot, chance));
    const Spot inside{spot.function, spot.block + 1, 0};
    const Id rest = module.split(some_position(module, inside, chance));
    const Id header = module.fresh();
    const Id again = module.fresh();
    append(block_of(module, spot), {branch(header)});
    append(block_of(module, inside), {branch(again)});
    Opaque no = opaque_false(module, chance);
    no.ops.push_back(branch(no.id, header, rest));
    insert_blocks(module, inside, {labelled(again, no.ops)});
    insert_blocks(module, spot, {labelled(header, {{SpvOpLoopMerge, {rest, again, none}}, branch(body)})});
    return true;
}

bool is_branch(const Editable& module, const Spot& spot) {
    return at(module, spot).opcode == SpvOpBranchConditional;
}

// A branch of a selection, not one that leaves or repeats a loop. Not in a function that has a switch: inside
// a switch no branch may leave an outer one.
bool is_selection(const Editable& module, const Spot& spot) {
    const auto has_switch = [](const Block& block) { return block.end().opcode == SpvOpSwitch; };
    return is_branch(module, spot) && block_of(module, spot).ops[spot.op - 1].opcode == SpvOpSelectionMerge &&
           std::ranges::none_of(blocks_of(module, spot), has_switch);
}

bool negate_condition(Editable& module, const Spot& spot, Chance&) {
    Block& block = block_of(module, spot);
    Op& end = block.ops.back();
    const Op inverse{SpvOpLogicalNot, {module.bool_type(), module.fresh(), end.words[0]}};
    end = branch(inverse.result(), end.words[2], end.words[1]);
    module.insert({spot.function, spot.block, block.last_free()}, {inverse});
    return true;
}

bool branch_by_switch(Editable& module, const Spot& spot, Chance&) {
    Block& block = block_of(module, spot);
    const Op end = block.ops.back();
    if (end.words[1] == end.words[2]) return false;
    const Op number{
        SpvOpSelect,
        {module.uint_type(), module.fresh(), end.words[0], module.uint_constant(1), module.uint_constant(0)}};
    block.ops.back() = {SpvOpSwitch, {number.result(), end.words[2], 1, end.words[1]}};
    module.insert({spot.function, spot.block, block.last_free()}, {number});
    return true;
}

bool selects_by_one(const Editable& module, const Spot& spot) {
    const Op& op = at(module, spot);
    return op.opcode == SpvOpSelect && !block_of(module, spot).is_loop_header() &&
           module.global(module.types_of(spot).at(op.operands()[0]))->opcode == SpvOpTypeBool;
}

bool select_by_branches(Editable& module, const Spot& spot, Chance&) {
    const Op select = at(module, spot);
    std::vector<Op>& ops = block_of(module, spot).ops;
    ops.erase(ops.begin() + static_cast<std::ptrdiff_t>(spot.op));
    const Id rest = module.split(spot);
    const Id yes = module.fresh();
    const Id no = module.fresh();
    const auto from = select.operands();
    module.insert({spot.function, spot.block + 1, 1},
                  {{SpvOpPhi, {select.type(), select.result(), from[1], yes, from[2], no}}});
    append(block_of(module, spot), {{SpvOpSelectionMerge, {rest, none}}, branch(from[0], yes, no)});
    insert_blocks(module, spot, {labelled(yes, {branch(rest)}), labelled(no, {branch(rest)})});
    return true;
}

// Straight code whose values can be kept in variables.
struct Straight {
    std::size_t begin = 0;
    std::size_t end = 0;
};

std::optional<Straight> straight_code(const Editable& module, const Block& block, Chance& chance) {
    constexpr std::size_t least = 4;
    constexpr std::size_t most = 24;
    const auto can_move = [&](const Op& op) {
        const bool is_store = op.opcode == SpvOpStore;
        return (is_store || (op.type() != 0 && module.is_of_numbers(op.type()))) && op.knows_ids();
    };
    std::vector<Straight> runs;
    for (std::size_t i = block.first_free(); i < block.last_free(); ++i) {
        std::size_t end = i;
        while (end < block.last_free() && end - i < most && can_move(block.ops[end])) ++end;
        if (end - i >= least) runs.push_back({i, end});
        i = end;
    }
    return runs.empty() ? std::nullopt : std::optional(chance.of(runs));
}

// Moves straight code into the cases of a switch in a loop, as an obfuscator does. Values pass between the
// cases in variables, and get their own IDs behind the loop.
class Dispatcher {
  public:
    Dispatcher(Editable& module, const Spot& spot, std::size_t cases)
        : module_(module), spot_(spot), cases_(cases) {}

    void move(const Straight& run) {
        Block& block = block_of(module_, spot_);
        const auto begin = block.ops.begin() + static_cast<std::ptrdiff_t>(run.begin);
        const auto end = block.ops.begin() + static_cast<std::ptrdiff_t>(run.end);
        code_.assign(begin, end);
        block.ops.erase(begin, end);
        rest_ = module_.split({spot_.function, spot_.block, run.begin});
        state_ = variable(module_.uint_type());
        const std::vector<Block> made = cases();
        append(block_of(module_, spot_), {{SpvOpStore, {state_, module_.uint_constant(0)}}, branch(header_)});
        insert_blocks(module_, spot_, made);
        module_.insert({spot_.function, spot_.block + made.size() + 1, 1}, given_);
        module_.insert({spot_.function, 0, 1}, variables_);
    }

  private:
    Id variable(Id type) {
        const Id pointer = module_.global_of(SpvOpTypePointer, 0, {SpvStorageClassFunction, type});
        variables_.push_back({SpvOpVariable, {pointer, module_.fresh(), SpvStorageClassFunction}});
        return variables_.back().result();
    }

    // The loop: header, dispatch, cases, end of the switch, continue target.
    std::vector<Block> cases() {
        const Id dispatch = module_.fresh();
        const Id joined = module_.fresh();
        const Id again = module_.fresh();
        const Id state = module_.fresh();
        std::vector<Block> made{
            labelled(header_, {{SpvOpLoopMerge, {rest_, again, none}}, branch(dispatch)})};
        std::vector<std::uint32_t> targets{state, joined};
        std::vector<Block> bodies;
        for (std::size_t c = 0; c < cases_; ++c) {
            targets.push_back(static_cast<std::uint32_t>(c));
            targets.push_back(module_.fresh());
            bodies.push_back(labelled(targets.back(), body(c, joined)));
        }
        made.push_back(labelled(dispatch, {{SpvOpLoad, {module_.uint_type(), state, state_}},
                                           {SpvOpSelectionMerge, {joined, none}},
                                           {SpvOpSwitch, targets}}));
        made.insert(made.end(), bodies.begin(), bodies.end());
        made.push_back(labelled(joined, {branch(again)}));
        const Id at = module_.fresh();
        const Id more = module_.fresh();
        const Id last = module_.uint_constant(static_cast<std::uint32_t>(cases_));
        made.push_back(labelled(again, {{SpvOpLoad, {module_.uint_type(), at, state_}},
                                        {SpvOpULessThan, {module_.bool_type(), more, at, last}},
                                        branch(more, header_, rest_)}));
        return made;
    }

    std::vector<Op> body(std::size_t c, Id joined) {
        std::vector<Op> ops;
        std::map<Id, Id> here;  // the IDs, in this case, of the code's values
        for (std::size_t i = code_.size() * c / cases_; i < code_.size() * (c + 1) / cases_; ++i) {
            Op op = code_[i];
            op.visit_ids([&](std::uint32_t& id) {
                const auto kept = kept_.find(id);
                if (kept == kept_.end()) return;
                const auto [known, is_new] = here.try_emplace(id, 0);
                if (is_new) {
                    known->second = module_.fresh();
                    ops.push_back({SpvOpLoad, {kept->second.type, known->second, kept->second.variable}});
                }
                id = known->second;
            });
            if (op.opcode == SpvOpStore) {
                ops.push_back(std::move(op));
                continue;
            }
            const Id outside = op.result();
            const Id inside = module_.fresh();
            op.set_result(inside);
            module_.share_decorations(outside, inside, true);
            const Kept kept{op.type(), variable(op.type())};
            ops.push_back(std::move(op));
            ops.push_back({SpvOpStore, {kept.variable, inside}});
            here[outside] = inside;
            kept_[outside] = kept;
            given_.push_back({SpvOpLoad, {kept.type, outside, kept.variable}});
        }
        ops.push_back({SpvOpStore, {state_, module_.uint_constant(static_cast<std::uint32_t>(c + 1))}});
        ops.push_back(branch(joined));
        return ops;
    }

    struct Kept {
        Id type = 0;
        Id variable = 0;
    };

    Editable& module_;
    Spot spot_;
    std::size_t cases_;
    std::vector<Op> code_;
    std::map<Id, Kept> kept_;
    std::vector<Op> given_;
    std::vector<Op> variables_;
    Id rest_ = 0;
    Id state_ = 0;
    Id header_ = module_.fresh();
};

bool flatten(Editable& module, const Spot& spot, Chance& chance) {
    const auto run = straight_code(module, block_of(module, spot), chance);
    if (run) Dispatcher(module, spot, 2 + chance.below(3)).move(*run);
    return run.has_value();
}

}  // namespace

Opaque opaque_false(Editable& module, Chance& chance) {
    const bool known = chance.below(4) == 0;
    const Op* run = known ? nullptr : module.find_global([&](const Op& op) {
        if (op.opcode != SpvOpVariable || op.operands()[0] != SpvStorageClassPushConstant) return false;
        return module.name_of(module.global(op.type())->operands()[1]) == "GloamGeneratedRun";
    });
    if (run == nullptr) return {{}, module.global_of(SpvOpConstantFalse, module.bool_type(), {})};
    const Id uint = module.uint_type();
    const Id variable = run->result();  // before anything is added to the module
    const Id pointer = module.global_of(SpvOpTypePointer, 0, {SpvStorageClassPushConstant, uint});
    const Id zero = module.uint_constant(0);
    const Id place = module.fresh();
    const Id count = module.fresh();
    const Id no = module.fresh();
    return {{{SpvOpAccessChain, {pointer, place, variable, zero}},
             {SpvOpLoad, {uint, count, place}},
             {SpvOpIEqual, {module.bool_type(), no, count, zero}}},
            no};
}

const std::vector<Change>& changes_of_flow() {
    static const std::vector<Change> all{{"block divided", has_one, divide},
                                         {"branch never taken", has_one, never_taken},
                                         {"loop of one round", has_two, loop_once},
                                         {"condition negated", is_branch, negate_condition},
                                         {"branch as a switch", is_selection, branch_by_switch},
                                         {"select as branches", selects_by_one, select_by_branches},
                                         {"flattened", has_four, flatten}};
    return all;
}

}  // namespace gloam::shader::internal
