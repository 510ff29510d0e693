// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/analytic_scene.hpp"
#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::scene {

// A view with a closed form of the occlusion at the point in the middle of its image. Lengths are in units of
// the radius of influence.
//
// In all views except `plate` every point of the open space around the point is visible. Mostly that space is
// convex and contains the eye. The depth buffer, taken as solid behind its surface, is then the same as the
// scene. In the view `plate` a plate without thickness hides the floor, so an estimator that has only the
// depth buffer cannot know all that blocks.
struct ClosedFormView {
    std::string name;
    std::string description;
    AnalyticScene scene;  // in view space
    Camera camera;        // at the origin, looking down -z; the image is square
    glm::dvec3 point{0};  // on the optical axis, view space
    glm::dvec3 normal{0, 0, 1};
    double occlusion = 0.0;  // at the point: TSSAO-1, cosine-weighted, linear falloff
    bool seen_whole = true;  // the depth buffer shows the whole scene
    bool flat = true;        // the surface around the point is a plane
};

// Views of planes at three tilts, walls at three distances, a ceiling, grooves, a pit, the inside of a
// sphere, a step and a plate. A ceiling is visible only from below it, so the orthographic views have none.
[[nodiscard]] std::vector<ClosedFormView> closed_form_views(Projection projection);

// The view's images, calculated in double at the centres of size x size pixels. All pixels except the middle
// one are guard band, so a frame is one pixel. Throws std::invalid_argument for a size that is even or below
// 3.
[[nodiscard]] GBuffer draw(const ClosedFormView& view, std::uint32_t size);

}  // namespace gloam::scene
