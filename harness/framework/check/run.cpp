// SPDX-License-Identifier: MIT
#include "check/run.hpp"

#include <algorithm>
#include <cmath>

#include "check/internal/trial.hpp"
#include "numeric/numbers.hpp"

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

// The inputs with another one in place of those at `long_runs`, if any other is left.
Domain::Inputs short_runs(Domain::Inputs inputs, const std::vector<std::size_t>& long_runs) {
    std::size_t other = 0;
    while (other < long_runs.size() && long_runs[other] == other) ++other;  // they are in order
    if (other >= inputs.count()) return inputs;
    for (const std::size_t i : long_runs)
        std::ranges::copy(inputs.row(other),
                          inputs.words.begin() + static_cast<std::ptrdiff_t>(i * inputs.width));
    return inputs;
}

constexpr std::size_t most_alone = 64;  // inputs that are run by themselves

Domain::Inputs only(const Domain::Inputs& inputs, std::size_t i) {
    const auto row = inputs.row(i);
    return {.words = {row.begin(), row.end()}, .branch = {inputs.branch[i]}, .width = inputs.width};
}

// llvmpipe of Mesa 22.3 ends all loops of a group of invocations after 65,536 iterations of one of them, so
// inputs that failed beside such a one are run again without it.
void judge(const internal::Trial& trial, const Question& question, const Domain::Inputs& inputs,
           Answer& answer) {
    internal::Trial::Evaluated evaluated = trial.run(inputs, answer);
    Answer judged = empty_answer({}, answer.verdict);
    trial.judge(evaluated, judged);
    if (!judged.long_runs.empty() && judged.outside() > 0) {
        KernelCore::Result alone = trial.run(short_runs(evaluated.inputs, judged.long_runs), answer).result;
        const std::size_t width = question.signature.output_words();
        for (std::size_t k = 0; k < judged.long_runs.size(); ++k) {
            const std::size_t i = judged.long_runs[k];
            // A long run may itself be cut short by a longer one beside it.
            const KernelCore::Result one =
                k < most_alone ? trial.run(only(evaluated.inputs, i), answer).result : KernelCore::Result{};
            const auto from = k < most_alone
                                  ? one.outputs.begin()
                                  : evaluated.result.outputs.begin() + static_cast<std::ptrdiff_t>(i * width);
            std::copy_n(from, width, alone.outputs.begin() + static_cast<std::ptrdiff_t>(i * width));
        }
        evaluated.result = std::move(alone);
        judged = empty_answer({}, answer.verdict);
        trial.judge(evaluated, judged);
    }
    answer.merge(judged);
}

// Inputs of many words are fewer: those of a run take 256 MiB at most.
std::size_t inputs_of_run(const Question& question, std::size_t wanted) {
    constexpr std::size_t most_words = std::size_t{1} << 26U;
    const std::size_t words = question.signature.input_words() + question.signature.output_words();
    return std::min(wanted, most_words / std::max<std::size_t>(words, 1));
}

}  // namespace

Verdict verdict_of(const shader::Variant& variant, const Question& question) {
    const bool by_rules = variant.strict || variant.relaxed || question.only_rules || !question.reference;
    return by_rules ? Verdict::rules : Verdict::budget;
}

Answer run(const Lab& lab, const Question& question, const RunOptions& options) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    const Verdict verdict = verdict_of(lab.options().variant, question);
    Answer answer = empty_answer(question, verdict);
    answer.variant = lab.options().variant.name;
    const bool constants = lab.options().variant.constants != shader::Variant::Constants::none;
    internal::for_each_scenario(
        question, inputs_of_run(question, options.inputs),
        [&](const ImageScenario& scenario, std::size_t share) {
            const internal::Trial trial(lab, question, kernel, scenario, options.seed, verdict);
            if (constants) {
                const ConstantKernel folded(lab, question.file, question.function, question.signature);
                const std::size_t count = constants_of_each(question.scenarios.size());
                trial.compare_constants(few_inputs(question.domain, count, trial.input_seed(), scenario.size),
                                        folded, answer);
            } else {
                judge(trial, question, question.domain.draw(share, trial.input_seed(), scenario.size),
                      answer);
            }
        });
    if (options.coverage) answer.coverage = measure_coverage(lab, question, options);
    internal::tell_story(lab, question, options.seed, answer);
    return answer;
}

