// SPDX-License-Identifier: MIT
#pragma once

#include "judge/run.hpp"

namespace gloam::check {

// Measures what the inputs of a run reach, in the function and in all that it calls, with the interpreter in
// float32. Throws like run(), and interpreter::Error.
[[nodiscard]] Coverage measure_coverage(const Lab& lab, const Question& question, const RunOptions& options);

}  // namespace gloam::check
