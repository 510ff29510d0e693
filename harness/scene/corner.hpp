// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>

namespace gloam::scene {

// Occlusion of a point on a floor before two infinite walls at right angles: cosine-weighted (TSSAO-1), with
// the linear falloff 1 - d / R. a and b are the distances of the point from the walls (>= 0, in the unit of
// R > 0). A direction of azimuth phi meets the nearer wall at the horizontal distance rho(phi). The integral
// over its elevation is (1 - rho / R)^2 / 2, and the integral over phi has an antiderivative.
[[nodiscard]] double corner_occlusion(double a, double b, double radius);

// The same for a point of the scene "corner": on one of the planes x = 0, y = 0, z = 0 (the nearest is
// taken), seen from positive coordinates, the other two being the walls.
[[nodiscard]] double corner_occlusion_at(const glm::dvec3& world, double radius);

}  // namespace gloam::scene