namespace {

using shader::Scalar;

constexpr std::size_t drawn_part = 4;     // one of this many inputs is drawn at random
constexpr std::size_t pool_size = 48;     // the inputs from which the climb starts
constexpr std::size_t generation = 1024;  // inputs of one dispatch
constexpr int most_moves = 3;             // of one input at once
constexpr int tries = 4;                  // attempts to find a move that stays inside the domain

// The words of one parameter in an input.
struct Slot {
    const Values* values;
    std::size_t first;
    std::size_t count;
};

struct Candidate {
    std::vector<Word> words;  // as drawn, before adjustment
    double score = 0.0;
};

class Climb {
  public:
    Climb(const Question& question, const internal::Trial& trial, glm::ivec2 image_size, std::uint64_t seed,
          SearchResult& found)
        : domain_(question.domain),
          trial_(trial),
          image_size_(image_size),
          random_(seed),
          scalars_(question.signature.input_scalars()),
          found_(found) {
        std::size_t first = 0;
        for (std::size_t p = 0, at = 0; p < question.signature.parameters.size(); ++p) {
            const shader::Parameter& parameter = question.signature.parameters[p];
            if (parameter.direction == shader::Direction::out) continue;
            const std::size_t count = scalars_of(parameter.type).size();
            const Values& values = domain_.parameters().at(at++);
            if (count > 0) slots_.push_back({&values, first, count});
            first += count;
        }
    }

    void run(std::size_t inputs) {
        if (slots_.empty() || inputs == 0) return;
        const std::size_t drawn = std::max<std::size_t>(inputs / drawn_part, 1);
        drawn_ = domain_.draw_unadjusted(drawn, trial_.input_seed(), image_size_);
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < drawn; ++i)
            candidates.push_back({{drawn_.row(i).begin(), drawn_.row(i).end()}});
        evaluate(std::move(candidates));
        found_.drawn_fraction = std::max(found_.drawn_fraction, pool_.empty() ? 0.0 : pool_.front().score);
        for (std::size_t done = drawn; done < inputs; done += generation) {
            std::vector<Candidate> next(std::min(generation, inputs - done));
            for (Candidate& candidate : next) candidate.words = moved();
            evaluate(std::move(next));
        }
    }

  private:
    // The worst candidates come first in the pool and are chosen more often.
    std::vector<Word> moved() {
        if (pool_.empty()) return pick_drawn();
        const double rank = random_.unit() * random_.unit();
        std::vector<Word> words =
            pool_[static_cast<std::size_t>(rank * static_cast<double>(pool_.size()))].words;
        const auto moves = 1 + static_cast<int>(random_.below(most_moves));
        for (int i = 0; i < moves; ++i) move(words);
        return words;
    }

    std::vector<Word> pick_drawn() {
        const auto row = drawn_.row(random_.below(drawn_.count()));
        return {row.begin(), row.end()};
    }

    void move(std::vector<Word>& words) {
        const Slot& slot = slots_[random_.below(slots_.size())];
        const auto at = static_cast<std::ptrdiff_t>(slot.first);
        const auto count = static_cast<std::ptrdiff_t>(slot.count);
        for (int i = 0; i < tries; ++i) {
            std::vector<Word> value(words.begin() + at, words.begin() + at + count);
            if (random_.below(4) == 0) {
                const auto other = drawn_.row(random_.below(drawn_.count())).subspan(slot.first, slot.count);
                value.assign(other.begin(), other.end());
            } else {
                const std::size_t word = random_.below(slot.count);
                value[word] = moved_word(value[word], scalars_[slot.first + word]);
                if (!slot.values->admits(value)) continue;
            }
            std::ranges::copy(value, words.begin() + at);
            return;
        }
    }

    // Moves a float by a power of two of steps, from a neighbour to several binades away, or changes its
    // sign.
    Word moved_word(Word word, Scalar scalar) {
        const bool down = random_.below(2) == 0;
        const int distance = 1 << random_.below(26);
        switch (scalar) {
            case Scalar::float_:
                if (random_.below(32) == 0) return word ^ 0x80000000U;
                return to_word(numeric::step(from_word<float>(word), down ? -distance : distance));
            case Scalar::bool_:
                return 1U - word;
            default:
                return down ? word - static_cast<Word>(distance) : word + static_cast<Word>(distance);
        }
    }

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
        keep_the_worst();
    }

    void keep_the_worst() {
        std::ranges::stable_sort(pool_,
                                 [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
        const auto same = [](const Candidate& a, const Candidate& b) {
            return a.score == b.score && a.words == b.words;
        };
        pool_.erase(std::unique(pool_.begin(), pool_.end(), same), pool_.end());
        if (pool_.size() > pool_size) pool_.resize(pool_size);
    }

    const Domain& domain_;
    const internal::Trial& trial_;
    glm::ivec2 image_size_;
    numeric::Random random_;
    std::vector<Scalar> scalars_;
    SearchResult& found_;
    std::vector<Slot> slots_;
    Domain::Inputs drawn_;
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
            Climb(question, trial, scenario.size, options.seed, found).run(share);
        });
    internal::tell_story(lab, question, options.seed, found.answer);
    return found;
}

}  // namespace gloam::check
