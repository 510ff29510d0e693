// SPDX-License-Identifier: MIT
#include "check/internal/rules_judge.hpp"

#include <algorithm>

#include "numeric/numbers.hpp"

namespace gloam::check::internal {
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
