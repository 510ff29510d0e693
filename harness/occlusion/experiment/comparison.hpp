// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiment/results.hpp"
#include "experiment/table.hpp"
#include "numeric/numbers.hpp"

namespace gloam::experiment {

// Questions to the results of one size: which candidate errs least within a time, or is fastest with at most
// an error, in every case.

// Parses "1ms". Throws std::invalid_argument for other text, and for a budget that is not positive.
[[nodiscard]] double time_budget(std::string_view text);

// A candidate over all cases.
struct Choice {
    std::string name;
    double ms = 0.0;           // geometric mean
    double worst_ms = 0.0;     // in the case that takes longest
    double mean_error = 0.0;   // RMSE against (G)
    double worst_error = 0.0;  // in the case with the largest error
};

// Every candidate that was judged and timed in all cases.
[[nodiscard]] std::vector<Choice> choices_of(const Experiment& experiment, const SizeResult& result);

// The choice with the least mean error among those within so many milliseconds in every case; the faster of
// equals. nullopt: there is none.
[[nodiscard]] std::optional<Choice> best_within(const std::vector<Choice>& choices, double budget);

// The fastest choice with an error of at most `error` in every case; the more exact of equals. nullopt: there
// is none.
[[nodiscard]] std::optional<Choice> fastest_with(const std::vector<Choice>& choices, double error);

// The answers to --budget and --error, if given, as text: the choice, or that there is none and the nearest.
struct Answers {
    std::string text;
    bool all = true;  // each has an answer
};
[[nodiscard]] Answers answers_to(const Experiment& experiment, const std::vector<SizeResult>& results,
                                 const std::string& budget, double error);

// A candidate of a case in two runs: ratios of new to old.
struct Change {
    std::string name;      // "columns/gtao/16/single"
    numeric::Spread time;  // ratio of the times of all passes; low and high from the quartiles
    double error = 1.0;    // ratio of the RMSE of the displayed image against (G)
    bool slower = false;   // the new lower quartile is above the old upper quartile
    bool faster = false;   // the new upper quartile is below the old lower quartile
    bool worse = false;    // the RMSE rose by a ten-thousandth or more; it has no spread
    bool better = false;
};

struct Comparison {
    std::vector<Change> changes;  // of what both runs hold, in the order of the new run
    double time = 1.0;            // geometric mean of the ratios
    double error = 1.0;
    std::vector<std::string> only_old;  // names
    std::vector<std::string> only_new;
    std::vector<std::string> warnings;  // reasons against a comparison: another device, another size

    [[nodiscard]] bool got_worse() const;  // anything slower or worse
};

// Sizes are compared in their order.
[[nodiscard]] Comparison compared(const Record& before, const Record& after);

// Text for people: warnings, means, what got worse and what got better, with ratios and their spread.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace gloam::experiment
