// SPDX-License-Identifier: MIT
#include "audit/worst.hpp"

#include <algorithm>

#include "audit/internal/moves.hpp"
#include "judge/session.hpp"

namespace gloam::audit {
namespace {

using namespace judge;
using namespace subject;

constexpr std::size_t drawn_part = 4;     // one of this many inputs is drawn at random
constexpr std::size_t generation = 1024;  // inputs of one dispatch

// Runs a generation, and sets its scores.
void evaluate(const Session& session, const Domain& domain, Answer& answer,
              std::vector<internal::Moves::Candidate>& candidates) {
    Domain::Inputs inputs;
    for (const auto& candidate : candidates) {
        inputs.add(candidate.words);
        domain.adjust(std::span(inputs.words).last(inputs.width));
    }
    std::vector<double> fractions(candidates.size());
    session.judge(session.run(std::move(inputs), answer), answer, fractions);
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].score = fractions[i];
}

}  // namespace

SearchResult search(const Lab& lab, const Question& question, const RunOptions& options) {
    using internal::Moves;
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    SearchResult found{.answer = empty_answer(question, question.criterion_in(lab.options().variant))};
    for (const auto& [scenario, share] : question.shares(options.inputs)) {
        if (question.domain.parameters().empty() || share == 0) continue;
        const Session session(lab, question, kernel, scenario, options.seed);
        const std::size_t drawn = std::max<std::size_t>(share / drawn_part, 1);
        Moves moves(question, drawn, scenario.size, session.input_seed(), options.seed);
        const auto run = [&](std::vector<Moves::Candidate>& some) {
            evaluate(session, question.domain, found.answer, some);
        };
        std::vector<Moves::Candidate> pool;
        std::vector<Moves::Candidate> first(moves.drawn().count());
        for (std::size_t i = 0; i < first.size(); ++i)
            first[i].words.assign(moves.drawn().row(i).begin(), moves.drawn().row(i).end());
        run(first);
        Moves::add(std::move(first), pool);
        if (!pool.empty()) found.drawn_fraction = std::max(found.drawn_fraction, pool.front().score);
        moves.climb(pool, share - drawn, generation, run, [] { return true; });
    }
    complete(found.answer, lab, question, kernel.module(), options.seed);
    return found;
}

}  // namespace gloam::audit
