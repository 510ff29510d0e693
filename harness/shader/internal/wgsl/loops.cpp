// SPDX-License-Identifier: MIT
// Loops as structured statements.
#include "shader/internal/wgsl/function_writer.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {

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
            label = block(here, open, list);
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
}

}  // namespace gloam::shader::internal::wgsl
