// SPDX-License-Identifier: MIT
#include <spirv.h>
#include <algorithm>
#include <optional>
#include <set>

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

// Blocks that can be divided: a loop begins at its header, and must end there.
struct Place {
    FunctionBody* function = nullptr;
    std::size_t block = 0;

    [[nodiscard]] Block& get() const { return function->blocks[block]; }
};

std::optional<Place> some_block(Editable& module, Chance& chance, std::size_t least_ops) {
    std::vector<Place> all;
    for (FunctionBody& function : module.functions)
        for (std::size_t b = 0; b < function.blocks.size(); ++b) {
            const Block& block = function.blocks[b];
            if (!block.is_loop_header() && block.last_free() >= block.first_free() + least_ops)
                all.push_back({&function, b});
        }
    return all.empty() ? std::nullopt : std::optional(chance.of(all));
}

void append(Block& block, const std::vector<Op>& ops) {
    block.ops.insert(block.ops.end(), ops.begin(), ops.end());
}

void insert_after(const Place& place, const std::vector<Block>& blocks) {
    std::vector<Block>& all = place.function->blocks;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(place.block) + 1, blocks.begin(), blocks.end());
}

// A position between the instructions of a block.
std::size_t some_position(const Block& block, Chance& chance) {
    return block.first_free() + chance.below(block.last_free() - block.first_free() + 1);
}

bool divide(Editable& module, Chance& chance) {
    const auto place = some_block(module, chance, 1);
    if (!place) return false;
    const Id rest = split(module, *place->function, place->block, some_position(place->get(), chance));
    append(place->get(), {branch(rest)});
    return true;
}

// Instructions for a branch that is never taken: copies of those before it, and a store.
std::vector<Op> dead_code(Editable& module, const Place& place, Chance& chance) {
    std::vector<Op> code;
    const Block& block = place.get();
    for (std::size_t i = block.first_free(); i < block.ops.size() && code.size() < 4; ++i) {
        Op copy = block.ops[i];
        const bool is_value = copy.type() != 0 && is_of_numbers(module, copy.type());
        if (!is_value || copy.opcode == SpvOpFunctionCall || !copy.visit_ids([](std::uint32_t&) {})) continue;
        if (chance.below(2) == 0) continue;
        copy.set_result(module.fresh());
        code.push_back(std::move(copy));
    }
    for (const Op& op : block.ops) {
        if (op.opcode != SpvOpLoad || chance.below(2) == 0) continue;
        const Op* pointer = module.global(module.types_of(*place.function).at(op.operands()[0]));
        if (pointer->operands()[0] != SpvStorageClassFunction) continue;
        code.push_back({SpvOpStore, {op.operands()[0], module.global_of(SpvOpConstantNull, op.type(), {})}});
        break;
    }
    return code;
}

bool never_taken(Editable& module, Chance& chance) {
    const auto place = some_block(module, chance, 1);
    if (!place) return false;
    const Id rest = split(module, *place->function, place->block, some_position(place->get(), chance));
    std::vector<Op> code = dead_code(module, *place, chance);
    const Id dead = module.fresh();
    code.push_back(branch(rest));
    const Opaque no = opaque_false(module, chance);
    append(place->get(), no.ops);
    append(place->get(), {{SpvOpSelectionMerge, {rest, none}}, branch(no.id, dead, rest)});
    insert_after(*place, {labelled(dead, std::move(code))});
    return true;
}

bool loop_once(Editable& module, Chance& chance) {
    const auto place = some_block(module, chance, 2);
    if (!place) return false;
    const std::size_t begin = some_position(place->get(), chance);
    const Id body = split(module, *place->function, place->block, begin);
    const Place inside{place->function, place->block + 1};
    const Id rest = split(module, *place->function, inside.block, some_position(inside.get(), chance));
    const Id header = module.fresh();
    const Id again = module.fresh();
    append(place->get(), {branch(header)});
    append(inside.get(), {branch(again)});
    Opaque no = opaque_false(module, chance);
    no.ops.push_back(branch(no.id, header, rest));
    insert_after(inside, {labelled(again, no.ops)});
    insert_after(*place, {labelled(header, {{SpvOpLoopMerge, {rest, again, none}}, branch(body)})});
    return true;
}

// Branches of a selection, not those that leave or repeat a loop. Not in a function that has a switch: inside
// a switch no branch may leave an outer one.
std::vector<Spot> selections(const Editable& module) {
    std::vector<Spot> found;
    std::set<std::size_t> with_switch;
    for (const Spot& spot : spots(module, [](const Op& op) { return op.opcode == SpvOpSwitch; }))
        with_switch.insert(spot.function);
    for (const Spot& spot : spots(module, [](const Op& op) { return op.opcode == SpvOpBranchConditional; })) {
        const Block& block = module.functions[spot.function].blocks[spot.block];
        if (block.ops[spot.op - 1].opcode == SpvOpSelectionMerge && !with_switch.contains(spot.function))
            found.push_back(spot);
    }
    return found;
}

