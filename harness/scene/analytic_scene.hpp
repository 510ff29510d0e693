// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace gloam::scene {

// The points on the inner side of a plane: (x - point) . normal >= 0.
struct HalfSpace {
    glm::dvec3 point{0, 0, 0};
    glm::dvec3 normal{0, 0, 1};
};

// The intersection of a ray with a surface.
struct SurfaceHit {
    double distance = 0.0;  // in units of the ray's direction
    glm::dvec3 normal{0};   // unit, against the ray
};

// Surfaces in closed form, intersected by rays in double, without mesh or raster. Any space, any unit.
class AnalyticScene {
  public:
    // Adds the part of a plane inside all of `limits`; without limits the whole plane. The normal is unit.
    void add_plane(const HalfSpace& plane, std::vector<HalfSpace> limits = {});

    // Adds a sphere, visible from inside and outside. radius > 0.
    void add_sphere(const glm::dvec3& center, double radius);

    // Adds a funnel: the points that the apex sees at a constant elevation above the plane through it. axis:
    // unit, the plane's normal and the middle of the opening. elevation: radians, above 0 and below pi / 2.
    void add_cone(const glm::dvec3& apex, const glm::dvec3& axis, double elevation);

    // The nearest hit at a distance above 0; nullopt if there is none. `direction` may have any length except
    // 0.
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
