// SPDX-License-Identifier: MIT
#include "judge/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "base/threads.hpp"
#include "interpreter/program.hpp"
#include "judge/internal/budget_judge.hpp"
#include "judge/interpretation.hpp"
#include "numeric/numbers.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

using numeric::Bounds;
using numeric::infinity;

// Whether each of the bounds contains the other one.
bool covers(const Sample::Outcome& bounds, const Sample::Outcome& others) {
    return std::ranges::equal(bounds, others, [](const auto& a, const auto& b) { return a.contains(b); });
}

// Which inputs of a run are judged by the rules, and for which of these all permitted results are calculated.
// Where the budget is the criterion, the rules are asked as well for the first inputs, which contain all
// kinds, and for a share of the others.
struct Plan {
    std::size_t rules_every = 1;
    std::size_t bounds_every = 0;  // 0: for none

    static constexpr std::size_t first_inputs = 512;
    [[nodiscard]] bool by_rules(std::size_t i) const { return i < first_inputs || i % rules_every == 0; }
    [[nodiscard]] bool bounded(std::size_t i) const { return bounds_every != 0 && i % bounds_every == 0; }
};

class Judge {
  public:
    Judge(const Question& question, const JudgeOptions& options, const ImageSet& images,
          const Decoded& decoded, const Plan& plan)
        : question_(question),
          options_(options),
          images_(images),
          plan_(plan),
          scalars_(question.signature),
          predicate_(std::ranges::all_of(
              scalars_.outputs, [](module::Scalar scalar) { return scalar == module::Scalar::bool_; })) {
        if (!decoded.empty()) rules_.emplace(decoded, question.signature);
    }

    void add(Answer& answer, Sample& sample, bool branch) {
        sample.input_class = internal::class_of(sample.inputs, scalars_.inputs, branch);
        try {
            find_want(sample);
        } catch (const interpreter::Error& error) {
            const bool is_long = error.kind() == interpreter::Error::Kind::too_many_steps;
            if ((question_.defined && !is_long) || !error.is_of_input()) throw;
            answer.add_undefined(sample.input_class, is_long ? NoResult::too_long : NoResult::undefined,
                                 error.what());
            return;
        }
        if (!options_.nan && internal::holds_special(sample, scalars_.inputs)) {
            answer.add_recorded(sample.input_class);
            if (predicate_) answer.add_predicate(sample.want, false);
            return;
        }
        const bool promised = !question_.promised || question_.promised(sample.inputs);
        const bool edge = options_.edges && question_.reference && internal::is_edge(sample, scalars_);
        sample.error = internal::error_of(question_, images_, scalars_, sample, promised);
        sample.fraction = sample.error.fraction;
        const bool by_budget = options_.criterion == Criterion::budget &&
                               (promised || internal::has_codomain(question_, scalars_));
        const bool free = rules_ && plan_.by_rules(sample.index)
                              ? ask_rules(answer, sample, promised, !by_budget && !edge)
                              : true;
        const bool accurate = promised && sample.error.fraction <= 1.0;
        if (edge && !accurate && !internal::holds_at_edge(question_, images_, scalars_, sample))
            sample.fraction = infinity;
        const bool open = free && !by_budget && !edge;
        if (open) ++answer.count(sample.input_class).open;
        if (predicate_) answer.add_predicate(sample.want, !open);
        if (question_.must_hold && sample.fraction <= 1.0) require_true(sample);
        answer.add(sample, sample.fraction > 1.0);
    }

  private:
    // A false that the rules permit is the function's own failure.
    void require_true(Sample& sample) const {
        if (std::ranges::find(sample.got, Word{0}) == sample.got.end()) return;
        std::ranges::fill(sample.want, 1.0);
        sample.error = internal::error_of(question_, images_, scalars_, sample, true);
        sample.fraction = infinity;
    }

    void find_want(Sample& sample) {
        if (question_.reference) {
            question_.reference(images_, sample.inputs, sample.want);
        } else {
            rules_->calculate({sample.index, sample.inputs}, sample.want);
        }
        if (sample.want.size() != scalars_.outputs.size()) {
            throw std::logic_error(fmt::format("the reference gave {} output words, the signature has {}",
                                               sample.want.size(), scalars_.outputs.size()));
        }
    }

