// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace gloam::stress {

// Two frames of a camera among points, all moved by one shift. Every coordinate is a multiple of 2^-20, so
// that shifts by whole numbers up to 1e8 are exact in double.
struct MovedPoints {
    glm::dvec3 shift{0};
    scene::Camera now;
    scene::Camera before;
    std::vector<glm::dvec3> points;  // world space; in front of both cameras and inside both images
};

// At the origin. The same points for the same seed.
[[nodiscard]] MovedPoints points_at_origin(std::size_t count, std::uint64_t seed);

// The same at a distance from the origin, in a direction along no axis; the distance is met to 2 units.
[[nodiscard]] MovedPoints moved(MovedPoints points, double distance);

// A built-in scene that is moved likewise.
[[nodiscard]] scene::Scene moved_scene(const char* name, double distance);

// The whole numbers nearest to that distance along (1, -1, 1).
[[nodiscard]] glm::dvec3 shift_by(double distance);

// Projection of the camera in double, and the image it is for.
constexpr double image_width = 1920.0;
constexpr double image_height = 1080.0;
constexpr double aspect = image_width / image_height;
[[nodiscard]] glm::dmat4 projection_of(const scene::Camera& camera);

}  // namespace gloam::stress
