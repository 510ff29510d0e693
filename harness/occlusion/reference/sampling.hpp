// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "reference/geometry.hpp"

// Sequences, the points made of them, and how many are taken.
namespace gloam::reference {

inline double gloam_unit_interval(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, 0.0, 1.0);
}

// a_0 / b + a_1 / b^2 + ... of the digits a_m of the index.
inline double gloam_radical_inverse(unsigned index, unsigned base) {
    const unsigned b = std::clamp(base, 2U, 1U << 24U);
    double sum = 0.0;
    double place = 1.0;
    for (unsigned rest = index % (1U << 24U); rest > 0U; rest /= b) sum += rest % b * (place /= b);
    return sum;
}

inline double gloam_radical_inverse_base2(unsigned index) {
    return gloam_radical_inverse(index, 2U);
}

inline dvec3 gloam_halton_3d(unsigned index) {
    return {gloam_radical_inverse(index, 2U), gloam_radical_inverse(index, 3U),
            gloam_radical_inverse(index, 5U)};
}

inline dvec2 gloam_halton_2d(unsigned index) {
    return gloam_halton_3d(index);
}

inline dvec2 gloam_circle_point(double turn) {
    return on_circle(2.0 * pi * gloam_unit_interval(turn));
}

// The matrix of the rotation with that cosine and sine.
inline dvec2 gloam_turn_disc(dvec2 s, dvec2 turn) {
    return dmat2(turn.x, turn.y, -turn.y, turn.x) * s;
}

inline dvec3 gloam_turn_hemisphere(dvec3 s, dvec2 turn) {
    return {gloam_turn_disc(s, turn), s.z};
}

