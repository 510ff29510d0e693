// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "scene/analytic_scene.hpp"

namespace gloam::effect {

// A numerically calculated number and its standard error.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

// A function of a point of [0, 1)^3. Returns (contribution times weight, weight).
using Integrand = std::function<glm::dvec2(const std::array<double, 3>&)>;

// The weighted mean of contributions over the unit cube: the integral of the first component divided by that
// of the second, clamped to [0, 1] as an estimator's mean is; 0 if there is no weight.
// The points are a lattice (multiples of the powers of the root of x^4 = x + 1) with eight shifts, whose
// spread is the error. The number of points is doubled until the error is at most `tolerance`, or until there
// are 2^17 points for each shift. The points differ from those of any Halton sequence.
[[nodiscard]] Estimate expectation(const Integrand& integrand, double tolerance);

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

// The value to which the mean of a method's samples converges, as an integral over the continuous
// distribution of its samples.
struct OwnValue {
    std::string name;
    // The contribution of one sample (or pair, or slice), from the published equations, in double. It shares
    // neither code nor sequences with the shaders. Settings are for a radius of 1.
    Integrand (*integrand)(const SeenSurface&, const Settings&) = nullptr;
    std::string none{};      // if there is no integrand: the reason
    bool of_pixels = false;  // the value grows without bound as pixels shrink
};

// The own values, one for each of methods().
[[nodiscard]] const std::vector<OwnValue>& own_values();

// The own value of the method with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const OwnValue& own_value_of(std::string_view method);

// The occlusion, before the remap, to which the settings' method converges at the view's point. pixels: of a
// side of the image; 0: the limit of ever more pixels. nullopt if the method has no integrand. Throws
// std::invalid_argument for settings of another radius than 1.
[[nodiscard]] std::optional<Estimate> own_value(const scene::ClosedFormView& view, const Settings& settings,
                                                std::uint32_t pixels, double tolerance);

}  // namespace gloam::effect
