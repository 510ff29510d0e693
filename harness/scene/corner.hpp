// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace gloam::scene {

// Occlusion of a point on a floor in front of two infinite walls at right angles: cosine-weighted (TSSAO-1),
// with the linear falloff 1 - d / R. a and b: distances of the point from the walls (>= 0, in the unit of R >
// 0).
// A direction of azimuth phi meets the nearer wall at the horizontal distance rho(phi). The integral over its
// elevation is (1 - rho / R)^2 / 2, and the integral over phi has an antiderivative.
[[nodiscard]] double corner_occlusion(double a, double b, double radius);

// The same for a point of the scene "corner". The point is on the nearest of the planes x = 0, y = 0 and z =
// 0, on the side of positive coordinates; the other two planes are the walls.
[[nodiscard]] double corner_occlusion_at(const glm::dvec3& world, double radius);

}  // namespace gloam::scene
