// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "effect/internal/own_integrands.hpp"
#include "effect/study/angles.hpp"

namespace gloam::effect::own {
namespace {

enum class Radii { area, uniform };  // taps uniform over the disc's area, or over its radius

// Taps under the disc, integrated over the radius. Contributions grow towards the middle as the inverse of
// the distance; the factor of the area density cancels this.
template <class Contribution>
Integrand taps(const SeenSurface& seen, Radii radii, const Contribution& contribution) {
    return [seen, radii, contribution](const std::array<double, 3>& u) {
        const double density = radii == Radii::area ? 2.0 * u[0] : 1.0;
        const glm::dvec2 place =
            seen.reach() * u[0] * glm::dvec2(std::cos(turn * u[1]), std::sin(turn * u[1]));
        const Seen surface = seen.at(place);
        if (surface.background) return glm::dvec2(0.0, density);
        const glm::dvec3& v = surface.offset;
        return glm::dvec2(density * contribution(glm::length(v), glm::dot(v, seen.normal())), density);
    };
}

using std::numbers::pi;

// The piece of surface in a pixel. Contributions are divided by the pixel's area at its depth, so that they
// converge for small pixels.
struct Piece {
    double distance = 0.0;  // from the shaded point
    double cosine = 0.0;    // of the angle between the offset and the shaded point's normal
    double pixel = 0.0;     // width in the scene, radii; 0 in the limit
    double facing = 0.0;    // cosine between the piece's normal and the direction back to the point
    double seen_at = 0.0;   // the piece's normal times the view ray, whose component along the axis is 1
};

// The sum over the pixels within the disc, as an integral over its radius and angle.
template <class Contribution>
Integrand pieces(const SeenSurface& seen, const Settings& s, const Contribution& contribution) {
    return [seen, s, contribution](const std::array<double, 3>& u) {
        const glm::dvec2 place =
            seen.reach() * u[0] * glm::dvec2(std::cos(turn * u[1]), std::sin(turn * u[1]));
        const Seen surface = seen.at(place);
        if (surface.background || surface.own_pixel) return glm::dvec2(0.0, 1.0);
        const glm::dvec3& v = surface.offset;
        const double distance = glm::length(v);
        const double height = glm::dot(v, seen.normal());
        if (!(height > double{s.bias} && distance <= 1.0)) return glm::dvec2(0.0, 1.0);
        const double scale = seen.orthographic() ? 1.0 : surface.depth;
        const glm::dvec3 position = v + seen.view().point;
        const glm::dvec3 ray = seen.orthographic() ? glm::dvec3(0, 0, -1) : position / surface.depth;
        const Piece piece{.distance = distance,
                          .cosine = height / distance,
                          .pixel = seen.pitch() * scale,
                          .facing = std::max(-glm::dot(v, surface.normal) / distance, 0.0),
                          .seen_at = -glm::dot(surface.normal, ray)};
        const double disc =
            pi * seen.reach() * seen.reach() * 2.0 * u[0];  // area on the image plane, per radius
        const double occlusion = disc * scale * scale * contribution(piece, s, seen.normal(), v);
        return glm::dvec2(double{s.own.intensity} * occlusion, 1.0);
    };
}

// (r / D)^2 of a ball with r half the pixel's width, and its share of the half space, both divided by the
// pixel's area.
double ball(const Piece& piece) {
    return 0.25 / (piece.distance * piece.distance);
}
double ball_fraction(const Piece& piece) {
    const double x = 0.5 * piece.pixel / piece.distance;
    return ball(piece) / (1.0 + std::sqrt(1.0 - x * x));
}

// The differences of position and normal between an end of a cross and the shaded point; 0 for another
// surface.
struct End {
    glm::dvec3 offset{0};
    glm::dvec3 turn{0};
};

End end_at(const SeenSurface& seen, const glm::dvec2& place, double range) {
    const Seen surface = seen.at(place);
    if (surface.background || glm::length(surface.offset) > range) return {};
    return {surface.offset, surface.normal - seen.normal()};
}

// The curvature of the surface in the direction at an angle from the first arm. The changes of position and
// normal along both arms determine its quadratic form.
double curvature_at(const End& first, const End& second, double angle) {
    const double length = glm::length(first.offset);
    if (length < 1e-9) return 0.0;
    const glm::dvec3 along = first.offset / length;
    const double shear = glm::dot(second.offset, along);
    const double across = glm::length(second.offset - shear * along);
    if (across < 1e-4 * glm::length(second.offset) || across == 0.0) return 0.0;
    const double b = std::sin(angle) / across;
    const double a = (std::cos(angle) - b * shear) / length;
    const glm::dvec3 step = a * first.offset + b * second.offset;
    return -glm::dot(step, a * first.turn + b * second.turn);
}

}  // namespace

// TSSAO-12 times epsilon, for surface points of the ball.
Integrand disc(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::area,
                [bias = double{s.bias}, epsilon = double{s.own.epsilon}](double distance, double height) {
                    if (!(distance <= 1.0 && height > bias)) return 0.0;
                    return height / distance * std::min(1.0, epsilon / distance);
                });
}

// CS-3.10 with its factor 2 sigma.
Integrand alchemy(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::area,
                [sigma = double{s.own.intensity}, bias = double{s.bias}, epsilon = double{s.own.epsilon}](
                    double distance, double height) {
                    const double squared = distance * distance + epsilon * epsilon;
                    return height > bias ? 2.0 * sigma * (height - bias) / squared : 0.0;
                });
}

