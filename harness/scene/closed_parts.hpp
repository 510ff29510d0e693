// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "scene/mesh.hpp"

namespace gloam::scene {

// For each triangle of a mesh in view space, whether it cannot be seen because it is the far side of a closed
// part. A part is what is connected by common positions. It is closed if each of its edges belongs to two
// triangles or more, at least 99 % of the edges are passed in both directions, and the triangles face
// outward. No triangle of a part is hidden while the eye, the origin, is within the bounds of the part.
[[nodiscard]] std::vector<bool> hidden_far_sides(const Mesh& view_space, bool orthographic);

}  // namespace gloam::scene
