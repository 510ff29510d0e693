// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// The parts of append_filter that have a file of their own.
namespace gloam::catalogue {

void append_edge_aware(Entries& entries);  // filters that look at depth and normals

}  // namespace gloam::catalogue