    // Whether the rules permit every result; false if that was not asked. `only_rules`: nothing else judges
    // this input. Sets the permitted bounds, the fraction of their width, and whether the outputs are
    // forbidden: then the fraction is above 1, and the outcomes are set.
    bool ask_rules(Answer& answer, Sample& sample, bool promised, bool only_rules) {
        const InputRow input{sample.index, sample.inputs};
        const bool bounded = plan_.bounded(sample.index);
        const bool must_know = only_rules && options_.criterion == Criterion::budget;
        ++answer.by_rules;
        if (!bounded && !must_know &&
            (rules_->is_exact(input, sample.got) || rules_->is_permitted(input, sample.got))) {
            if (options_.criterion == Criterion::rules) sample.fraction = 0.0;
            return false;
        }
        const Permitted permitted = rules_->all_permitted(input);
        sample.permitted = hull_of(permitted);
        sample.fraction = infinity;
        for (const Sample::Outcome& outcome : permitted)
            sample.fraction = std::min(sample.fraction, fraction_of(sample, outcome));
        sample.forbidden = sample.fraction > 1.0;
        if (sample.forbidden) sample.outcomes = outcomes_beside(permitted, sample.got);
        if (bounded) add_bounds(answer, sample, promised);
        if (options_.criterion == Criterion::budget)
            sample.fraction = sample.forbidden ? infinity : sample.error.fraction;
        return (bounded || must_know) && permits_every(sample);
    }

    [[nodiscard]] double fraction_of(const Sample& sample, const Sample::Outcome& outcome) const {
        double fraction = 0.0;
        for (std::size_t i = 0; i < outcome.size(); ++i)
            fraction = std::max(fraction, fraction_of_width(number_at(scalars_.outputs[i], sample.got[i]),
                                                            sample.want[i], outcome[i]));
        return fraction;
    }

    // Sample::outcomes.
    [[nodiscard]] std::vector<Sample::Outcome> outcomes_beside(const Permitted& permitted,
                                                               std::span<const Word> got) const {
        std::vector<Sample::Outcome> all;
        for (const Sample::Outcome& outcome : permitted) {
            if (std::ranges::any_of(all, [&](const auto& other) { return covers(other, outcome); })) continue;
            std::erase_if(all, [&](const auto& other) { return covers(outcome, other); });
            all.push_back(outcome);
        }
        if (all.size() < 2) return {};
        std::ranges::sort(all, [](const auto& a, const auto& b) {
            return std::ranges::lexicographical_compare(a, b, {}, &Bounds::low, &Bounds::low);
        });
        for (bool merged = true; merged && all.size() > Sample::most_outcomes;) {
            merged = false;
            for (std::size_t i = 0; i + 1 < all.size() && all.size() > Sample::most_outcomes; ++i) {
                Sample::Outcome both = all[i];
                std::ranges::transform(both, all[i + 1], both.begin(), numeric::hull);
                if (rules_->holds(both, got)) continue;
                all[i] = std::move(both);
                all.erase(all.begin() + static_cast<std::ptrdiff_t>(i) + 1);
                merged = true;
            }
        }
        return all;
    }

    // But for NaN: any number for each float and integer, both values for each bool.
    [[nodiscard]] bool permits_every(const Sample& sample) const {
        for (std::size_t i = 0; i < sample.permitted.size(); ++i) {
            const Bounds& bounds = sample.permitted[i];
            const bool is_bool = scalars_.outputs[i] == module::Scalar::bool_;
            if (bounds.low > (is_bool ? 0.0 : -infinity) || bounds.high < (is_bool ? 1.0 : infinity))
                return false;
        }
        return true;
    }

    void add_bounds(Answer& answer, const Sample& sample, bool promised) {
        ++answer.bounded;
        const bool anything = std::ranges::any_of(sample.permitted, &Bounds::is_anything);
        if (anything && answer.unbounded++ == 0) answer.first_unbounded = sample;
        if (!anything && promised && sample.input_class <= InputClass::zero)
            answer.guarantee.raise(largest_permitted(sample));
    }

    // The largest error, as the budget measures it, that the rules permit.
    [[nodiscard]] ErrorSize largest_permitted(const Sample& sample) const {
        ErrorSize largest;
        std::size_t first = 0;
        for (const std::size_t words : scalars_.output_values) {
            const numeric::FloatFormat& format = format_of(scalars_.outputs[first]);
            const double unit =
                internal::unit_of(question_.budget, std::span(sample.want).subspan(first, words), format);
            for (std::size_t i = first; i < first + words; ++i) {
                if (!module::is_float(scalars_.outputs[i])) continue;
                for (const double end : {sample.permitted[i].low, sample.permitted[i].high})
                    largest.raise(internal::float_error(question_.budget, end, sample.want[i], unit, format));
            }
            first += words;
        }
        return largest;
    }

