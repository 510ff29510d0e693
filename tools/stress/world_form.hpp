// SPDX-License-Identifier: MIT
#pragma once

#include "check/kernel.hpp"
#include "stress/moved_scene.hpp"

namespace gloam::stress {

// Worst over all points, at one distance.
struct ReprojectionErrors {
    double pixels = 0.0;          // of the previous texture coordinates; infinite where a point got lost
    double clip = 0.0;            // of the previous clip-space point, by component
    double relative_depth = 0.0;  // of the depth in the previous camera
};

// Reprojection with world coordinates and matrices in float32: what engines do that are not centred on the
// camera.
class WorldForm {
  public:
    explicit WorldForm(const check::Lab& lab);

    // Static points by gloam_previous_clip_static; their depth by gloam_previous_depth.
    [[nodiscard]] ReprojectionErrors still(const MovedPoints& all) const;

    // The same points on an object that stays where it is, by gloam_previous_clip_moving.
    [[nodiscard]] ReprojectionErrors moving(const MovedPoints& all) const;

  private:
    check::Kernel<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)> previous_static_;
    check::Kernel<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)>
        previous_moving_;
    check::Kernel<float(glm::vec3, glm::mat4)> previous_depth_;
};

// Position of a point in a camera's view space, in double.
[[nodiscard]] glm::dvec3 in_view(const scene::Camera& camera, const glm::dvec3& point);

// Distance in pixels between where a clip-space point lies and where the exact one does.
[[nodiscard]] double pixels_between(const glm::dvec4& clip, const glm::dvec4& exact);

}  // namespace gloam::stress
