// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// The parts of append_sampling, one file each.
namespace gloam::catalogue {

void append_sequences(Entries& entries);         // radical inverses and Halton points
void append_sample_maps(Entries& entries);       // from random numbers to the disc, the hemisphere, radii
void append_sample_rotations(Entries& entries);  // frames, rotations, reflections
void append_sample_patterns(Entries& entries);   // spiral, Poisson disc, pairs

}  // namespace gloam::catalogue
