// SPDX-License-Identifier: MIT
#include "check/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "check/explain.hpp"
#include "check/internal/moves.hpp"
#include "check/internal/trial.hpp"
#include "check/interpreted_kernel.hpp"
#include "interpreter/program.hpp"

namespace gloam::check {
namespace {

// A few inputs of all kinds: the beginning of a larger draw.
Domain::Inputs few_inputs(const Domain& domain, std::size_t count, std::uint64_t seed,
                          glm::ivec2 image_size) {
    constexpr std::size_t spread = 16;
    const Domain::Inputs many = domain.draw(spread * count, seed, image_size);
    Domain::Inputs few{.width = many.width};
    for (std::size_t i = 0; i < many.count(); i += spread) {
        const auto row = many.row(i);
        few.words.insert(few.words.end(), row.begin(), row.end());
        few.branch.push_back(many.branch[i]);
    }
    return few;
}

// Each input is compiled code, so the scenarios of a question share the number of inputs.
std::size_t constants_of_each(std::size_t scenarios) {
    constexpr std::size_t least = 8;
    return std::max(least, ConstantKernel::most_inputs / std::max<std::size_t>(scenarios, 1));
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

Answer judged(const Lab& lab, const Question& question, const RunOptions& options) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    const Verdict verdict = verdict_of(lab.options().variant, question);
    Answer answer = empty_answer(question, verdict);
    answer.variant = lab.options().variant.name;
    const Domain domain = internal::domain_of(lab, question);
    const bool constants = lab.options().variant.constants != shader::Variant::Constants::none;
    internal::for_each_scenario(
        question, inputs_of_run(question, options.inputs),
        [&](const ImageScenario& scenario, std::size_t share) {
            const internal::Trial trial(lab, question, kernel, scenario, options.seed, verdict);
            const std::uint64_t inputs_seed = trial.input_seed();
            const Domain::Inputs drawn =
                constants ? few_inputs(domain, constants_of_each(question.scenarios.size()), inputs_seed,
                                       scenario.size)
                          : domain.draw(share, inputs_seed, scenario.size);
            Domain::Inputs inputs = trial.without_long_runs(drawn, answer);
            if (inputs.count() == 0) return;
            if (constants) {
                const ConstantKernel folded(lab, question.file, question.function, question.signature);
                trial.compare_constants(std::move(inputs), folded, answer);
            } else {
                trial.judge(trial.run(std::move(inputs), answer), answer);
            }
        });
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
    const std::vector<std::vector<Word>> words = image_words(module.images, images, question.function);
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

struct Candidate {
    std::vector<Word> words;  // as drawn, before adjustment
    double score = 0.0;
};

class Climb {
  public:
    Climb(const Question& question, const internal::Trial& trial, SearchResult& found)
        : domain_(question.domain), trial_(trial), found_(found) {}

    void run(internal::Moves moves, std::size_t inputs) {
        std::vector<Candidate> candidates;
        const Domain::Inputs& drawn = moves.drawn();
        for (std::size_t i = 0; i < drawn.count(); ++i)
            candidates.push_back({{drawn.row(i).begin(), drawn.row(i).end()}});
        evaluate(std::move(candidates));
        found_.drawn_fraction = std::max(found_.drawn_fraction, pool_.empty() ? 0.0 : pool_.front().score);
        for (std::size_t done = drawn.count(); done < inputs; done += generation) {
            std::vector<Candidate> next(std::min(generation, inputs - done));
            for (Candidate& candidate : next) candidate.words = moves.from_pool(pool_);
            evaluate(std::move(next));
        }
    }

  private:
    void evaluate(std::vector<Candidate> candidates) {
        Domain::Inputs inputs;
        inputs.branch.assign(candidates.size(), false);
        for (const Candidate& candidate : candidates) {
            inputs.width = candidate.words.size();
            inputs.words.insert(inputs.words.end(), candidate.words.begin(), candidate.words.end());
            domain_.adjust(std::span(inputs.words).last(inputs.width));
        }
        std::vector<double> fractions(candidates.size());
        trial_.judge(trial_.run(std::move(inputs), found_.answer), found_.answer, fractions);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            candidates[i].score = fractions[i];
            if (fractions[i] > 0.0) pool_.push_back(std::move(candidates[i]));
        }
        internal::Moves::keep_the_worst(pool_);
    }

    const Domain& domain_;
    const internal::Trial& trial_;
    SearchResult& found_;
    std::vector<Candidate> pool_;
};

}  // namespace

SearchResult search(const Lab& lab, const Question& question, const SearchOptions& options) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    const Verdict verdict = options.verdict.value_or(verdict_of(lab.options().variant, question));
    SearchResult found{.answer = empty_answer(question, verdict)};
    found.answer.variant = lab.options().variant.name;
    internal::for_each_scenario(
        question, options.inputs, [&](const ImageScenario& scenario, std::size_t share) {
            const internal::Trial trial(lab, question, kernel, scenario, options.seed, verdict);
            if (question.domain.parameters().empty() || share == 0) return;
            const std::size_t drawn = std::max<std::size_t>(share / drawn_part, 1);
            Climb(question, trial, found)
                .run({question, drawn, scenario.size, trial.input_seed(), options.seed}, share);
        });
    internal::tell_story(lab, question, options.seed, found.answer);
    return found;
}

}  // namespace gloam::check
