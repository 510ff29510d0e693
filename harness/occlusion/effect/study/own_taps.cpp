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

}  // namespace gloam::effect::own
