// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "report/benchmark/pareto.hpp"

namespace gloam::report {

// What a frame may take.
struct TimeBudget {
    double value = 0.0;
    bool copies = false;  // else milliseconds
};

// "1ms", "40copies". Throws std::invalid_argument for another text, and for a budget that is not positive.
[[nodiscard]] TimeBudget time_budget(std::string_view text);

// The choice with the least mean error of those that stay within the budget in every scene; the faster of
// equals. Nothing where none does.
[[nodiscard]] std::optional<Overall> best_within(std::span<const Overall> choices, const TimeBudget& budget);

// The fastest choice of those whose RMSE against (G) is at most `error` in every scene; the more exact of
// equals. Nothing where none is.
[[nodiscard]] std::optional<Overall> fastest_with(std::span<const Overall> choices, double error);

}  // namespace gloam::report
