// SPDX-License-Identifier: MIT
#include "check/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/explain.hpp"
#include "check/internal/moves.hpp"
#include "check/internal/session.hpp"
#include "check/interpreted_kernel.hpp"
#include "interpreter/program.hpp"

namespace gloam::check {
namespace {

// A few inputs of all kinds: the beginning of a larger draw.
Domain::Inputs few_inputs(const Domain& domain, std::size_t count, std::uint64_t seed,
                          glm::ivec2 image_size) {
    constexpr std::size_t spread = 16;
    return domain.draw(spread * count, seed, image_size).where([](std::size_t i) { return i % spread == 0; });
}

// Each input is compiled code, so the scenarios of a question share the number of inputs.
std::size_t constants_of_each(std::size_t scenarios) {
    constexpr std::size_t least = 8;
    return std::max(least, internal::most_constants / std::max<std::size_t>(scenarios, 1));
}

// Inputs of many words are fewer: those of a run take 256 MiB at most.
std::size_t inputs_of_run(const Question& question, std::size_t wanted) {
    constexpr std::size_t most_words = std::size_t{1} << 26U;
    const std::size_t words = question.signature.input_words() + question.signature.output_words();
    return std::min(wanted, most_words / std::max<std::size_t>(words, 1));
}

}  // namespace

Verdict verdict_of(const shader::Variant& variant, const Question& question) {
    const bool by_rules = variant.strict || variant.relaxed || !variant.steps.empty() ||
                          question.only_rules || !question.reference;
    return by_rules ? Verdict::rules : Verdict::budget;
}

namespace {

// The answer to a question, by what visit(session, scenario, share, answer) adds for each scenario.
template <class Visit>
Answer answered(const Lab& lab, const Question& question, std::size_t inputs, std::uint64_t seed,
                Verdict verdict, const Visit& visit) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    Answer answer = empty_answer(question, verdict);
    answer.variant = lab.options().variant.name;
    internal::for_each_scenario(question, inputs, [&](const ImageScenario& scenario, std::size_t share) {
        visit(internal::Session(lab, question, kernel, scenario, seed, verdict), scenario, share, answer);
    });
    return answer;
}

Answer judged(const Lab& lab, const Question& question, const RunOptions& options) {
    std::optional<Domain> domain;
    const bool constants = lab.options().variant.constants != shader::Variant::Constants::none;
    const auto run = [&](const internal::Session& session, const ImageScenario& scenario, std::size_t share,
                         Answer& answer) {
        const std::uint64_t seed = session.input_seed();
        if (!domain) domain = internal::domain_of(lab, question);
        const Domain::Inputs drawn =
            constants ? few_inputs(*domain, constants_of_each(question.scenarios.size()), seed, scenario.size)
                      : domain->draw(share, seed, scenario.size);
        Domain::Inputs inputs = session.without_long_runs(drawn, answer);
        if (inputs.count() > 0) session.judge(session.run(std::move(inputs), answer), answer);
    };
    Answer answer = answered(lab, question, inputs_of_run(question, options.inputs), options.seed,
                             verdict_of(lab.options().variant, question), run);
    if (options.coverage) answer.coverage = measure_coverage(lab, question, options);
    internal::tell_story(lab, question, options.seed, answer);
    return answer;
}

// Throws the error that invocations disturb each other with the lines of the source, which the module of a
// kernel need not have.
void throw_with_lines(const Lab& lab, const Question& question, std::uint64_t seed) {
    constexpr std::size_t most_inputs = 4096;
    const KernelModule module = lined_module(lab, question);
    const interpreter::Program program(module.spirv);
    const ImageScenario scenario = question.scenarios.empty() ? ImageScenario{} : question.scenarios.front();
    const ImageSet images = internal::images_of(scenario, seed);
    const std::vector<std::vector<Word>> words = image_words(module.prototypes, images, question.function);
    InterpretedKernel<double> kernel(program, module, words);
    const Domain::Inputs inputs = question.domain.draw(most_inputs, seed, scenario.size);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        for (const auto order : {interpreter::Order::backward, interpreter::Order::forward}) {
            kernel.set_order(order);
            std::vector<Word> row(inputs.row(i).begin(), inputs.row(i).end());
            question.domain.adjust(row);
            try {
                kernel.run(row);
            } catch (const interpreter::Error& error) {
                if (!error.is_of_group()) continue;
                throw interpreter::Error(
                    error.kind(), fmt::format("{}: {}: {}", question.file, question.function, error.what()));
            }
        }
    }
}

}  // namespace

Answer run(const Lab& lab, const Question& question, const RunOptions& options) {
    try {
        return judged(lab, question, options);
    } catch (const interpreter::Error& error) {
        if (error.is_of_group() && !lab.compile_options().lines)
            throw_with_lines(lab, question, options.seed);
        throw;
    }
}

namespace {

constexpr std::size_t drawn_part = 4;     // one of this many inputs is drawn at random
constexpr std::size_t generation = 1024;  // inputs of one dispatch

// Runs a generation, and sets its scores.
void evaluate(const internal::Session& session, const Domain& domain, Answer& answer,
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

SearchResult search(const Lab& lab, const Question& question, const SearchOptions& options) {
    using internal::Moves;
    SearchResult found;
    const auto climb = [&](const internal::Session& session, const ImageScenario& scenario, std::size_t share,
                           Answer& answer) {
        if (question.domain.parameters().empty() || share == 0) return;
        const std::size_t drawn = std::max<std::size_t>(share / drawn_part, 1);
        Moves moves(question, drawn, scenario.size, session.input_seed(), options.seed);
        std::vector<Moves::Candidate> pool;
        const auto run = [&](std::vector<Moves::Candidate>& some) {
            evaluate(session, question.domain, answer, some);
        };
        std::vector<Moves::Candidate> first = moves.drawn_candidates();
        run(first);
        Moves::add(std::move(first), pool);
        if (!pool.empty()) found.drawn_fraction = std::max(found.drawn_fraction, pool.front().score);
        moves.climb(pool, share - drawn, generation, run, [] { return true; });
    };
    found.answer = answered(lab, question, options.inputs, options.seed,
                            options.verdict.value_or(verdict_of(lab.options().variant, question)), climb);
    internal::tell_story(lab, question, options.seed, found.answer);
    return found;
}

}  // namespace gloam::check
