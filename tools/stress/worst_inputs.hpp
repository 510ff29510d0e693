// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"
#include "stress/run.hpp"

namespace gloam::stress {

// For every equation of the catalogue, the worst input that a guided search finds (check/run.hpp), as a
// fraction of what its documentation states, beside the worst of its random inputs alone. The search is made
// of the default variant: inputs that break a budget are rows that fail.
[[nodiscard]] Rows worst_inputs(const Context& context);

// The same for one of them.
[[nodiscard]] Rows worst_inputs(const Context& context, const catalogue::Entry& entry);

}  // namespace gloam::stress
