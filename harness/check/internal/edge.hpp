// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "check/internal/budget_judge.hpp"
#include "check/judge.hpp"

namespace gloam::check::internal {

// Whether an input is one whose result a function documents by value: it holds a zero, an infinity or a NaN,
// and nothing else that is not of usual size, so that neither over- nor underflow comes in.
[[nodiscard]] bool is_edge(const Sample& sample, const Scalars& scalars);

// Whether the outputs at an edge are those of the reference, whatever accuracy is promised there: to 1/256 of
// the largest of a value's components (0.01 at least) or within the budget, and an infinity, a NaN, an
// integer and a truth value to the bit. A branch that rounding decides may go either way: the reference is
// asked at inputs a few ULP away as well.
[[nodiscard]] bool holds_at_edge(const Question& question, const ImageSet& images, const Scalars& scalars,
                                 const Sample& sample);

}  // namespace gloam::check::internal
