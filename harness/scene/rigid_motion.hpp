// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace gloam::scene {

// Object to world: a rotation by an angle in radians around an axis through the object's origin, then a
// translation.
[[nodiscard]] inline glm::dmat4 rigid_motion(const glm::dvec3& position, double angle = 0.0,
                                             const glm::dvec3& axis = {0, 1, 0}) {
    return glm::rotate(glm::translate(glm::dmat4(1.0), position), angle, axis);
}

}  // namespace gloam::scene
