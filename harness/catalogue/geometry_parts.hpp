// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/entry.hpp"

// The parts of append_geometry, one file each.
namespace gloam::catalogue {

void append_depths(Entries& entries);         // background, depth linearisation
void append_positions(Entries& entries);      // positions, projections, projected radii
void append_normals(Entries& entries);        // unit vectors, normals from neighbours and from depth
void append_reprojections(Entries& entries);  // previous frame, camera-centred positions
void append_cameras(Entries& entries);        // both projections behind one camera
void append_pixels(Entries& entries);         // pixel centres, borders, guard bands

}  // namespace gloam::catalogue
