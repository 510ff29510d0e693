// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "check/kernel.hpp"
#include "stress/moved_scene.hpp"

namespace gloam::stress {

// Everything that reprojection centred on the camera computes, on host and device.
struct CenteredResults {
    glm::mat4 previous_from_current{0};                // scene::make_frame
    std::vector<glm::vec3> previous;                   // gloam_camera_centered_previous
    std::vector<float> previous_depth;                 // gloam_previous_depth of it
    std::vector<std::tuple<bool, glm::vec2>> texture;  // gloam_reproject_clip by the matrix above

    // All words in order, for comparison to the bit.
    [[nodiscard]] std::vector<check::Word> words() const;
};

// Reprojection by positions relative to the eye: what the host subtracts, it subtracts in double.
class CenteredForm {
  public:
    explicit CenteredForm(const check::Lab& lab);

    [[nodiscard]] CenteredResults run(const MovedPoints& all) const;

    // Worst distance of the texture coordinates from the exact ones, in pixels; infinite where a point got
    // lost.
    [[nodiscard]] static double pixels(const MovedPoints& all, const CenteredResults& results);

    // Worst error of the depth in the previous camera, as a part of the point's distance from its eye.
    [[nodiscard]] static double depth_error(const MovedPoints& all, const CenteredResults& results);

  private:
    check::Kernel<glm::vec3(glm::vec3, glm::vec3)> previous_;
    check::Kernel<float(glm::vec3, glm::mat4)> previous_depth_;
    check::Kernel<bool(glm::vec4, glm::mat4, check::Out<glm::vec2>)> reproject_;
};

}  // namespace gloam::stress
