// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/runner.hpp"
#include "numeric/numbers.hpp"

namespace gloam::experiment {

// The passes whose times count: those with this name, or whose names begin with one of the prefixes. All
// where both are empty.
struct TimedPasses {
    std::vector<std::string> prefixes{};
    std::string name{};
};

// "640 x 360".
[[nodiscard]] std::string size_text(gpu::Extent extent);

// The names of a cell's passes, in the order in which they ran. Empty without readings.
[[nodiscard]] std::vector<std::string> passes_of(const Cell& cell);

// A quantity of quantities() over some cases: times are geometric means, all else arithmetic ones.
// statistic: of the readings' times, "median" or "least"; or "exponent" e of the value as a power of what
// grows from case to case. nullopt without cases, where a case lacks it, and for an exponent without two
// different points.
[[nodiscard]] std::optional<double> mean_value(const std::vector<const CaseResult*>& cases,
                                               std::size_t candidate, std::string_view quantity,
                                               std::string_view statistic, const TimedPasses& passes);

// The ratio of the times of two candidates in each round, median by median. NaN without rounds.
[[nodiscard]] numeric::Spread round_ratios(const CaseResult& one, std::size_t of, std::size_t over,
                                           const TimedPasses& passes, const TimedPasses& over_passes);

}  // namespace gloam::experiment
