// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// A view with a closed form of the occlusion at the point in the middle of its image. Lengths are in units of
// the radius of influence.
//
// In all views except `plate` every point of the open space around the point is visible. Mostly that space is
// convex and contains the eye. The depth buffer, taken as solid behind its surface, is then the same as the
// scene. In the view `plate` a plate without thickness hides the floor, so an estimator that has only the
// depth buffer cannot know all that blocks.
struct ClosedFormView {
    Scene scene;  // the point is the origin, +z its normal, +x the blockers' side; the camera looks at it
    double occlusion = 0.0;  // at the point: TSSAO-1, cosine-weighted, linear falloff
};

// Views of planes at three tilts, walls at three distances, a ceiling, grooves, a pit, the inside of a
// sphere, a step and a plate. A ceiling is visible only from below it, so the orthographic views have none.
[[nodiscard]] std::vector<ClosedFormView> closed_form_views(Projection projection);

// The view's images of size x size pixels. All pixels except the middle one are guard band, so a frame is one
// pixel. size: odd, from 3 on.
[[nodiscard]] GBuffer draw(const ClosedFormView& view, std::uint32_t size);

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
