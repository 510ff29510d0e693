// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// A depth buffer as a surface in view space: one vertex at the centre of each pixel, in the order of the
// pixels, two triangles between four. Vertices of the background lie behind everything, far enough that the
// sides of an object before it run along the view rays.
//
// thickness: what is assumed of the space behind the surface, world units, > 0. +infinity: it is solid, the
// height field that the depth buffer is; the surface is connected everywhere. Finite: where depth jumps by
// more between neighbours the surface ends, unless the jump continues a slope (1 / depth is linear over a
// plane), and nothing is connected to the background.
//
// normals: one for each pixel, the view's own, or, where the view has none, that of the surface from the
// nearer neighbour on each axis; background 0. `reach`: how far behind everything the background lies at
// least, world units. Throws std::invalid_argument for images whose size disagrees, no geometry in the view,
// a thickness that is not > 0.
[[nodiscard]] Mesh depth_field(const GBuffer& view, double reach,
                               double thickness = std::numeric_limits<double>::infinity());

}  // namespace gloam::scene