inline dvec2 gloam_rotate_disc(dvec2 s, double angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

inline dvec3 gloam_rotate_hemisphere(dvec3 s, double angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

inline dvec2 gloam_disc_sample(dvec2 zeta) {
    const double squared = gloam_unit_interval(zeta.y);
    return squared < float_min ? dvec2(0.0) : sqrt(squared) * gloam_sincos_turns(zeta.x);
}

inline dvec3 gloam_disc_point(unsigned index) {
    return {gloam_disc_sample(gloam_halton_2d(index)), 0.0};
}

inline dvec2 gloam_halton_disc(unsigned index, dvec2 turn) {
    return gloam_turn_disc(gloam_disc_sample(gloam_halton_2d(index)), turn);
}

inline dvec3 gloam_halton_point(unsigned index) {
    return gloam_halton_3d(index);
}

inline dvec3 gloam_hemisphere_cosine(dvec3 zeta) {
    const double squared = gloam_unit_interval(zeta.z);
    const double across = sqrt(1.0 - squared);
    return gloam_unit_interval(zeta.y) * dvec3(across * gloam_circle_point(zeta.x), sqrt(squared));
}

// By the angle off the normal, whose cosine is uniform.
inline dvec3 gloam_hemisphere_uniform(dvec3 zeta) {
    const double angle = acos(gloam_unit_interval(zeta.z));
    return gloam_unit_interval(zeta.y) * dvec3(sin(angle) * gloam_circle_point(zeta.x), cos(angle));
}

inline dvec3 gloam_hemisphere_cosine_point(unsigned index) {
    return gloam_hemisphere_cosine(gloam_halton_3d(index));
}

inline dvec3 gloam_hemisphere_uniform_point(unsigned index) {
    return gloam_hemisphere_uniform(gloam_halton_3d(index));
}

// Rodrigues' rotation of z onto n, 1 + K + K^2 / (1 + n.z) with K = (z x n) x; below the horizon of z that
// onto -n, with y negated to stay right-handed.
inline dmat3 gloam_tangent_frame(dvec3 n) {
    const double side = n.z < 0.0 ? -1.0 : 1.0;
    const dvec3 up = side * n;
    const dmat3 k(0.0, 0.0, -up.x, 0.0, 0.0, -up.y, up.x, up.y, 0.0);
    const dmat3 rotation = dmat3(1.0) + k + k * k / (1.0 + up.z);
    return {rotation[0], side * rotation[1], n};
}

// frac(10 h / (2 pi)) in units of 2^-32: the constant is frac(10 / (2 pi)) 2^64.
inline unsigned gloam_hash_turn(unsigned h) {
    return static_cast<unsigned>((h * 0x976FC893C3AA34E9ULL) >> 32U);
}

// The angle 10 h in radians, where h = (3 x) ^ (y + x y) in 32 bits, less whole turns: 2 pi as the sum of two
// doubles, so that 7e9 turns leave 1e-15 of error.
inline double gloam_hash_rotation(glm::ivec2 pixel) {
    const glm::uvec2 p(pixel);
    const double angle = 10.0 * ((3U * p.x) ^ (p.y + p.x * p.y));
    constexpr double two_pi = 2.0 * std::numbers::pi;
    constexpr double two_pi_rest = 2.4492935982947064e-16;
    const double turns = std::floor(angle / two_pi);
    const double within = std::fma(-turns, two_pi_rest, std::fma(-turns, two_pi, angle));
    return within < 0.0 ? within + two_pi : within;
}

// The golden ratio's powers as fractions of 32 bits.
inline double gloam_lattice_rotation(glm::ivec2 pixel) {
    const std::int64_t turns = std::int64_t{pixel.x} * 1'013'904'243 + std::int64_t{pixel.y} * 2'654'435'769;
    return 2.0 * std::numbers::pi * 0x1p-32 * static_cast<std::uint32_t>(turns);
}

inline dvec3 gloam_reflect_sample(dvec3 s, dvec3 encoded) {
    if (!(length(s) <= 1e19)) return dvec3(0.0);
    return glm::reflect(s, gloam_safe_normalize(2.0 * encoded - 1.0, dvec3(0.0)));
}

inline dvec3 gloam_hemisphere_flip(dvec3 s, dvec3 normal) {
    if (!(length(s) <= 1e19)) return dvec3(0.0);
    return dot(s, normal) > 0.0 ? s : -s;
}

inline bool gloam_poisson_accepts(dvec2 candidate, dvec2 other, double min_distance) {
    return distance(candidate, other) > min_distance;
}

inline dvec3 gloam_hemisphere_lift(dvec2 disc) {
    if (!is_finite(disc)) return {0.0, 0.0, 1.0};
    const double r = length(disc);
    return r < 1.0 ? dvec3(disc, sqrt(1.0 - r * r)) : dvec3(disc / r, 0.0);
}

// The points as the GLSL comment defines them: at each radius the angle farthest from the points before.
inline std::vector<dvec2> poisson_disc_points() {
    std::vector<dvec2> points;
    for (unsigned i = 0; i < 64U; ++i) {
        const double radius = sqrt(gloam_radical_inverse(i, 2U) + 0.5 / 64.0);
        double farthest = -1.0;
        dvec2 best(0.0);
        for (int a = 0; a < 4096; ++a) {
            const dvec2 candidate = radius * on_circle(2.0 * pi * a / 4096.0);
            double nearest = 4.0;
            for (const dvec2& p : points) nearest = min(nearest, dot(candidate - p, candidate - p));
            if (nearest <= farthest + 1e-9) continue;  // ties: the first angle
            farthest = nearest;
            best = candidate;
        }
        points.push_back(best);
    }
    return points;
}

inline dvec2 gloam_poisson_disc(unsigned index) {
    static const std::vector<dvec2> points = poisson_disc_points();
    return glm::vec2(glm::round(points[index % 64U] * 1e12) / 1e12);
}

// alpha (cos, sin)(2 pi alpha turns), alpha = (index + 1/2) / count; whole turns are taken off before 2 pi
// is.
inline dvec2 gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return dvec2(0.0);
    const double twice = 2.0 * index + 1.0;
    const double part = std::remainder(twice * turns, 2.0 * count);
    return (twice * on_circle(pi * part / count)) / (2.0 * count);
}

inline dvec2 gloam_issao_offset_polar(dvec2 e, double radius) {
    const double angle = 2.0 * pi * gloam_unit_interval(e.y);
    return radius * gloam_unit_interval(e.x) * dvec2(sin(angle), cos(angle));
}

// Beyond the disc: its nearest point.
inline dvec2 gloam_issao_offset_printed(dvec2 e, double radius) {
    const dvec2 u(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    const dvec2 printed(u.x * sin(2.0 * pi * u.y), u.y * cos(2.0 * pi * u.x));
    return radius * printed / max(length(printed), 1.0);
}

struct GloamSliceSample {
    dvec2 direction;
    double jitter;
    double share;
};

// Directions over half a turn; the kernel's angle shifts them and, 14-fold, the jitter.
inline GloamSliceSample gloam_slice_sample(unsigned index, double turns) {
    const dvec3 point = gloam_halton_3d(index);
    return {on_circle(pi * fract(point.x + turns)), fract(point.y + 14.0 * turns), point.z};
}

// From the end of the point's own pixel on, 0.4 of the way evenly and the rest by squares.
inline double gloam_slice_place(double share, double reach) {
    const double own = std::min(1.3 / reach, 1.0);
    return std::lerp(own, 1.0, 0.4 * share + 0.6 * share * share);
}

// The parabola through the first three places.
inline dvec3 gloam_slice_places(double jitter, double steps, double reach) {
    const auto place = [&](double k) { return gloam_slice_place((k + jitter) / steps, reach); };
    const double curve = 0.5 * (place(2.0) + place(0.0)) - place(1.0);
    return {place(0.0), place(1.0) - place(0.0) - curve, curve};
}

inline dvec3 gloam_eye_march(dvec3 position, dvec3 direction, double radius, unsigned index, unsigned count,
                             double jitter) {
    return position + direction * (radius * (index + jitter) / count);
}

inline unsigned gloam_whole_samples(unsigned count, unsigned unit) {
    const unsigned taps = std::max(unit, 1U);
    return std::max(count / taps, 1U) * taps;
}

inline unsigned gloam_paired_samples(unsigned count) {
    return count + count % 2U;
}

// max(floor(N / (1 + N d / z_far)), least); depths behind the far plane, and none, count as on it. A far
// plane beyond 2^126 is at infinity.
inline int gloam_count_by_distance(double depth, double z_far, int base, int least) {
    const double most = std::clamp(base, 0, 4096);
    const bool before = depth >= 0.0 && z_far >= float_min && depth < z_far;
    const double share = before ? (z_far <= 0x1p126 ? depth / z_far : 0.0) : 1.0;
    return std::max(int(most / (1.0 + most * share)), least);
}

// The nearest whole number to most r / r_ref.
inline int gloam_count_by_radius(double radius, double reference_radius, int least, int most) {
    if (!(reference_radius >= float_min) || radius >= reference_radius) return most;
    if (!(radius > 0.0)) return least;
    return std::clamp(int(most * (radius / reference_radius) + 0.5), least, most);
}

// How many of first, 2 first, 4 first... the distance reaches.
inline int gloam_depth_mip_level(double pixels, double first, int last) {
    int level = 0;
    for (int i = 0; i < std::min(last, 30) && first > 0.0; ++i)
        level += pixels >= std::ldexp(first, i) ? 1 : 0;
    return level;
}

inline glm::ivec2 gloam_depth_mip_size(glm::ivec2 size, int level) {
    return max(max(size, 1) / (1 << std::clamp(level, 0, 30)), 1);
}

inline glm::ivec2 gloam_depth_mip_pixel(glm::ivec2 tap, glm::ivec2 size, int level) {
    return clamp(tap >> std::clamp(level, 0, 30), glm::ivec2(0), gloam_depth_mip_size(size, level) - 1);
}

inline glm::ivec2 gloam_rotated_grid(glm::ivec2 pixel, glm::ivec2 size) {
    const glm::ivec2 source(2 * pixel.x + (pixel.y & 1), 2 * pixel.y + (pixel.x & 1));
    return clamp(source, glm::ivec2(0), max(size, 1) - 1);
}

// Each level takes from the one before.
inline glm::ivec2 gloam_depth_mip_source(glm::ivec2 pixel, glm::ivec2 size, int level) {
    if (level <= 0) return pixel;
    const int before = std::min(level, 30) - 1;
    return gloam_depth_mip_source(gloam_rotated_grid(pixel, gloam_depth_mip_size(size, before)), size,
                                  before);
}

inline constexpr int gloam_last_tap_level = 5;

inline glm::ivec2 gloam_tap_pixel(glm::ivec2 at, glm::ivec2 center, glm::ivec2 size, double mip_distance) {
    const glm::ivec2 apart = glm::abs(at - center);
    const int level = gloam_depth_mip_level(std::max(apart.x, apart.y), mip_distance, gloam_last_tap_level);
    return level == 0 ? at : gloam_depth_mip_source(gloam_depth_mip_pixel(at, size, level), size, level);
}

inline double gloam_level_depth(double stored, dvec2 numerator, dvec2 divisor, double far) {
    const double depth = dot(numerator, dvec2(1.0, stored)) / dot(divisor, dvec2(1.0, stored));
    return stored != far && depth > 0.0 ? min(depth, 65504.0) : 65504.0;
}

inline double gloam_depth_level(double pixels) {
    return std::log2(pixels) - 4.3;
}

inline bool gloam_is_level_middle(glm::ivec2 block, int level) {
    const int texel = 1 << (level - 1);
    return block % texel == glm::ivec2(texel / 2);
}

}  // namespace gloam::reference
