// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/tune.hpp"
#include "effect/study/tuning.hpp"

namespace gloam::cli {

// What was tuned and what it gains, in Markdown: the parameters before and after, the means of both halves, a
// row for each view, the course of the search.
[[nodiscard]] std::string to_text(const effect::TuneOutcome& outcome, const effect::TuneTask& task,
                                  const TuneOptions& options);

}  // namespace gloam::cli
