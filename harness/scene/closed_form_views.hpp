// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/analytic_scene.hpp"
#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::scene {

// A view whose occlusion is known in closed form at the point in the middle of its image. Lengths are in
// units of the radius of influence.
//
// In all of them but `plate` every point of the open space around it can be seen, mostly because that space
// is convex and the eye lies in it: the depth buffer, solid behind what it shows, is the scene. Under
// `plate`, which has no thickness, the floor is hidden: what blocks there is more than an estimator that has
// only the depth buffer can know.
struct ClosedFormView {
    std::string name;
    std::string description;
    AnalyticScene scene;  // in view space
    Camera camera;        // at the origin, looking down -z; the image is square
    glm::dvec3 point{0};  // on the optical axis, view space
    glm::dvec3 normal{0, 0, 1};
    double occlusion = 0.0;  // there: TSSAO-1, cosine-weighted, linear falloff
    bool seen_whole = true;  // the depth buffer is the scene
    bool flat = true;        // the surface around the point is a plane
};

// Planes at three tilts, walls at three distances, a ceiling, grooves, a pit, the inside of a sphere, a step,
// a plate. A ceiling is seen only from between it and the floor: the orthographic views have none.
[[nodiscard]] std::vector<ClosedFormView> closed_form_views(Projection projection);

// The view's images, calculated in double at the centres of size x size pixels. All of it but the pixel in
// the middle is guard band, so that a frame is one pixel. Throws std::invalid_argument for a size that is
// even or below 3.
[[nodiscard]] GBuffer draw(const ClosedFormView& view, std::uint32_t size);

}  // namespace gloam::scene
