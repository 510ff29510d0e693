// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "scene/closed_form_views.hpp"

namespace gloam::effect {

// What an estimator sees at a place of a view's image.
struct Seen {
    glm::dvec3 offset{0};  // from the shaded point to the surface, in units of the radius; 0 for background
    glm::dvec3 normal{0};  // of the surface, unit, facing the eye
    double depth = 0.0;    // eye-linear; infinity for background
    bool background = false;
    bool own_pixel = false;  // that of the shaded point
};

// A closed-form view as the samples of its middle point see it, calculated in double and without the
// shaders' code. The view has pixels or none. Without pixels, a sample sees the surface at its exact place:
// the limit of a fine image.
class SeenSurface {
  public:
    // pixels: of a side of the image, odd; 0 for the limit. The view must outlive this.
    SeenSurface(const scene::ClosedFormView& view, std::uint32_t pixels);

    [[nodiscard]] const scene::ClosedFormView& view() const { return *view_; }
    [[nodiscard]] bool orthographic() const { return orthographic_; }
    [[nodiscard]] const glm::dvec3& normal() const { return view_->normal; }

    // Half the image of a disc parallel to the screen of the radius 1 around the point.
    [[nodiscard]] double reach() const { return orthographic_ ? 1.0 : -1.0 / view_->point.z; }

    // Width of a pixel on the image plane of places; 0 without pixels.
    [[nodiscard]] double pitch() const { return pitch_; }

    // Places are positions on the image plane: x / depth and y / depth, y up; in an orthographic view x and
    // y. With pixels, the surface is that at the centre of the nearest one inside the image.
    [[nodiscard]] Seen at(const glm::dvec2& place) const;

    // The surface that a point of the scene is compared with, and the depth at which it is compared: with
    // pixels the point is first moved to its pixel's centre along the plane through it that is parallel to
    // the tangent plane.
    struct Compared {
        double depth = 0.0;   // of the point, eye-linear; not positive behind the eye
        double buffer = 0.0;  // of the surface there; infinity for background
    };
    [[nodiscard]] Compared compared(const glm::dvec3& point) const;

  private:
    [[nodiscard]] glm::dvec2 snapped(const glm::dvec2& place) const;

    const scene::ClosedFormView* view_;
    bool orthographic_;
    double half_ = 0.0;   // of the image, in places
    double pitch_ = 0.0;  // of pixels, in places; 0 without
};

}  // namespace gloam::effect
