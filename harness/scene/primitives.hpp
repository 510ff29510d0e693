// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "scene/mesh.hpp"

namespace gloam::scene {

// A parallelogram from `corner` along `u` and `v`, cut into cells of at most `cell` world units a side (large
// triangles cost depth precision). Its normal is u x v. Throws std::invalid_argument for parallel edges or a
// cell that is not positive.
[[nodiscard]] Mesh make_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v,
                                      double cell);

// An axis-aligned box, its faces divided into cells, normals outwards.
[[nodiscard]] Mesh make_box(const glm::dvec3& low, const glm::dvec3& high, double cell);

// The side of an upright cylinder (along y) without its ends, smooth normals outwards. segments: around, at
// least 3.
[[nodiscard]] Mesh make_cylinder(const glm::dvec3& base_center, double radius, double height, int segments);

// A sphere with smooth normals outwards. rings: of latitude, at least 2. segments: around, at least 3.
[[nodiscard]] Mesh make_sphere(const glm::dvec3& center, double radius, int rings, int segments);

// A tube around a closed curve over the parameter 0 to 1, whose tangent is nowhere parallel to z; smooth
// normals outwards. At least 3 segments along and around.
[[nodiscard]] Mesh make_tube(const std::function<glm::dvec3(double)>& closed_curve, double radius, int along,
                             int around);

// A flat strip through pairs of points, left and right (at least 2): a leaf, a blade of grass. Smooth normals
// towards the side of (right - left) x (direction along the strip).
[[nodiscard]] Mesh make_strip(const std::vector<glm::dvec3>& left, const std::vector<glm::dvec3>& right);

}  // namespace gloam::scene
