// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "effect/internal/own_integrands.hpp"
#include "effect/study/angles.hpp"

namespace gloam::effect::own {
namespace {

// A point of the half ball over the tangent plane, relative to the shaded point. cosine: of the angle between
// its direction and the normal.
glm::dvec3 half_ball_point(const glm::dvec3& normal, double azimuth, double length, double cosine) {
    const glm::dvec3 helper = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 bitangent = glm::cross(normal, tangent);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return length * (sine * (std::cos(azimuth) * tangent + std::sin(azimuth) * bitangent) + cosine * normal);
}

// (contribution, 1) of one point; zeros behind the eye. `contribution`: a function of how far the surface
// lies in front of the point, in radii; negative behind it.
template <class Contribution>
glm::dvec2 at_point(const SeenSurface& seen, const glm::dvec3& offset, const Contribution& contribution) {
    const SeenSurface::Compared compared = seen.compared(seen.view().point + offset);
    if (!(compared.depth > 0.0)) return glm::dvec2(0.0);  // behind the eye: not counted
    return {contribution(compared.depth - compared.buffer), 1.0};
}

}  // namespace

// TSSAO-3 with TSSAO-14: uniform radii, cosine-weighted directions.
Integrand hemisphere(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}, range = double{s.own.range}](const std::array<double, 3>& u) {
        const auto offset = half_ball_point(seen.normal(), turn * u[0], u[1], std::sqrt(u[2]));
        return at_point(seen, offset,
                        [&](double in_front) { return in_front > bias && in_front <= range ? 1.0 : 0.0; });
    };
}

// CS-B: uniform radii and directions. A surface up to a radius in front of a point blocks fully; further away
// it blocks by the inverse of the distance.
Integrand filion(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}](const std::array<double, 3>& u) {
        const auto offset = half_ball_point(seen.normal(), turn * u[0], u[1], u[2]);
        return at_point(seen, offset, [&](double distance) {
            const double in_front = distance - bias;
            return in_front > 0.0 ? std::min(1.0 / in_front, 1.0) : 0.0;
        });
    };
}

// CS-3.1: the whole ball, by opposite points.
Integrand crytek(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}](const std::array<double, 3>& u) {
        const auto offset = half_ball_point(seen.normal(), turn * u[0], u[1], u[2]);
        const auto solid = [&](double in_front) { return in_front >= bias ? 1.0 : 0.0; };
        return at_point(seen, offset, solid) + at_point(seen, -offset, solid);
    };
}

}  // namespace gloam::effect::own
