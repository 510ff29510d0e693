// SPDX-License-Identifier: MIT
#include "check/internal/rules_judge.hpp"

#include <algorithm>

#include "numeric/constants.hpp"

namespace gloam::check::internal {
namespace {

using numeric::infinity;

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
    return std::ranges::any_of(sample.permitted, [](const auto& bounds) { return bounds.is_anything(); });
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
        const double got = as_number(scalars_.outputs[i], sample.got[i]);
        fraction = std::max(fraction, fraction_of_width(got, sample.want[i], outcome[i]));
    }
    return fraction;
}

Error RulesJudge::largest_permitted(const Sample& sample, const BudgetJudge& budget) const {
    Error largest;
    std::size_t first = 0;
    for (const std::size_t words : scalars_.output_values) {
        const double unit = budget.unit_of(std::span(sample.want).subspan(first, words));
        for (std::size_t i = first; i < first + words; ++i) {
            if (scalars_.outputs[i] != shader::Scalar::float_) continue;
            for (const double end : {sample.permitted[i].low, sample.permitted[i].high}) {
                const Error error = budget.float_error(end, sample.want[i], unit);
                largest = {std::max(largest.ulp, error.ulp), std::max(largest.absolute, error.absolute),
                           std::max(largest.fraction, error.fraction)};
            }
        }
        first += words;
    }
    return largest;
}

}  // namespace gloam::check::internal
