// SPDX-License-Identifier: MIT
#pragma once

#include "scene/mesh.hpp"

namespace gloam::scene {

/// The triangles of a mesh with normals made from them alone: at each corner the mean, weighted by area, of
/// the faces that meet there and turn from its own face by at most `degrees`. A vertex where faces meet at a
/// larger angle becomes several. Triangles without area have the normal 0. Colours are not kept.
[[nodiscard]] Mesh with_crease_normals(const Mesh& mesh, float degrees);

}  // namespace gloam::scene
