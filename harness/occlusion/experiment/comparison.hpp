// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "experiment/database.hpp"

namespace gloam::experiment {

// Questions to results: which candidate errs least within a time, or is fastest with at most an error, in
// every case, and what changed between two runs.

// Parses "1ms". Throws std::invalid_argument for other text, and for a budget that is not positive.
[[nodiscard]] double time_budget(std::string_view text);

// The answers to --budget and --error, if given, as text: the choice among the candidates that were judged
// and timed in all cases, the faster or the more exact of equals, or that there is none and the nearest.
struct Answers {
    std::string text;
    bool all = true;  // each has an answer
};
[[nodiscard]] Answers answers_to(const Database& database, const std::string& budget, double error);

// Text for people: warnings of other circumstances, means of the ratios of new to old, and what got worse or
// better: times beyond the quartiles of both runs, and errors by a ten-thousandth or more. Sizes are compared
// in their order.
struct Comparison {
    std::string text;
    bool got_worse = false;  // anything slower or with a larger error
};
[[nodiscard]] Comparison compared(const Record& before, const Record& after);

}  // namespace gloam::experiment
