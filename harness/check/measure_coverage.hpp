// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "check/coverage.hpp"
#include "check/run.hpp"

namespace gloam::check {

// What the inputs of such a run reach, by the interpreter in float32, of the function and all that it calls.
// Throws as run() does, and interpreter::Error.
[[nodiscard]] Coverage measure_coverage(const Lab& lab, const Question& question, const RunOptions& options);

}  // namespace gloam::check