    const Question& question_;
    const JudgeOptions& options_;
    const ImageSet& images_;
    const Plan& plan_;
    internal::Scalars scalars_;
    bool predicate_;  // all results are boolean
    std::optional<Interpretation> rules_;
};

// The decoded modules. None if they are not needed and the interpreter does not know an instruction of them;
// then no input is judged by the rules.
Decoded decoded_modules(const KernelModules& modules, const ImageSet& images, bool needed) {
    try {
        return decode(modules, images);
    } catch (const interpreter::Error& error) {
        if (needed || error.kind() != interpreter::Error::Kind::unknown_instruction) throw;
        return {};
    }
}

// The mean cost of the bounds of evenly distributed inputs of the run, in instructions.
double mean_cost(const Decoded& decoded, const Question& question, const Domain::Inputs& inputs) {
    constexpr std::size_t probes = 32;
    Interpretation rules(decoded, question.signature);
    const std::size_t step = std::max<std::size_t>(inputs.count() / probes, 1);
    std::size_t probed = 0;
    for (std::size_t i = 0; i < inputs.count(); i += step, ++probed)
        static_cast<void>(rules.all_permitted({i, inputs.row(i)}));
    return static_cast<double>(rules.steps()) / static_cast<double>(std::max<std::size_t>(probed, 1));
}

// `every_bound`: where the rules are the criterion, bounds are calculated for each input.
Plan plan_of(Criterion criterion, bool every_bound, const Decoded& decoded, const Question& question,
             const Domain::Inputs& inputs) {
    constexpr std::size_t other_inputs = 512;
    // Limits for the inputs whose bounds are calculated, and for the instructions of all these bounds: less
    // than half a second.
    constexpr std::size_t most_bounded = 2048;
    constexpr double most_steps = 4e6;
    const std::size_t count = inputs.count();
    if (criterion == Criterion::budget)
        return {.rules_every = std::max<std::size_t>(count / other_inputs, 1)};
    if (every_bound) return {.bounds_every = 1};
    const double steps = mean_cost(decoded, question, inputs) * static_cast<double>(count);
    return {.bounds_every =
                1 + std::max(static_cast<std::size_t>(steps / most_steps), (count - 1) / most_bounded)};
}

}  // namespace

Answer empty_answer(const Question& question, Criterion criterion) {
    return {{.equation = question.name.empty() ? question.function : question.name,
             .function = question.function,
             .file = question.file,
             .criterion = criterion,
             .budget = question.budget,
             .must_hold = question.must_hold}};
}

Answer judge(const Question& question, const JudgeOptions& options, const Domain::Inputs& inputs,
             std::span<const Word> outputs, const ImageSet& images, const std::string& scenario,
             std::span<double> fractions) {
    Answer all = empty_answer(question, options.criterion);
    const bool needs_modules = options.criterion == Criterion::rules || !question.reference;
    if (needs_modules && options.modules.empty()) {
        const std::vector<module::Scalar> scalars = question.signature.input_scalars();
        for (std::size_t i = 0; i < inputs.count(); ++i)
            all.add_recorded(internal::class_of(inputs.row(i), scalars, inputs.branch[i]));
        return all;
    }
    const Decoded decoded = decoded_modules(options.modules, images, needs_modules);
    const Plan plan = plan_of(options.criterion, !fractions.empty(), decoded, question, inputs);
    const std::size_t width = question.signature.output_words();
    const std::vector<base::Range> shares = base::shares_of(inputs.count(), base::processors());
    std::vector<Answer> parts(shares.size());
    base::for_each_index(parts.size(), 0, [&](std::size_t part) {
        Judge judge(question, options, images, decoded, plan);
        for (std::size_t i = shares[part].begin; i < shares[part].end; ++i) {
            const auto row = inputs.row(i);
            const auto got = outputs.subspan(i * width, width);
            Sample sample{.index = i,
                          .scenario = scenario,
                          .inputs = {row.begin(), row.end()},
                          .got = {got.begin(), got.end()}};
            judge.add(parts[part], sample, inputs.branch[i]);
            if (!fractions.empty()) fractions[i] = sample.fraction;
        }
    });
    for (const Answer& answer : parts) all.merge(answer);
    describe_samples(question.signature, all);
    return all;
}

}  // namespace gloam::judge