bool negate_condition(Editable& module, Chance& chance) {
    const std::vector<Spot> all =
        spots(module, [](const Op& op) { return op.opcode == SpvOpBranchConditional; });
    if (all.empty()) return false;
    const Spot spot = chance.of(all);
    Block& block = module.functions[spot.function].blocks[spot.block];
    Op& end = block.ops.back();
    const Op inverse{SpvOpLogicalNot, {module.bool_type(), module.fresh(), end.words[0]}};
    end = branch(inverse.result(), end.words[2], end.words[1]);
    block.ops.insert(block.ops.begin() + static_cast<std::ptrdiff_t>(block.last_free()), inverse);
    return true;
}

bool branch_by_switch(Editable& module, Chance& chance) {
    const std::vector<Spot> all = selections(module);
    if (all.empty()) return false;
    const Spot spot = chance.of(all);
    Block& block = module.functions[spot.function].blocks[spot.block];
    const Op end = block.ops.back();
    if (end.words[1] == end.words[2]) return false;
    const Op number{
        SpvOpSelect,
        {module.uint_type(), module.fresh(), end.words[0], module.uint_constant(1), module.uint_constant(0)}};
    block.ops.back() = {SpvOpSwitch, {number.result(), end.words[2], 1, end.words[1]}};
    block.ops.insert(block.ops.begin() + static_cast<std::ptrdiff_t>(block.last_free()), number);
    return true;
}

bool select_by_branches(Editable& module, Chance& chance) {
    std::vector<Spot> found;
    for (const Spot& spot : spots(module, [](const Op& op) { return op.opcode == SpvOpSelect; })) {
        const FunctionBody& function = module.functions[spot.function];
        const Block& block = function.blocks[spot.block];
        const Id condition = module.types_of(function).at(block.ops[spot.op].operands()[0]);
        if (module.global(condition)->opcode == SpvOpTypeBool && !block.is_loop_header())
            found.push_back(spot);
    }
    if (found.empty()) return false;
    const Spot spot = chance.of(found);
    const Place place{&module.functions[spot.function], spot.block};
    const Op select = place.get().ops[spot.op];
    place.get().ops.erase(place.get().ops.begin() + static_cast<std::ptrdiff_t>(spot.op));
    const Id rest = split(module, *place.function, place.block, spot.op);
    const Id yes = module.fresh();
    const Id no = module.fresh();
    const auto from = select.operands();
    Block& after = place.function->blocks[place.block + 1];
    after.ops.insert(after.ops.begin() + 1,
                     Op{SpvOpPhi, {select.type(), select.result(), from[1], yes, from[2], no}});
    append(place.get(), {{SpvOpSelectionMerge, {rest, none}}, branch(from[0], yes, no)});
    insert_after(place, {labelled(yes, {branch(rest)}), labelled(no, {branch(rest)})});
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
    const auto can_move = [&](Op op) {
        const bool is_store = op.opcode == SpvOpStore;
        return (is_store || (op.type() != 0 && is_of_numbers(module, op.type()))) &&
               op.visit_ids([](std::uint32_t&) {});
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
    Dispatcher(Editable& module, const Place& place, std::size_t cases)
        : module_(module), place_(place), cases_(cases) {}

    void move(const Straight& run) {
        Block& block = place_.get();
        const auto begin = block.ops.begin() + static_cast<std::ptrdiff_t>(run.begin);
        const auto end = block.ops.begin() + static_cast<std::ptrdiff_t>(run.end);
        code_.assign(begin, end);
        block.ops.erase(begin, end);
        rest_ = split(module_, *place_.function, place_.block, run.begin);
        state_ = variable(module_.uint_type());
        std::vector<Block> made = cases();
        append(place_.get(), {{SpvOpStore, {state_, module_.uint_constant(0)}}, branch(header_)});
        insert_after(place_, made);
        Block& rest = place_.function->blocks[place_.block + made.size() + 1];
        rest.ops.insert(rest.ops.begin() + 1, given_.begin(), given_.end());
        Block& entry = place_.function->blocks.front();
        entry.ops.insert(entry.ops.begin() + 1, variables_.begin(), variables_.end());
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
    Place place_;
    std::size_t cases_;
    std::vector<Op> code_;
    std::map<Id, Kept> kept_;
    std::vector<Op> given_;
    std::vector<Op> variables_;
    Id rest_ = 0;
    Id state_ = 0;
    Id header_ = module_.fresh();
};

bool flatten(Editable& module, Chance& chance) {
    const auto place = some_block(module, chance, 4);
    if (!place) return false;
    const auto run = straight_code(module, place->get(), chance);
    if (!run) return false;
    Dispatcher(module, *place, 2 + chance.below(3)).move(*run);
    return true;
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
    static const std::vector<Change> all{{"block divided", divide},
                                         {"branch never taken", never_taken},
                                         {"loop of one round", loop_once},
                                         {"condition negated", negate_condition},
                                         {"branch as a switch", branch_by_switch},
                                         {"select as branches", select_by_branches},
                                         {"flattened", flatten}};
    return all;
}

}  // namespace gloam::shader::internal
