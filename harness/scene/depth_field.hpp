// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// A depth buffer as a surface in view space: one vertex at the centre of each pixel, in the order of the
// pixels, two triangles between four that have geometry. Nothing is connected to the background, of which the
// depth buffer tells nothing.
//
// thickness: what is assumed of the space behind the surface, world units, > 0. +infinity: it is solid, the
// height field that the depth buffer is; neighbours are connected however far depth jumps. Finite: where it
// jumps by more the surface ends, unless the jump continues a slope (1 / depth is linear over a plane).
//
// normals: one for each pixel, the view's own, or, where the view has none, that of the surface from the
// nearer neighbour on each axis; background 0. Throws std::invalid_argument for images whose size disagrees,
// no geometry in the view, a thickness that is not > 0.
[[nodiscard]] Mesh depth_field(const GBuffer& view,
                               double thickness = std::numeric_limits<double>::infinity());

}  // namespace gloam::scene
