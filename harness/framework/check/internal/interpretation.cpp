// SPDX-License-Identifier: MIT
#include "check/internal/interpretation.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/program.hpp"
#include "module/spirv.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::check::internal {
namespace {

// Limit for one input, all paths together. Beyond it every result counts as permitted.
constexpr std::uint64_t most_path_steps = 4'000'000;

numeric::Bounds bounds_of(const numeric::Interval& x) {
    return x.bounds();
}
numeric::Bounds bounds_of(const numeric::Rearranged& x) {
    return x.interval().bounds();
}

// What a module asks a driver to keep. What the interpreter runs keeps everything.
numeric::Paths::Specials specials_of(const KernelModule& module, const shader::Spirv& words) {
    using enum numeric::Paths::Specials;
    if (module.rounds_to_even) return kept;
    return shader::preserves_specials(words) ? listed : dropped;
}

}  // namespace

Decoded::Decoded(const KernelModules& modules, const ImageSet& images) {
    for (const auto& module : modules) {
        const shader::Spirv& words = module->before.empty() ? module->spirv : module->before;
        parts_.push_back({.module = *module,
                          .program = interpreter::Program(words, module->constants),
                          .images = image_words(module->prototypes, images, "the kernel"),
                          .specials = specials_of(*module, words)});
    }
}

Interpretation::Place Interpretation::place_of(std::size_t index) const {
    const std::vector<Decoded::Part>& parts = decoded_.parts();
    if (parts.size() == 1) return {0, parts.front().module.fixed_inputs == 0 ? 0 : index};
    std::size_t part = 0;
    while (index >= parts.at(part).module.fixed_inputs) index -= parts[part++].module.fixed_inputs;
    return {part, index};
}

template <class N>
InterpretedKernel<N>& Interpretation::kernel(std::size_t part) {
    const Decoded::Part& from = decoded_.parts()[part];
    auto& made = std::get<Made<N>>(parts_[part]);
    if (!made) made = std::make_unique<InterpretedKernel<N>>(from.program, from.module, from.images);
    return *made;
}

bool Interpretation::is_exact(const InputRow& input, std::span<const Word> got) {
    const Place at = place_of(input.index);
    InterpretedKernel<float>& floats = kernel<float>(at.part);
    try {
        floats.run(input.words, at.index);
    } catch (const interpreter::Error& error) {
        if (error.is_of_group()) throw;
        return false;  // undefined: a device may return any value
    }
    exact_.clear();
    for (std::size_t w = 0; w < got.size(); ++w) exact_.push_back(floats.output(w).bits());
    return same_bits(outputs_, got, exact_);
}

std::uint64_t Interpretation::calculate(const InputRow& input, std::vector<double>& outputs) {
    const Place at = place_of(input.index);
    InterpretedKernel<double>& doubles = kernel<double>(at.part);
    outputs.clear();
    const std::uint64_t before = doubles.machine().steps();
    doubles.machine().set_limit(most_instructions);
    // A race may show in one order only.
    if (decoded_.parts()[at.part].module.team.kind == backend::Team::Kind::group) {
        doubles.set_order(interpreter::Order::backward);
        doubles.run(input.words, at.index);
        doubles.set_order(interpreter::Order::forward);
    }
    doubles.run(input.words, at.index);
    for (std::size_t w = 0; w < outputs_.size(); ++w) {
        const auto value = doubles.output(w);
        const auto why = doubles.machine().why_undefined(value);
        if (why && (why->is_used || w < results_)) {
            constexpr auto kind = interpreter::Error::Kind::undefined;
            if (why->place.function.empty()) throw interpreter::Error(kind, why->cause);
            throw interpreter::Error(kind, why->cause, why->place);
        }
        outputs.push_back(shader::is_float(outputs_[w]) ? value.number()
                                                        : whole_number(outputs_[w], value.bits()));
    }
    return doubles.machine().steps() - before;
}

bool Interpretation::holds(std::span<const numeric::Bounds> outcome, std::span<const Word> got) const {
    for (std::size_t w = 0; w < got.size(); ++w)
        if (!outcome[w].contains(number_at(outputs_[w], got[w]))) return false;
    return true;
}

// Explores all paths, or the paths up to the first one that yields `until`.
template <class N>
void Interpretation::explore(InterpretedKernel<N>& kernel, const InputRow& input, std::size_t index,
                             std::span<const Word> until, Permitted& permitted) {
    permitted.width = outputs_.size();
    permitted.outcomes.clear();
    const std::uint64_t before = kernel.machine().steps();
    const auto run = [&] {
        try {
            kernel.machine().set_limit(most_path_steps -
                                       std::min(most_path_steps, kernel.machine().steps() - before));
            kernel.run(input.words, index);
            for (std::size_t w = 0; w < outputs_.size(); ++w) {
                const auto value = kernel.output(w);
                permitted.outcomes.push_back(
                    shader::is_float(outputs_[w])
                        ? bounds_of(value.number())
                        : numeric::Bounds::point(whole_number(outputs_[w], value.bits())));
            }
        } catch (const interpreter::Error&) {
            throw numeric::Paths::Undetermined{};
        }
        if (!until.empty() && holds(permitted.outcome(permitted.count() - 1), until))
            throw numeric::Paths::Enough{};
    };
    const bool to_even = decoded_.parts().front().module.rounds_to_even;
    const auto rounding = to_even ? numeric::Paths::Rounding::to_even : numeric::Paths::Rounding::either;
    const auto specials =
        of_driver_ ? decoded_.parts()[place_of(input.index).part].specials : numeric::Paths::Specials::kept;
    const auto outcome = numeric::Paths::explore(numeric::float32, most_paths, run,
                                                 numeric::Paths::Gaps::open, rounding, specials);
    permitted.anything =
        outcome == numeric::Paths::Outcome::undetermined || outcome == numeric::Paths::Outcome::too_many;
    steps_ += kernel.machine().steps() - before;
}

