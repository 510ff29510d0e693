// SPDX-License-Identifier: MIT
#include "shader/internal/wgsl/function_writer.hpp"

#include <algorithm>

#include "shader/wgsl.hpp"

// Blocks and branches as structured statements.
namespace gloam::shader::internal::wgsl {

bool FunctionWriter::is_jump(Id to, const Open& open) const {
    return to == open.stop || to == open.leave || to == open.next;
}

// What a branch means that leaves the region, or nothing where it goes on. Sets the phis of its target.
void FunctionWriter::branch(Id from, Id to, const Open& open, Statements& out) {
    set_phis(from, to, out);
    if (to == open.stop) return;
    if (to == open.leave) out.push_back({.kind = StatementKind::leave});
    if (to == open.next) out.push_back({.kind = StatementKind::next});
}

void FunctionWriter::set_phis(Id from, Id to, Statements& out) {
    std::vector<std::pair<Id, Expression>> values;
    for (const Instruction& i : function_.block(to).body) {
        if (i.opcode != SpvOpPhi) break;
        if (shape_.fold_results.contains(i.word(2)) || shape_.only_values.contains(i.word(2))) continue;
        for (std::size_t w = 3; w + 1 < i.words.size(); w += 2)
            if (i.word(w + 1) == from) values.emplace_back(i.word(2), take(i.word(w)));
    }
    // The values are those from before the first assignment.
    for (std::size_t k = 1; k < values.size(); ++k) {
        const bool changed =
            std::any_of(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k),
                        [&](const auto& earlier) { return values[k].second.reads.contains(earlier.first); });
        if (!changed) continue;
        const Id copy = copy_of(values[k].first);
        body_.wanted_names[copy] = "t";
        body_.types[copy] = text_.type(module_.type_of(values[k].first));
        out.insert(out.end(),
                   {.kind = StatementKind::assign, .target = copy, .value = values[k].second.text});
        values[k].second = {.text = mark(copy), .reads = {copy}};
    }
    for (const auto& [phi, value] : values) assign(phi, value, out);
}

// Writes all blocks from `start` to the end of the region.
void FunctionWriter::region(Id start, const Open& open, Statements& out) {
    for (Id label = start; label != 0 && !is_jump(label, open);)
        label = block_or_loop(function_.block(label), open, out);
}

// Returns where it goes on; 0 where nothing follows.
Id FunctionWriter::block_or_loop(const Block& here, const Open& open, Statements& out) {
    if (!here.merge || here.merge->opcode != SpvOpLoopMerge) return block(here, open, out);
    loop(here, open, out);
    return here.merge->word(1);
}

namespace {

// Whether it is a barrier of memory with barrier() beside it, or others of memory in between.
bool is_part_of_barrier(const std::vector<Instruction>& body, std::size_t at) {
    const auto is_memory = [&body](std::size_t k) { return body[k].opcode == SpvOpMemoryBarrier; };
    if (!is_memory(at)) return false;
    std::size_t first = at;
    while (first > 0 && is_memory(first - 1)) --first;
    std::size_t end = at;
    while (end < body.size() && is_memory(end)) ++end;
    return (first > 0 && body[first - 1].opcode == SpvOpControlBarrier) ||
           (end < body.size() && body[end].opcode == SpvOpControlBarrier);
}

}  // namespace

void FunctionWriter::body_of(const Block& block, Statements& out) {
    for (std::size_t k = 0; k < block.body.size(); ++k) {
        if (is_part_of_barrier(block.body, k)) {
            memory_barriers(module_.integer(block.body[k].word(2)).value_or(0), out);
        } else {
            instruction(block.body[k], out);
        }
    }
}

// A block and its end; the label of the next one, or 0 behind a jump.
Id FunctionWriter::block(const Block& here, const Open& open, Statements& out) {
    body_of(here, out);
    if (const auto fold = shape_.folds.find(here.label); fold != shape_.folds.end()) {
        folded(here, fold->second, out);
        return fold->second.merge;
    }
    switch (here.end.opcode) {
        case SpvOpBranch: {
            const Id to = here.end.word(1);
            branch(here.label, to, open, out);
            return is_jump(to, open) ? 0 : to;
        }
        case SpvOpBranchConditional:
            return here.merge ? selection(here, open, out) : two_ways(here, open, out);
        case SpvOpSwitch:
            return choice(here, open, out);
        case SpvOpReturn:
            out.push_back({.kind = StatementKind::give});
            return 0;
        case SpvOpReturnValue: {
            give(take(here.end.word(1)), out);
            return 0;
        }
        case SpvOpKill:
        case SpvOpTerminateInvocation:
            out.push_back({.kind = StatementKind::expression, .value = "discard"});
            return 0;
        default:  // OpUnreachable
            return 0;
    }
}

