// SPDX-License-Identifier: MIT
#pragma once

#include "check/internal/budget_judge.hpp"
#include "check/internal/interpretation.hpp"

namespace gloam::check::internal {

// Holds outputs against what Vulkan's precision rules permit the modules that gave them.
class RulesJudge {
  public:
    RulesJudge(const Decoded& decoded, const Scalars& scalars)
        : scalars_(scalars), interpretation_(decoded, scalars.outputs) {}

    // Whether the outputs are permitted.
    [[nodiscard]] bool permits(const Sample& sample);

    // Fills the sample's permitted bounds and its fraction of their width: more than 1 when no outcome holds
    // the outputs. Returns whether the rules permit anything at all for some output.
    bool measure(Sample& sample);

    // The largest error, by the measure of the budget, that the rules permit for the sample measured last.
    [[nodiscard]] Error largest_permitted(const Sample& sample, const BudgetJudge& budget) const;

    [[nodiscard]] Interpretation& interpretation() { return interpretation_; }

  private:
    [[nodiscard]] double fraction_of(const Sample& sample, std::span<const numeric::Bounds> outcome) const;

    const Scalars& scalars_;
    Interpretation interpretation_;
    Permitted permitted_;
};

}  // namespace gloam::check::internal
