// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// A depth buffer as a surface in view space: one vertex at the centre of each pixel, in the order of the
// pixels, and two triangles between four pixels with geometry. Nothing is connected to the background.
//
// thickness: assumed thickness behind the surface, world units, > 0. +infinity: solid, so the surface is the
// height field of the depth buffer, and neighbours are connected over any jump of depth. Finite: the surface
// ends at a larger jump, unless the jump continues a slope (1 / depth is linear over a plane).
//
// normals: one for each pixel. They are the view's own; if it has none, they follow from the surface, from
// the nearer neighbour on each axis. Background 0. Throws std::invalid_argument for images of another size, a
// view without geometry, and a thickness that is not > 0.
[[nodiscard]] Mesh depth_field(const GBuffer& view,
                               double thickness = std::numeric_limits<double>::infinity());

}  // namespace gloam::scene