// The recommended variant: 5 sigma (1 - v^2)^3 (v . n - bias) / (v^2 + epsilon^2).
Integrand sao(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::uniform,
                [sigma = double{s.own.intensity}, bias = double{s.bias}, epsilon = double{s.own.epsilon}](
                    double distance, double height) {
                    const double squared = distance * distance;
                    if (!(squared < 1.0 && height > bias)) return 0.0;
                    return 5.0 * sigma * std::pow(1.0 - squared, 3.0) * (height - bias) /
                           (squared + epsilon * epsilon);
                });
}

// ISSAO-6. On the optical axis the covering circle is the disc itself.
Integrand issao(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::uniform,
                [phi = double{s.own.intensity}, psi = double{s.bias}, epsilon = double{s.own.epsilon}](
                    double distance, double height) {
                    if (!(distance < 1.0 && height > psi)) return 0.0;
                    return phi * (height - psi) / (distance * distance + epsilon * epsilon);
                });
}

// ISSAO-4: phi |v| / max(mu, |v|)^2 times the cosine.
Integrand issao_attenuated(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::uniform,
                [phi = double{s.own.intensity}, bias = double{s.bias}, mu = double{s.own.epsilon}](
                    double distance, double height) {
                    if (!(distance < 1.0 && height > bias)) return 0.0;
                    return phi * height / std::pow(std::max(mu, distance), 2.0);
                });
}

// ISSAO-3: the cosine.
Integrand issao_basic(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::uniform, [bias = double{s.bias}](double distance, double height) {
        return distance < 1.0 && height > bias ? height / distance : 0.0;
    });
}

// CS-J: 1 - |v| for surfaces in front of the tangent plane.
Integrand aksoy_phaneuf(const SeenSurface& seen, const Settings& s) {
    return taps(seen, Radii::area, [bias = double{s.bias}](double distance, double height) {
        return height > bias ? std::max(1.0 - distance, 0.0) : 0.0;
    });
}

// The same with taps at a quarter of the radius as well; the sum of both.
Integrand aksoy_phaneuf_two(const SeenSurface& seen, const Settings& s) {
    return [broad = aksoy_phaneuf(seen, s), seen, bias = double{s.bias}](const std::array<double, 3>& u) {
        const glm::dvec2 place =
            0.25 * seen.reach() * u[0] * glm::dvec2(std::cos(turn * u[1]), std::sin(turn * u[1]));
        const Seen surface = seen.at(place);
        const glm::dvec3& v = surface.offset;
        const bool counts = !surface.background && glm::dot(v, seen.normal()) > bias;
        const double fine = counts ? std::max(1.0 - 4.0 * glm::length(v), 0.0) : 0.0;
        return broad(u) + glm::dvec2(2.0 * u[0] * fine, 0.0);
    };
}

// CS-H: balls as wide as their pixels, cosine-weighted.
Integrand sphere_proxy(const SeenSurface& seen, const Settings& s) {
    return pieces(seen, s, [](const Piece& piece, const Settings&, const glm::dvec3&, const glm::dvec3&) {
        return ball(piece) * piece.cosine;
    });
}

// CS-S: discs of the surface's area and normal, cosine-weighted.
Integrand disc_proxy(const SeenSurface& seen, const Settings& s) {
    return pieces(seen, s, [](const Piece& piece, const Settings&, const glm::dvec3&, const glm::dvec3&) {
        const double seen_at = std::max(piece.seen_at, 0.05);
        const double area = piece.pixel * piece.pixel / seen_at;
        const double share = 1.0 / (seen_at * (area + pi * piece.distance * piece.distance));
        return share * piece.cosine * piece.facing;
    });
}

// CS-H: balls, weighted by their solid angle, above the biased tangent plane, with linear falloff.
Integrand mixture(const SeenSurface& seen, const Settings& s) {
    return pieces(
        seen, s, [](const Piece& piece, const Settings& settings, const glm::dvec3& n, const glm::dvec3& v) {
            const double across = glm::length(glm::dvec2(v));
            const double slope = across > 0.0 ? -glm::dot(glm::dvec2(n), glm::dvec2(v)) / across : 0.0;
            const double least = std::atan2(slope, n.z) + double{settings.own.angle_bias};
            if (!(std::atan2(v.z, across) > std::min(least, 0.5 * pi))) return 0.0;
            return ball_fraction(piece) * piece.cosine * (1.0 - piece.distance);
        });
}

// CS-K: the mean over directions of sin^2 of the quadric's horizon. The crosses have half the radius to the
// whole radius.
Integrand curvature(const SeenSurface& seen, const Settings& s) {
    return [seen, range = double{s.own.range}](const std::array<double, 3>& u) {
        const double share = (0.5 + 0.5 * u[0]) * seen.reach();
        // The image's y axis points down, and so does that of the crosses.
        const glm::dvec2 arm =
            share * glm::dvec2(std::cos(0.25 * turn * u[1]), -std::sin(0.25 * turn * u[1]));
        const glm::dvec2 other(arm.y, -arm.x);
        const auto across = [&](const glm::dvec2& along) {
            const End ahead = end_at(seen, along, range);
            const End behind = end_at(seen, -along, range);
            return End{ahead.offset - behind.offset, ahead.turn - behind.turn};
        };
        const double q = 0.5 * std::max(curvature_at(across(arm), across(other), turn * u[2]), 0.0);
        return glm::dvec2(q * q / (1.0 + q * q), 1.0);
    };
}

}  // namespace gloam::effect::own
