// SPDX-License-Identifier: MIT
#include "cli/bench/answers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/benchmark/budget.hpp"

namespace gloam::cli {
namespace {

using report::Overall;

void print_choice(const std::string& question, const Overall& choice) {
    fmt::print("{}: {}, at most {:.1f} copies ({:.3f} ms), RMSE (G) {:.4f} in the mean, at most {:.4f}\n",
               question, choice_of(choice.choice), choice.worst_copies, choice.worst_ms, choice.mean_error,
               choice.worst_error);
}

bool print_answer(const std::string& question, const std::optional<Overall>& best,
                  const std::optional<Overall>& nearest) {
    if (best) {
        print_choice(question, *best);
        return true;
    }
    fmt::print("{}: no configuration\n", question);
    if (nearest) print_choice("  the nearest", *nearest);
    return false;
}

std::optional<Overall> least(const std::vector<Overall>& choices, double Overall::* what) {
    const auto found = std::ranges::min_element(choices, {}, what);
    return found == choices.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

bool answer(const report::Benchmark& benchmark, const BenchmarkOptions& options) {
    const std::vector<Overall> choices = report::overall_of(benchmark);
    bool all = true;
    if (!options.budget.empty()) {
        const report::TimeBudget budget = report::time_budget(options.budget);
        const auto time = budget.copies ? &Overall::worst_copies : &Overall::worst_ms;
        all &= print_answer("\nwithin " + options.budget, best_within(choices, budget), least(choices, time));
    }
    if (options.error > 0.0) {
        all &= print_answer(fmt::format("\nRMSE at most {:g}", options.error),
                            fastest_with(choices, options.error), least(choices, &Overall::worst_error));
    }
    if (!options.budget.empty() || options.error > 0.0) {
        fmt::print(
            "copy: the time of a pass that reads one number and writes one for each pixel\n"
            "RMSE (G): root mean square error against the traced geometry\n");
    }
    return all;
}

}  // namespace gloam::cli
