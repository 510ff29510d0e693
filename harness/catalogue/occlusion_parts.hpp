// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// The parts of append_occlusion, one file each.
namespace gloam::catalogue {

void append_falloffs(Entries& entries);       // weight of a hit by its distance
void append_contributions(Entries& entries);  // weight of a sample, and the mean over samples
void append_points(Entries& entries);         // methods of single points, and their parts
void append_horizons(Entries& entries);       // horizon-based AO
void append_volumes(Entries& entries);        // methods that pair opposite samples
void append_slice_methods(Entries& entries);  // methods that work in slices through the eye
void append_sweeps(Entries& entries);         // the parts of the horizon sweep
void append_gathers(Entries& entries);        // the estimators of a pixel, which read images
void append_slice_gathers(Entries& entries);  // those that march along slices
void append_ray_gathers(Entries& entries);    // those that march along rays, or sum over proxies

}  // namespace gloam::catalogue
