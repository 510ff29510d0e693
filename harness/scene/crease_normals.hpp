// SPDX-License-Identifier: MIT
#pragma once

#include "scene/mesh.hpp"

namespace gloam::scene {

// The triangles of a mesh with normals calculated from them alone. The normal at a corner is the mean,
// weighted by area, of the faces that meet there and whose normals differ from the corner's own face by at
// most `degrees`. A vertex where faces meet at a larger angle is split. Triangles without area get the normal
// 0. Colours are not kept.
[[nodiscard]] Mesh with_crease_normals(const Mesh& mesh, float degrees);

}  // namespace gloam::scene
