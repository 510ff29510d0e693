// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "report/benchmark/pareto.hpp"

namespace gloam::report {

// The largest time of a frame.
struct TimeBudget {
    double value = 0.0;
    bool copies = false;  // else milliseconds
};

// Parses "1ms" or "40copies". Throws std::invalid_argument for other text, and for a budget that is not
// positive.
[[nodiscard]] TimeBudget time_budget(std::string_view text);

// The choice with the least mean error among those within the budget in every scene; the faster of equals.
// nullopt if there is none.
[[nodiscard]] std::optional<Overall> best_within(std::span<const Overall> choices, const TimeBudget& budget);

// The fastest choice among those with an RMSE against (G) of at most `error` in every scene; the more exact
// of equals. nullopt if there is none.
[[nodiscard]] std::optional<Overall> fastest_with(std::span<const Overall> choices, double error);

}  // namespace gloam::report
