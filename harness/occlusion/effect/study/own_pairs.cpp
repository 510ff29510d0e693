// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "effect/internal/own_integrands.hpp"
#include "effect/study/angles.hpp"

namespace gloam::effect::own {
namespace {

constexpr double background = 1e4;  // radii behind the shaded point

// Two opposite taps: the aimed position on the disc parallel to the image, and the height of the surface over
// that disc towards the eye. The surface is assumed to have the same height over the tangent plane there as
// at the pixel that was read.
struct Pair {
    glm::dvec3 aim{0};   // of the first tap; that of the second is opposite
    double first = 0.0;  // height
    double second = 0.0;
};

double height_over(const SeenSurface& seen, const glm::dvec2& place, const glm::dvec3& aim) {
    const Seen surface = seen.at(place);
    glm::dvec3 offset = surface.offset;
    if (surface.background) {
        const double far = -seen.view().point.z + background;
        offset = glm::dvec3(place * (seen.orthographic() ? 1.0 : far), -far) - seen.view().point;
    }
    return glm::dot(offset - aim, seen.normal()) / std::max(seen.normal().z, 1e-4);
}

// A pair of taps, uniform over the area of a disc. share: the disc's radius in units of the radius.
Pair pair_at(const SeenSurface& seen, const std::array<double, 3>& u, double share = 1.0) {
    const glm::dvec2 point =
        share * std::sqrt(u[0]) * glm::dvec2(std::cos(turn * u[1]), std::sin(turn * u[1]));
    const glm::dvec3 aim(point, 0.0);
    return {aim, height_over(seen, seen.reach() * point, aim),
            height_over(seen, -seen.reach() * point, -aim)};
}

// Position at which the surface crosses a chord: 0 at its far end, 1 at its near end, outside [0, 1] if it
// misses the chord.
double place_on_chord(double height, double half_chord) {
    return 0.5 + 0.5 * height / half_chord;
}

// Sum of the solid shares of both chords of a pair.
double solid_of(const Pair& pair, double half_chord) {
    const double first = place_on_chord(pair.first, half_chord);
    const double second = place_on_chord(pair.second, half_chord);
    const auto own = [](double place) { return place >= 0.35 && place <= 1.0; };
    // A single share and its complement add up to 1, and so do two halves.
    return own(first) && own(second) ? first + second : 1.0;
}

// (solid length, half length) of the tangent sphere's chord at a tap (CS-I, last paragraph): the sphere on
// the surface with half the radius.
glm::dvec2 tangent_chord(const SeenSurface& seen, const glm::dvec3& offset) {
    const glm::dvec3 center = 0.5 * seen.normal();
    const glm::dvec2 aside = glm::dvec2(offset) - glm::dvec2(center);
    const double squared = 0.25 - glm::dot(aside, aside);
    if (!(squared > 0.0)) return glm::dvec2(0.0);
    const double half_chord = std::sqrt(squared);
    return half_chord *
           glm::dvec2(std::clamp(place_on_chord(offset.z - center.z, half_chord), 0.0, 1.0), 1.0);
}

// Cosine of the angle between the eye, which is on the axis, and a sample; samples below the tangent plane
// are lifted onto it.
double cosine_to_eye(const glm::dvec3& offset, const glm::dvec3& normal) {
    const double length = glm::length(offset);
    if (length == 0.0) return 0.0;
    const glm::dvec3 direction = offset / length;
    const glm::dvec3 lifted = direction - std::min(glm::dot(direction, normal), 0.0) * normal;
    return glm::length(lifted) > 1e-5 ? lifted.z / glm::length(lifted) : 0.0;
}

}  // namespace

// CS-3.5: solid shares of chords, weighted by the chords' lengths. If a surface crosses a chord below 0.35 of
// its length or is in front of the ball, it belongs to another object. The complement of its partner then
// replaces it.
Integrand volumetric(const SeenSurface& seen, const Settings&) {
    return [seen](const std::array<double, 3>& u) {
        const double half_chord = std::sqrt(1.0 - std::min(u[0], 1.0));
        if (half_chord == 0.0) return glm::dvec2(0.0);
        return half_chord * glm::dvec2(solid_of(pair_at(seen, u), half_chord), 2.0);
    };
}

// The same ball and a ball of a quarter of the radius: the sum of the solid shares above one half in both.
Integrand volumetric_two(const SeenSurface& seen, const Settings&) {
    return [seen](const std::array<double, 3>& u) {
        const double half_chord = std::sqrt(1.0 - std::min(u[0], 1.0));
        if (half_chord == 0.0) return glm::dvec2(0.0);
        const double broad = solid_of(pair_at(seen, u), half_chord);
        const double fine = solid_of(pair_at(seen, u, 0.25), 0.25 * half_chord);
        return half_chord * glm::dvec2(broad + fine - 1.0, 2.0);
    };
}

// The sphere that touches the surface (Szirmay-Kalos et al. 2009).
Integrand tangent_sphere(const SeenSurface& seen, const Settings&) {
    return [seen](const std::array<double, 3>& u) {
        const Pair pair = pair_at(seen, u);
        return tangent_chord(seen, pair.aim + glm::dvec3(0, 0, pair.first)) +
               tangent_chord(seen, -pair.aim + glm::dvec3(0, 0, pair.second));
    };
}

// CS-P: 1 less the angles over pi. One sample of two that lies too near the eye is replaced by its partner's
// mirror image, at half the weight.
Integrand angle(const SeenSurface& seen, const Settings& s) {
    return [seen, range = double{s.own.range},
            bias = double{s.own.angle_bias}](const std::array<double, 3>& u) {
        const Pair pair = pair_at(seen, u);
        const glm::dvec3 first = pair.aim + glm::dvec3(0, 0, pair.first);
        const glm::dvec3 second = -pair.aim + glm::dvec3(0, 0, pair.second);
        const bool near_first = first.z <= range;
        const bool near_second = second.z <= range;
        if (!near_first && !near_second) return glm::dvec2(0.0);
        const auto mirrored = [](const glm::dvec3& v) { return std::clamp(-v.z / glm::length(v), 0.0, 1.0); };
        const double a = near_first ? cosine_to_eye(first, seen.normal()) : mirrored(second);
        const double b = near_second ? cosine_to_eye(second, seen.normal()) : mirrored(first);
        const double weight = near_first && near_second ? 1.0 : 0.5;
        const auto arc = [&](double cosine) { return std::acos(std::clamp(cosine - bias, -1.0, 1.0)); };
        return weight * glm::dvec2(1.0 - (arc(a) + arc(b)) / std::numbers::pi, 1.0);
    };
}

// CS-R: how far the Gaussian mean of the surroundings lies in front.
Integrand depth_darkening(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Pair pair = pair_at(seen, u);
        const double weight = std::exp(-2.0 * u[0]);
        const double range = double{s.own.range};
        const double mean =
            0.5 * (std::clamp(pair.first, -range, range) + std::clamp(pair.second, -range, range));
        return weight * glm::dvec2(double{s.own.intensity} * (mean - double{s.bias}), 1.0);
    };
}

}  // namespace gloam::effect::own
