// SPDX-License-Identifier: MIT
#pragma once

#include "check/internal/budget_judge.hpp"
#include "check/internal/interpretation.hpp"

namespace gloam::check::internal {

// Compares outputs with the results that Vulkan's precision rules permit for the modules that produced them.
class RulesJudge {
  public:
    RulesJudge(const Decoded& decoded, const Scalars& scalars)
        : scalars_(scalars), interpretation_(decoded, scalars.outputs) {}

    // Whether the outputs are permitted.
    [[nodiscard]] bool permits(const Sample& sample);

    // Sets the sample's permitted bounds and its fraction of their width; the fraction is above 1 if no
    // outcome contains the outputs. Returns whether the rules permit every value for some output.
    bool measure(Sample& sample);

    // Whether the rules permit every result of the last measured sample, but for NaN: any number for each
    // float and integer, both values for each bool.
    [[nodiscard]] bool permits_every(const Sample& sample) const;

    // The largest error, as the budget measures it, that the rules permit for the last measured sample.
    [[nodiscard]] Error largest_permitted(const Sample& sample, const BudgetJudge& budget) const;

    [[nodiscard]] Interpretation& interpretation() { return interpretation_; }

  private:
    [[nodiscard]] double fraction_of(const Sample& sample, std::span<const numeric::Bounds> outcome) const;

    const Scalars& scalars_;
    Interpretation interpretation_;
    Permitted permitted_;
};

}  // namespace gloam::check::internal
