// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

namespace gloam::catalogue {

// Adds the inputs with the largest errors that a search has found to the domains of their equations. Throws
// std::logic_error for an input whose equation is not among the entries.
void add_worst_inputs(Entries& entries);

}  // namespace gloam::catalogue
