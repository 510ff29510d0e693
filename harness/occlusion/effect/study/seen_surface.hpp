// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "scene/analytic_scene.hpp"

namespace gloam::effect {

// The surface that an estimator sees at a position of a view's image.
struct Seen {
    glm::dvec3 offset{0};  // from the shaded point to the surface, in units of the radius; 0 for background
    glm::dvec3 normal{0};  // of the surface, unit, facing the eye
    double depth = 0.0;    // eye-linear; infinity for background
    bool background = false;
    bool own_pixel = false;  // the pixel of the shaded point
};

// A closed-form view as the samples of its middle point see it, calculated in double without code of the
// shaders. The view has pixels or none. Without pixels, a sample sees the surface at its exact position: the
// limit of a fine image.
class SeenSurface {
  public:
    // pixels: on each side of the image, odd; 0 for the limit. The view must outlive this object.
    SeenSurface(const scene::ClosedFormView& view, std::uint32_t pixels);

    [[nodiscard]] const scene::ClosedFormView& view() const { return *view_; }
    [[nodiscard]] bool orthographic() const { return orthographic_; }
    [[nodiscard]] const glm::dvec3& normal() const { return view_->normal; }

    // Radius, on the image plane, of a disc of radius 1 around the point parallel to the screen.
    [[nodiscard]] double reach() const { return orthographic_ ? 1.0 : -1.0 / view_->point.z; }

    // Width of a pixel on the image plane; 0 without pixels.
    [[nodiscard]] double pitch() const { return pitch_; }

    // The surface at a place. A place is a position on the image plane: x / depth and y / depth, y up; x and
    // y in an orthographic view. With pixels, the result is that at the centre of the nearest pixel inside
    // the image.
    [[nodiscard]] Seen at(const glm::dvec2& place) const;

    // A point of the scene and the surface with which it is compared. With pixels, the point is first moved
    // to its pixel's centre, along the plane through it that is parallel to the tangent plane.
    struct Compared {
        double depth = 0.0;   // of the point, eye-linear; not positive behind the eye
        double buffer = 0.0;  // of the surface there; infinity for background
    };
    [[nodiscard]] Compared compared(const glm::dvec3& point) const;

  private:
    [[nodiscard]] glm::dvec2 snapped(const glm::dvec2& place) const;

    const scene::ClosedFormView* view_;
    bool orthographic_;
    double half_ = 0.0;   // half the side of the image, in places
    double pitch_ = 0.0;  // width of a pixel, in places; 0 without pixels
};

}  // namespace gloam::effect