bool Interpretation::is_permitted(const InputRow& input, std::span<const Word> got) {
    if (got.empty()) return true;
    const Place at = place_of(input.index);
    const auto permits = [&](auto& kernel_of_type) {
        explore(kernel_of_type, input, at.index, got, found_);
        return found_.anything || holds(found_.outcome(found_.count() - 1), got);
    };
    if (permits(kernel<numeric::Interval>(at.part))) return true;
    return decoded_.parts()[at.part].program.may_be_rearranged() &&
           permits(kernel<numeric::Rearranged>(at.part));
}

void Interpretation::all_permitted(const InputRow& input, Permitted& permitted) {
    const Place at = place_of(input.index);
    if (decoded_.parts()[at.part].program.may_be_rearranged()) {
        explore(kernel<numeric::Rearranged>(at.part), input, at.index, {}, permitted);
    } else {
        explore(kernel<numeric::Interval>(at.part), input, at.index, {}, permitted);
    }
}

namespace {

using numeric::infinity;

// Whether each of the bounds contains the other one.
bool covers(std::span<const numeric::Bounds> bounds, std::span<const numeric::Bounds> others) {
    return std::ranges::equal(bounds, others, [](const auto& a, const auto& b) { return a.contains(b); });
}

}  // namespace

bool RulesJudge::permits(const Sample& sample) {
    const InputRow input{sample.index, sample.inputs};
    return interpretation_.is_exact(input, sample.got) || interpretation_.is_permitted(input, sample.got);
}

bool RulesJudge::measure(Sample& sample) {
    interpretation_.all_permitted({sample.index, sample.inputs}, permitted_);
    sample.permitted = hull_of(permitted_);
    sample.fraction = permitted_.anything ? 0.0 : infinity;
    for (std::size_t i = 0; !permitted_.anything && i < permitted_.count(); ++i) {
        sample.fraction = std::min(sample.fraction, fraction_of(sample, permitted_.outcome(i)));
    }
    sample.forbidden = sample.fraction > 1.0;
    if (sample.forbidden) sample.outcomes = outcomes_beside(sample.got);
    return std::ranges::any_of(sample.permitted, [](const auto& bounds) { return bounds.is_anything(); });
}

// Sample::outcomes.
std::vector<Sample::Outcome> RulesJudge::outcomes_beside(std::span<const Word> got) const {
    std::vector<Sample::Outcome> all;
    for (std::size_t i = 0; i < permitted_.count(); ++i) {
        const std::span<const numeric::Bounds> outcome = permitted_.outcome(i);
        if (std::ranges::any_of(all, [&](const auto& other) { return covers(other, outcome); })) continue;
        std::erase_if(all, [&](const auto& other) { return covers(outcome, other); });
        all.emplace_back(outcome.begin(), outcome.end());
    }
    if (all.size() < 2) return {};
    std::ranges::sort(all, [](const auto& a, const auto& b) {
        return std::ranges::lexicographical_compare(a, b, {}, &numeric::Bounds::low, &numeric::Bounds::low);
    });
    for (bool merged = true; merged && all.size() > Sample::most_outcomes;) {
        merged = false;
        for (std::size_t i = 0; i + 1 < all.size() && all.size() > Sample::most_outcomes; ++i) {
            Sample::Outcome both = all[i];
            std::ranges::transform(both, all[i + 1], both.begin(), numeric::hull);
            if (interpretation_.holds(both, got)) continue;
            all[i] = std::move(both);
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            merged = true;
        }
    }
    return all;
}

bool RulesJudge::permits_every(const Sample& sample) const {
    for (std::size_t i = 0; i < sample.permitted.size(); ++i) {
        const numeric::Bounds& bounds = sample.permitted[i];
        const bool is_bool = scalars_.outputs[i] == shader::Scalar::bool_;
        if (bounds.low > (is_bool ? 0.0 : -infinity) || bounds.high < (is_bool ? 1.0 : infinity))
            return false;
    }
    return true;
}

double RulesJudge::fraction_of(const Sample& sample, std::span<const numeric::Bounds> outcome) const {
    double fraction = 0.0;
    for (std::size_t i = 0; i < outcome.size(); ++i) {
        const double got = number_at(scalars_.outputs[i], sample.got[i]);
        fraction = std::max(fraction, fraction_of_width(got, sample.want[i], outcome[i]));
    }
    return fraction;
}

Error RulesJudge::largest_permitted(const Sample& sample, const BudgetJudge& budget) const {
    Error largest;
    std::size_t first = 0;
    for (const std::size_t words : scalars_.output_values) {
        const numeric::FloatFormat& format = format_of(scalars_.outputs[first]);
        const double unit = budget.unit_of(std::span(sample.want).subspan(first, words), format);
        for (std::size_t i = first; i < first + words; ++i) {
            if (!shader::is_float(scalars_.outputs[i])) continue;
            for (const double end : {sample.permitted[i].low, sample.permitted[i].high}) {
                const Error error = budget.float_error(end, sample.want[i], unit, format);
                largest = {std::max(largest.ulp, error.ulp), std::max(largest.absolute, error.absolute),
                           std::max(largest.fraction, error.fraction)};
            }
        }
        first += words;
    }
    return largest;
}

}  // namespace gloam::check::internal
