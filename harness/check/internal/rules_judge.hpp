// SPDX-License-Identifier: MIT
#pragma once

#include "check/internal/budget_judge.hpp"

namespace gloam::check::internal {

// Measures outputs against what Vulkan's precision rules permit.
class RulesJudge {
  public:
    RulesJudge(const Rules& rules, const ImageSet& images, const Scalars& scalars);

    // Fills the sample's permitted bounds and its fraction of their width: more than 1 when no outcome holds
    // the outputs. Returns whether the rules permit anything at all for some output.
    bool measure(Sample& sample);

    // The largest error, by the measure of the budget, that the rules permit for the sample measured last.
    [[nodiscard]] Error largest_permitted(const Sample& sample, const BudgetJudge& budget) const;

  private:
    [[nodiscard]] double fraction_of(const Sample& sample, std::span<const numeric::Bounds> outcome) const;

    const Rules& rules_;
    const ImageSet& images_;
    const Scalars& scalars_;
    Permitted permitted_;
};

}  // namespace gloam::check::internal
