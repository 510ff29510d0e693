// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "check/internal/budget_judge.hpp"
#include "check/judge.hpp"

namespace gloam::check::internal {

// Whether an input is an edge, for which functions document the result: it contains a zero, an infinity or a
// NaN, and otherwise only values of usual size, so that neither overflow nor underflow occurs.
[[nodiscard]] bool is_edge(const Sample& sample, const Scalars& scalars);

// Visits the inputs a few ULP away, whose results an edge may also have. Returns whether a visit ended it.
bool visit_edge_inputs(const Scalars& scalars, std::span<const Word> inputs, const InputVisitor& visit);

// Whether the outputs at an edge equal those of the reference, independently of the promised accuracy. A
// float must be within 1/256 of the largest component of its value (0.01 at least), or within the budget. An
// infinity, a NaN, an integer and a bool must be exact. A branch that rounding decides may go either way, so
// the reference is also evaluated at inputs a few ULP away.
[[nodiscard]] bool holds_at_edge(const Question& question, const ImageSet& images, const Scalars& scalars,
                                 const Sample& sample);

}  // namespace gloam::check::internal
