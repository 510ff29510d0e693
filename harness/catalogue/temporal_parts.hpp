// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// The parts of append_temporal, one file each.
namespace gloam::catalogue {

void append_accumulation(Entries& entries);  // blending, convergence, what depends on it
void append_history(Entries& entries);       // the history buffer, its interpolation, the start index
void append_packed_history(Entries& entries);
void append_validity(Entries& entries);
void append_reprojection(Entries& entries);  // disocclusion, neighbourhood change, smooth invalidation

}  // namespace gloam::catalogue