// Branches that only calculate a value.
void FunctionWriter::folded(const Block&, const Fold& fold, Statements& out) {
    std::set<Id> inner;
    for (const Id label : fold.blocks) {
        if (inner.contains(label)) continue;
        const Block& here = function_.block(label);
        body_of(here, out);
        const auto further = shape_.folds.find(label);
        if (further == shape_.folds.end()) continue;
        folded(here, further->second, out);
        inner.insert(further->second.blocks.begin(), further->second.blocks.end());
    }
    const Expression condition = take(fold.condition);
    const Expression yes = take(fold.yes);
    Expression value;
    if (fold.kind == Fold::Kind::conjunction) {
        value = binary("&&", condition, yes);
    } else if (fold.kind == Fold::Kind::disjunction) {
        value = binary("||", condition, yes);
    } else {
        const Expression no = take(fold.no);
        value = call("select", {no, yes, condition});
        for (const Expression* part : {&no, &yes, &condition})
            value.reads.insert(part->reads.begin(), part->reads.end());
    }
    values_[fold.result] = value;
    if (shape_.uses[fold.result] != 1 ||
        shape_.home[fold.result] !=
            entry_of(shape_.straight, fold.merge, "a value of a block that is not reached")) {
        keep(fold.result, value, out);
    } else {
        pending_.push_back(fold.result);
    }
}

Id FunctionWriter::selection(const Block& here, const Open& open, Statements& out) {
    const Id merge = here.merge->word(1);
    const Expression condition = take(here.end.word(1));
    keep_all(out);
    Statement statement{.kind = StatementKind::condition, .value = condition.text, .lists = {{}, {}}};
    for (std::size_t k = 0; k < 2; ++k) {
        const Id to = here.end.word(2 + k);
        const Open inner{.stop = merge, .leave = open.leave, .next = open.next};
        branch(here.label, to, inner, statement.lists[k]);
        region(to, inner, statement.lists[k]);
        keep_all(statement.lists[k]);
    }
    out.push_back(std::move(statement));
    return merge;
}

// A conditional branch without a merge: at least one side leaves the region.
Id FunctionWriter::two_ways(const Block& here, const Open& open, Statements& out) {
    const Id yes = here.end.word(2);
    const Id no = here.end.word(3);
    Expression condition = take(here.end.word(1));
    keep_all(out);
    const bool yes_leaves = is_jump(yes, open);
    const bool no_leaves = is_jump(no, open);
    if (!yes_leaves && !no_leaves) throw NotTranslated("a branch that is not structured");
    if (yes_leaves && no_leaves) {
        Statement statement{.kind = StatementKind::condition, .value = condition.text, .lists = {{}, {}}};
        branch(here.label, yes, open, statement.lists[0]);
        branch(here.label, no, open, statement.lists[1]);
        out.push_back(std::move(statement));
        return 0;
    }
    if (no_leaves) condition = unary("!", condition);
    Statement statement{.kind = StatementKind::condition, .value = condition.text, .lists = {{}, {}}};
    branch(here.label, yes_leaves ? yes : no, open, statement.lists[0]);
    const bool ends = (yes_leaves ? yes : no) == open.stop;
    const Id on = yes_leaves ? no : yes;
    if (ends) {  // the rest of the region runs only on the other side
        region(on, open, statement.lists[1]);
        out.push_back(std::move(statement));
        return 0;
    }
    out.push_back(std::move(statement));
    set_phis(here.label, on, out);
    return on;
}

Id FunctionWriter::choice(const Block& here, const Open& open, Statements& out) {
    const Id merge = here.merge->word(1);
    const Id selector = here.end.word(1);
    const bool is_signed = module_.is_signed(module_.type_of(selector));
    Statement statement{.kind = StatementKind::choice, .value = typed(take(selector)).text};
    keep_all(out);
    std::vector<std::pair<Id, std::string>> cases;
    const auto add = [&](Id target, const std::string& label) {
        const auto known = std::ranges::find(cases, target, &std::pair<Id, std::string>::first);
        if (known == cases.end()) {
            cases.emplace_back(target, label);
        } else {
            known->second += ", " + label;
        }
    };
    for (std::size_t w = 3; w + 1 < here.end.words.size(); w += 2) {
        const std::uint32_t value = here.end.word(w);
        add(here.end.word(w + 1),
            is_signed ? std::to_string(static_cast<std::int32_t>(value)) : std::to_string(value) + "u");
    }
    add(here.end.word(2), "default");
    for (const auto& [target, label] : cases) {
        const Open inner{.stop = merge, .leave = merge, .next = open.next};
        Statements list;
        branch(here.label, target, inner, list);
        region(target, inner, list);
        keep_all(list);
        statement.labels.push_back(label);
        statement.lists.push_back(std::move(list));
    }
    out.push_back(std::move(statement));
    return merge;
}

// Loops as structured statements.

