// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "check/internal/budget_judge.hpp"
#include "check/interpretation.hpp"

namespace gloam::check::internal {

// Compares outputs with the results that Vulkan's precision rules permit for the modules that produced them.
class RulesJudge {
  public:
    RulesJudge(const Decoded& decoded, const Scalars& scalars)
        : scalars_(scalars), interpretation_(decoded, scalars.outputs, scalars.result_words) {}

    // Whether the outputs are permitted.
    [[nodiscard]] bool permits(const Sample& sample);

    // Sets the sample's permitted bounds, its fraction of their width, and whether it is forbidden; then the
    // fraction is above 1, and its outcomes are set. Returns whether the rules permit every value for some
    // output.
    bool measure(Sample& sample);

    // Whether the rules permit every result of the last measured sample, but for NaN: any number for each
    // float and integer, both values for each bool.
    [[nodiscard]] bool permits_every(const Sample& sample) const;

    // The largest error, as the budget measures it, that the rules permit for the last measured sample.
    [[nodiscard]] Error largest_permitted(const Sample& sample, const BudgetJudge& budget) const;

    [[nodiscard]] Interpretation& interpretation() { return interpretation_; }

  private:
    [[nodiscard]] double fraction_of(const Sample& sample, std::span<const numeric::Bounds> outcome) const;
    [[nodiscard]] std::vector<Sample::Outcome> outcomes_beside(std::span<const Word> got) const;

    const Scalars& scalars_;
    Interpretation interpretation_;
    Permitted permitted_;
};

}  // namespace gloam::check::internal
