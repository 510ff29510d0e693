// SPDX-License-Identifier: MIT
#pragma once

#include "reference/methods_discs.hpp"

// Methods of opposite taps: the solid part of balls, angles, the depth's unsharp mask; curvature by crosses.
namespace gloam::reference {

constexpr double nothing_behind = 1e4;  // radii at which background counts as a surface

// Height along the view vector of the surface seen at a place, moved along the tangent plane to that place.
inline double height_over(const ShadedPoint& at, dvec2 place, dvec3 surface) {
    const dvec3 aim(at.kernel.radius * place * at.upright, 0.0);
    return gloam_height_at(surface, aim, at.normal, max(dot(at.view, at.normal), 1e-4));
}
inline double seen_height(const ShadedPoint& at, dvec2 place) {
    const Tap tap = at.tap(at.under(place));
    const double behind = nothing_behind * at.kernel.radius - at.position.z;
    return height_over(at, place, tap.surface ? tap.offset : at.tap(tap.pixel, behind).offset);
}
// The surface seen at a place, there.
inline dvec3 moved_surface(const ShadedPoint& at, dvec2 place) {
    return dvec3(at.kernel.radius * place * at.upright, 0.0) + seen_height(at, place) * at.view;
}

// Sum of pair(place) = (occluded, whole) over pairs at a place and opposite to it.
template <class Pair>
GloamEstimate mean_of_pairs(const ShadedPoint& at, const Pair& pair) {
    dvec2 sum(0.0);
    for (unsigned i = 0; i < at.kernel.count; i += 2U)
        sum += pair(gloam_halton_disc((at.kernel.first + i) / 2U + 1U, gloam_sincos(at.kernel.angle)));
    return gloam_estimate(sum.x, sum.y, gloam_paired_samples(at.kernel.count));
}

// (solid, whole) of the chords of the ball at a pair.
inline dvec2 paired_chords(const ShadedPoint& at, dvec2 place) {
    const double half_chord = gloam_chord_half_height(place, at.kernel.radius);
    const dvec2 ratios(gloam_line_ratio(seen_height(at, place), half_chord),
                       gloam_line_ratio(seen_height(at, -place), half_chord));
    const dvec2 solid = gloam_line_pair(ratios, 0.35, 1.0);
    return half_chord * dvec2(solid.x + solid.y, 2.0);
}
inline GloamEstimate gloam_volumetric(const ShadedPoint& at) {
    return mean_of_pairs(at, [&](dvec2 place) { return paired_chords(at, place); });
}
inline GloamEstimate gloam_volumetric_two(const ShadedPoint& at) {
    return at_two_radii(at, gloam_whole_samples(at.kernel.count, 4U), 0.25, gloam_volumetric,
                        gloam_two_balls);
}
// Pairs of a spiral stand for rings, which are wider outside; half a turn moves each tap to its partner.
inline GloamEstimate gloam_volumetric_spiral(const ShadedPoint& at) {
    const unsigned samples = gloam_paired_samples(at.kernel.count);
    const int pairs = static_cast<int>(samples / 2U);
    const unsigned frame = at.kernel.first / std::max(samples, 1U);
    const double turn = pi * (2.0 * gloam_turns(at.kernel.angle) + gloam_radical_inverse(frame, 2U));
    dvec2 sum(0.0);
    for (int i = 0; i < pairs; ++i) {
        const dvec2 place = gloam_spiral_point(i, pairs, 7);
        sum += length(place) * paired_chords(at, gloam_rotate_disc(place, turn));
    }
    return gloam_estimate(sum.x, sum.y, samples);
}

// The ball of half the radius on the surface, by chords along the view vector, in its frame.
inline GloamEstimate gloam_tangent_sphere(const ShadedPoint& at) {
    return mean_of_pairs(at, [&](dvec2 place) {
        const dmat3 from_eye = transpose(gloam_tangent_frame(at.view));
        const dvec3 normal = from_eye * at.normal;
        dvec2 sum(0.0);
        for (const dvec2 tap : {place, -place}) {
            const dvec3 surface = from_eye * moved_surface(at, tap);
            const double chord = gloam_tangent_sphere_half_height(surface, normal, at.kernel.radius);
            sum += chord * dvec2(gloam_tangent_sphere_occlusion(surface, normal, at.kernel.radius), 1.0);
        }
        return sum;
    });
}

struct GloamAngle {
    double range;
    double angle_bias;
};
// What the angle between both taps lacks to half a turn.
inline GloamEstimate gloam_angle(const ShadedPoint& at, const GloamAngle& own) {
    return mean_of_pairs(at, [&](dvec2 place) {
        const dvec3 pair = gloam_angle_pair(moved_surface(at, place), moved_surface(at, -place), at.normal,
                                            at.view, own.range);
        const double angle =
            acos(clamp(pair.x - own.angle_bias, -1.0, 1.0)) + acos(clamp(pair.y - own.angle_bias, -1.0, 1.0));
        return pair.z * dvec2(1.0 - angle / pi, 1.0);
    });
}

struct GloamDepthDarkening {
    double range;
    double intensity;
};
inline GloamEstimate gloam_depth_darkening(const ShadedPoint& at, const GloamDepthDarkening& own) {
    return mean_of_pairs(at, [&](dvec2 place) {
        const auto height = [&](dvec2 tap) { return clamp(seen_height(at, tap), -own.range, own.range); };
        const double nearer = (height(place) + height(-place)) / 2.0 - at.kernel.bias;
        return gloam_gaussian(dot(place, place), 0.5) * dvec2(own.intensity * nearer / at.kernel.radius, 1.0);
    });
}

struct GloamCurvature {
    double range;
};
// The occlusion of the quadric that has the principal curvatures of a cross.
inline GloamEstimate gloam_curvature(const ShadedPoint& at, const GloamCurvature& own) {
    struct Change {
        dvec3 position{0.0};
        dvec3 normal{0.0};
    };
    const auto end = [&](dvec2 place) {
        const Tap tap = at.tap(at.under(place));
        const dvec3 facing = gloam_safe_normalize(at.images.normal(tap.pixel), dvec3(0.0));
        const bool known =
            tap.pixel != at.pixel && tap.surface && facing != dvec3(0.0) && length(tap.offset) <= own.range;
        return known ? Change{tap.offset, facing - at.normal} : Change{};
    };
    const auto across = [&](dvec2 arm) {
        const Change ahead = end(arm);
        const Change behind = end(-arm);
        return Change{ahead.position - behind.position, ahead.normal - behind.normal};
    };
    const unsigned samples = gloam_whole_samples(at.kernel.count, 4U);
    double sum = 0.0;
    for (unsigned i = 1; i <= samples / 4U; ++i) {
        const dvec3 random = gloam_halton_3d(at.kernel.first / 4U + i) + gloam_turns(at.kernel.angle);
        const dvec2 arm = (1.0 + fract(random.y)) / 2.0 * on_circle(pi / 2.0 * fract(random.x));
        const Change u = across(arm);
        const Change v = across({-arm.y, arm.x});
        const dvec2 curvatures = gloam_principal_curvatures(u.position, v.position, u.normal, v.normal);
        sum += gloam_occlusion_curvature(curvatures.x, curvatures.y, at.kernel.radius);
    }
    return gloam_estimate(sum, samples / 4U, samples);
}

}  // namespace gloam::reference
