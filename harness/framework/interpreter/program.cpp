// SPDX-License-Identifier: MIT
#include "interpreter/program.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <map>

#include "interpreter/internal/code.hpp"
#include "interpreter/internal/lowering.hpp"
#include "interpreter/machine.hpp"

namespace gloam::interpreter {

std::string to_text(const Location& place) {
    const std::string function = place.function.empty() ? "the module" : place.function;
    if (place.line == 0) return fmt::format("{} (word {})", function, place.word);
    return fmt::format("{} ({}:{})", function, place.file.empty() ? "?" : place.file, place.line);
}

namespace {

base::Reason reason_of(Error::Kind kind) {
    if (kind == Error::Kind::unknown_instruction) return base::Reason::unsupported;
    if (kind == Error::Kind::race) return base::Reason::race;
    return kind == Error::Kind::divergent_barrier ? base::Reason::divergent : base::Reason::error;
}

using internal::Code;
using internal::Instruction;

// The values of `next` in Coverage::add() that can follow an instruction; empty if there is only one.
std::vector<std::uint32_t> followers_of(const Code& code, const Instruction& i) {
    if (i.op == internal::select) return {1, 0};
    std::vector<std::uint32_t> targets;
    if (i.op == internal::branch) {
        targets = {code.edges[i.extra].target, code.edges[i.b].target};
    } else if (i.op == internal::switch_on) {
        const internal::Switch& all = code.switches[i.extra];
        for (const auto& [literal, edge] : all.cases) targets.push_back(code.edges[edge].target);
        targets.push_back(code.edges[all.otherwise].target);
    }
    // Ways with the same target count as one.
    const bool all_same = std::ranges::all_of(targets, [&](std::uint32_t t) { return t == targets.front(); });
    return all_same ? std::vector<std::uint32_t>{} : targets;
}

std::string name_of_way(const Code& code, const Instruction& i, std::size_t way) {
    if (i.op != internal::switch_on) return way == 0 ? "true" : "false";
    const internal::Switch& all = code.switches[i.extra];
    return way < all.cases.size() ? fmt::format("case {}", static_cast<std::int32_t>(all.cases[way].first))
                                  : "default";
}

}  // namespace

Error::Error(Kind kind, const std::string& message) : Failure(message, reason_of(kind)), kind_(kind) {}

Program::Program(const module::Spirv& module, std::span<const Constant> constants,
                 const std::string& entry_point) {
    const internal::Module read(module, constants);
    code_ = std::make_shared<const internal::Code>(internal::Lowering(read).run(entry_point));
}

std::string name_of_operation(std::uint16_t opcode) {
    return internal::name_of(opcode);
}

bool gives_truth(std::uint16_t opcode) {
    const internal::Known* known = internal::known_operation(opcode);
    return known != nullptr &&
           (known->form == internal::Form::truth || known->form == internal::Form::to_one_truth);
}

bool Program::may_be_rearranged() const {
    return code_->may_be_rearranged;
}

Coverage::Coverage(const Program& program) : program_(program) {
    const Code& code = program.code();
    ran_.resize(code.instructions.size());
    for (const Instruction& i : code.instructions) {
        ways_.push_back(followers_of(code, i));
        gone_.emplace_back(ways_.back().size());
    }
}

void Coverage::add(std::size_t instruction, std::uint32_t next) {
    ran_[instruction] = 1;
    const std::vector<std::uint32_t>& ways = ways_[instruction];
    for (std::size_t w = 0; w < ways.size(); ++w)
        if (ways[w] == next) gone_[instruction][w] = 1;
}

std::vector<Coverage::Point> Coverage::points() const {
    const Code& code = program_.code();
    std::map<std::pair<std::string, unsigned>, Point> lines;
    // Keyed by the word in the module, because a function can have several copies.
    std::map<std::uint32_t, std::vector<Point>> branches;
    for (std::size_t at = 0; at < ran_.size(); ++at) {
        const Instruction& i = code.instructions[at];
        const Location& place = code.places[i.place];
        if (!place.file.empty()) {
            Point& line = lines.try_emplace({place.file, place.line}, Point{.place = place}).first->second;
            line.reached = line.reached || ran_[at] != 0;
        }
        for (std::size_t w = 0; w < ways_[at].size(); ++w) {
            std::vector<Point>& ways = branches[code.origins[at]];
            if (ways.size() == w) ways.push_back({.place = place, .way = name_of_way(code, i, w)});
            ways[w].reached = ways[w].reached || gone_[at][w] != 0;
        }
    }
    std::vector<Point> all;
    for (auto& [at, line] : lines) all.push_back(std::move(line));
    std::map<std::pair<std::string, unsigned>, std::size_t> in_line;
    for (auto& [word, ways] : branches) {
        const std::size_t number = ++in_line[{ways.front().place.file, ways.front().place.line}];
        for (Point& way : ways) {
            way.branch = number;
            all.push_back(std::move(way));
        }
    }
    return all;
}

}  // namespace gloam::interpreter
