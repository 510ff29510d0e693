// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "check/function.hpp"
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
    check::Function<glm::vec3(glm::vec3, glm::vec3)> previous_;
    check::Function<float(glm::vec3, glm::mat4)> previous_depth_;
    check::Function<bool(glm::vec4, glm::mat4, check::Out<glm::vec2>)> reproject_;
};

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
    check::Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)> previous_static_;
    check::Function<glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4)>
        previous_moving_;
    check::Function<float(glm::vec3, glm::mat4)> previous_depth_;
};

// Position of a point in a camera's view space, in double.
[[nodiscard]] glm::dvec3 in_view(const scene::Camera& camera, const glm::dvec3& point);

// Distance in pixels between where a clip-space point lies and where the exact one does.
[[nodiscard]] double pixels_between(const glm::dvec4& clip, const glm::dvec4& exact);

}  // namespace gloam::stress
