// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "effect/internal/own_integrands.hpp"
#include "effect/study/angles.hpp"

namespace gloam::effect::own {
namespace {

// A direction over the tangent plane. cosine: of its angle with the normal.
glm::dvec3 direction_over(const glm::dvec3& normal, double azimuth, double cosine) {
    const glm::dvec3 helper = std::abs(normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, normal));
    const glm::dvec3 bitangent = glm::cross(normal, tangent);
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
    return sine * (std::cos(azimuth) * tangent + std::sin(azimuth) * bitangent) + cosine * normal;
}

// (contribution, 1) of one point; zeros behind the eye. `contribution`: a function of how far the surface
// lies in front of the point, in radii; negative behind it.
template <class Contribution>
glm::dvec2 at_point(const SeenSurface& seen, const glm::dvec3& offset, const Contribution& contribution) {
    const SeenSurface::Compared compared = seen.compared(seen.view().point + offset);
    if (!(compared.depth > 0.0)) return glm::dvec2(0.0);  // behind the eye: not counted
    return {contribution(compared.depth - compared.buffer), 1.0};
}

glm::dvec2 place_of(const SeenSurface& seen, const glm::dvec3& point) {
    return glm::dvec2(point) / (seen.orthographic() ? 1.0 : -point.z);
}

// Whether one of the steps is behind the visible surface, by more than the bias and by at most the range.
bool blocked(const SeenSurface& seen, const Settings& s, const glm::dvec3& direction, double jitter) {
    for (std::uint32_t i = 0; i < s.own.steps; ++i) {
        const glm::dvec3 at = seen.view().point + (i + jitter) / s.own.steps * direction;
        if (!(at.z < 0.0) || seen.at(place_of(seen, at)).own_pixel) continue;
        const SeenSurface::Compared compared = seen.compared(at);
        const double in_front = compared.depth - compared.buffer;
        if (in_front > double{s.bias} && in_front <= double{s.own.range}) return true;
    }
    return false;
}

// Visits the surfaces at the projected steps of a ray parallel to the image, if they rise above the tangent
// plane.
template <class Visit>
void along_the_image(const SeenSurface& seen, const Settings& s, const glm::dvec3& direction, double jitter,
                     const Visit& visit) {
    for (std::uint32_t i = 0; i < s.own.steps; ++i) {
        const double share = (i + jitter) / s.own.steps;
        const Seen surface = seen.at(share * seen.reach() * glm::dvec2(direction));
        if (surface.background || surface.own_pixel) continue;
        if (glm::dot(surface.offset, seen.normal()) > double{s.bias}) visit(surface.offset);
    }
}

}  // namespace

// TSSAO-3 with TSSAO-14: uniform radii, cosine-weighted directions.
Integrand hemisphere(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}, range = double{s.own.range}](const std::array<double, 3>& u) {
        const auto offset = u[1] * direction_over(seen.normal(), turn * u[0], std::sqrt(u[2]));
        return at_point(seen, offset,
                        [&](double in_front) { return in_front > bias && in_front <= range ? 1.0 : 0.0; });
    };
}

// CS-B: uniform radii and directions. A surface up to a radius in front of a point blocks fully; further away
// it blocks by the inverse of the distance.
Integrand filion(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}](const std::array<double, 3>& u) {
        const auto offset = u[1] * direction_over(seen.normal(), turn * u[0], u[2]);
        return at_point(seen, offset, [&](double distance) {
            const double in_front = distance - bias;
            return in_front > 0.0 ? std::min(1.0 / in_front, 1.0) : 0.0;
        });
    };
}

// CS-3.1: the whole ball, by opposite points.
Integrand crytek(const SeenSurface& seen, const Settings& s) {
    return [seen, bias = double{s.bias}](const std::array<double, 3>& u) {
        const auto offset = u[1] * direction_over(seen.normal(), turn * u[0], u[2]);
        const auto solid = [&](double in_front) { return in_front >= bias ? 1.0 : 0.0; };
        return at_point(seen, offset, solid) + at_point(seen, -offset, solid);
    };
}

// CS-J: rays in cosine-weighted directions. The points of their disc have 64 different radii.
Integrand poisson(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const double radius_squared = (std::floor(64.0 * u[0]) + 0.5) / 64.0;
        const auto direction = direction_over(seen.normal(), turn * u[1], std::sqrt(1.0 - radius_squared));
        return glm::dvec2(blocked(seen, s, direction, u[2]) ? 1.0 : 0.0, 1.0);
    };
}

// CS-D under constant light: uniform directions with a weight of twice their cosine.
Integrand ssdo(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const auto direction = direction_over(seen.normal(), turn * u[0], u[1]);
        return glm::dvec2(blocked(seen, s, direction, u[2]) ? 2.0 * u[1] : 0.0, 1.0);
    };
}

// CS-C2: HBAO's sum along one ray. A surface seen beside the slice is moved into it along the tangent plane.
Integrand hsao(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const glm::dvec3 along(std::cos(turn * u[0]), std::sin(turn * u[0]), 0.0);
        const glm::dvec3 aside = glm::cross(along, glm::dvec3(0, 0, 1));
        const glm::dvec3& n = seen.normal();
        const double turned = glm::dot(aside, n);
        const double steep = 1.0 - turned * turned;
        const glm::dvec3 across = steep > 1e-3 ? (aside - turned * n) / steep : aside;
        const double tangent = std::atan2(-glm::dot(n, along), n.z);
        double horizon = std::sin(std::min(tangent + double{s.own.angle_bias}, right_angle));
        double occlusion = 0.0;
        along_the_image(seen, s, along, u[1], [&](const glm::dvec3& v) {
            const glm::dvec3 offset = v - glm::dot(v, aside) * across;
            const double length = glm::length(offset);
            if (!(length < 1.0 && offset.z / length > horizon)) return;
            occlusion += (offset.z / length - horizon) * (1.0 - length * length);
            horizon = offset.z / length;
        });
        return glm::dvec2(double{s.own.intensity} * occlusion / (1.0 - std::sin(double{s.own.angle_bias})),
                          1.0);
    };
}

// CS-P, the later shader: occ is the largest sat(epsilon (v . n) / (v . v)) of a side; the visibility is (1 -
// occ)^2.
Integrand unreal(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const glm::dvec3 along(std::cos(turn * u[0]), std::sin(turn * u[0]), 0.0);
        double occlusion = 0.0;
        along_the_image(seen, s, along, u[1], [&](const glm::dvec3& v) {
            const double tap = double{s.own.epsilon} * glm::dot(v, seen.normal()) / glm::dot(v, v);
            occlusion = std::max(occlusion, std::min(tap, 1.0));
        });
        const double open = 1.0 - occlusion;
        return glm::dvec2(std::min(double{s.own.intensity}, 1.0) * (1.0 - open * open), 1.0);
    };
}

}  // namespace gloam::effect::own
