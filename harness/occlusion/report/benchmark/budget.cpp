// SPDX-License-Identifier: MIT
#include "report/benchmark/budget.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace gloam::report {

TimeBudget time_budget(std::string_view text) {
    TimeBudget budget;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), budget.value);
    const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
    budget.copies = unit == "copies";
    if (error == std::errc{} && (unit == "ms" || budget.copies) && std::isfinite(budget.value) &&
        budget.value > 0.0)
        return budget;
    throw std::invalid_argument(
        fmt::format("--budget {}: expected milliseconds or copies, such as 1ms or 40copies", text));
}

std::optional<Overall> best_within(std::span<const Overall> choices, const TimeBudget& budget) {
    std::optional<Overall> best;
    for (const Overall& choice : choices) {
        if (!((budget.copies ? choice.worst_copies : choice.worst_ms) <= budget.value)) continue;
        if (!best || std::pair(choice.mean_error, choice.copies) < std::pair(best->mean_error, best->copies))
            best = choice;
    }
    return best;
}

std::optional<Overall> fastest_with(std::span<const Overall> choices, double error) {
    std::optional<Overall> best;
    for (const Overall& choice : choices) {
        if (!(choice.worst_error <= error)) continue;
        if (!best || std::pair(choice.copies, choice.mean_error) < std::pair(best->copies, best->mean_error))
            best = choice;
    }
    return best;
}

}  // namespace gloam::report