// The block inside the loop and whether the condition leads there, if the block ends with leaving the loop.
std::optional<std::pair<Id, bool>> FunctionWriter::loop_condition(const Block& block, Id leave) const {
    if (block.end.opcode != SpvOpBranchConditional) return std::nullopt;
    if (block.merge && block.merge->opcode == SpvOpSelectionMerge) return std::nullopt;
    if (block.end.word(3) == leave && block.end.word(2) != leave) return std::pair(block.end.word(2), true);
    if (block.end.word(2) == leave && block.end.word(3) != leave) return std::pair(block.end.word(3), false);
    return std::nullopt;
}

namespace {

// Without `continue` at the end of the loop.
void drop_last_jump(Statements& list) {
    if (list.empty()) return;
    if (list.back().kind == StatementKind::next) {
        list.pop_back();
    } else if (list.back().kind == StatementKind::condition) {
        for (Statements& inner : list.back().lists) drop_last_jump(inner);
    }
}

}  // namespace

// The block that always follows this one at the front of the loop, behind its instructions; nullptr where
// there is none that can be written without a statement of its own.
const Block* FunctionWriter::straight_on(const Block& at, const Block& header, const Open& open,
                                         Statements& out) {
    const auto fold = shape_.folds.find(at.label);
    Id to = 0;
    if (fold != shape_.folds.end()) {
        folded(at, fold->second, out);
        to = fold->second.merge;
    } else if (at.end.opcode == SpvOpBranch && (!at.merge || &at == &header)) {
        to = at.end.word(1);
        const Block& block = function_.block(to);
        if (is_jump(to, open) || (block.merge && !shape_.folds.contains(to))) return nullptr;
        set_phis(at.label, to, out);
    } else {
        return nullptr;
    }
    const Block& block = function_.block(to);
    body_of(block, out);
    return &block;
}

// The phis of the header are variables: they are set in front of the loop and where it starts again.
void FunctionWriter::loop(const Block& header, const Open&, Statements& out) {
    const Id leave = header.merge->word(1);
    const Id next = header.merge->word(2);
    const Open inner{.stop = 0, .leave = leave, .next = next};
    Statement statement{.kind = StatementKind::loop, .lists = {{}, {}}};
    Statements& body = statement.lists[0];
    const Block* at = &header;
    body_of(*at, body);
    while (const Block* following = straight_on(*at, header, inner, body)) at = following;
    if (const auto condition = loop_condition(*at, leave)) {
        const Expression value = take(at->end.word(1));
        const bool alone = body.empty() && pending_.empty();
        const Expression stays = condition->second ? value : unary("!", value);
        keep_all(body);
        Statements leaving;
        set_phis(at->label, leave, leaving);
        if (alone && leaving.empty()) {
            statement.value = stays.text;
        } else {
            const Expression leaves = condition->second ? unary("!", value) : value;
            leaving.push_back({.kind = StatementKind::leave});
            body.push_back(
                {.kind = StatementKind::condition, .value = leaves.text, .lists = {std::move(leaving), {}}});
        }
        branch(at->label, condition->first, inner, body);
        region(condition->first, inner, body);
    } else if (at->end.opcode == SpvOpBranch) {
        const Id to = at->end.word(1);
        keep_all(body);
        branch(at->label, to, inner, body);
        region(to, inner, body);
    } else {
        Open rest = inner;
        const Block copy{.label = at->label,
                         .body = {},
                         .merge = at == &header ? std::nullopt : at->merge,
                         .end = at->end};
        const Id on = block(copy, rest, body);
        if (on != 0) region(on, rest, body);
    }
    keep_all(body);
    drop_last_jump(body);
    continuing(header, next, leave, statement);
    out.push_back(std::move(statement));
}

// The part that runs before the loop starts again; it may decide that it does not.
void FunctionWriter::continuing(const Block& header, Id next, Id leave, Statement& loop) {
    if (next == header.label) return;
    Statements& list = loop.lists[1];
    const Open open{.stop = header.label, .leave = leave, .next = 0};
    for (Id label = next; label != 0 && label != header.label;) {
        const Block& here = function_.block(label);
        const bool decides = here.end.opcode == SpvOpBranchConditional && !here.merge &&
                             (here.end.word(2) == header.label || here.end.word(3) == header.label);
        if (!decides) {
            label = block_or_loop(here, open, list);
            continue;
        }
        body_of(here, list);
        const Expression value = take(here.end.word(1));
        keep_all(list);
        set_phis(label, header.label, list);
        const bool stays_when_true = here.end.word(2) == header.label;
        loop.text = (stays_when_true ? unary("!", value) : value).text;
        return;
    }
    if (!list.empty() && list.back().kind == StatementKind::leave) {  // WGSL wants a condition
        list.pop_back();
        loop.text = "true";
    }
}

}  // namespace gloam::shader::internal::wgsl
