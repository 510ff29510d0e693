// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace gloam::scene {

// What lies on the inner side of a plane: (x - point) . normal >= 0.
struct HalfSpace {
    glm::dvec3 point{0, 0, 0};
    glm::dvec3 normal{0, 0, 1};
};

// Where a ray meets a surface.
struct SurfaceHit {
    double distance = 0.0;  // in units of the ray's direction
    glm::dvec3 normal{0};   // unit, against the ray
};

// Surfaces in closed form, met by rays in double: no mesh, no raster. Any space, any unit.
class AnalyticScene {
  public:
    // The part of a plane inside all of `limits`; all of it without any. The normal is unit.
    void add_plane(const HalfSpace& plane, std::vector<HalfSpace> limits = {});

    // All of a sphere, seen from inside or outside. radius > 0.
    void add_sphere(const glm::dvec3& center, double radius);

    // A funnel: the points whose elevation over the plane through the apex, as seen from there, is constant.
    // axis: unit, the middle of the opening. elevation: radians, above 0 and below pi / 2.
    void add_cone(const glm::dvec3& apex, const glm::dvec3& axis, double elevation);

    // The nearest hit at a distance above 0; nullopt for none. `direction` may have any length but 0.
    [[nodiscard]] std::optional<SurfaceHit> first_hit(const glm::dvec3& origin,
                                                      const glm::dvec3& direction) const;

  private:
    struct Plane {
        HalfSpace plane;
        std::vector<HalfSpace> limits;
    };
    struct Sphere {
        glm::dvec3 center;
        double radius = 0.0;
    };
    struct Cone {
        glm::dvec3 apex;
        glm::dvec3 axis;
        double sine = 0.0;  // of the elevation
    };

    static std::optional<SurfaceHit> hit(const Plane& plane, const glm::dvec3& origin,
                                         const glm::dvec3& direction);
    static std::optional<SurfaceHit> hit(const Sphere& sphere, const glm::dvec3& origin,
                                         const glm::dvec3& direction);
    static std::optional<SurfaceHit> hit(const Cone& cone, const glm::dvec3& origin,
                                         const glm::dvec3& direction);

    std::vector<std::variant<Plane, Sphere, Cone>> surfaces_;
};

}  // namespace gloam::scene
