// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "interpreter/internal/cube.hpp"

namespace gloam::interpreter::internal {
namespace {

using numeric::Bounds;

// An axis of space, and a sign.
struct Direction {
    std::size_t axis;
    double sign;
};
struct Face {
    Direction major;
    Direction s;
    Direction t;
};
constexpr std::array<Face, 6> faces{{{{0, 1}, {2, -1}, {1, -1}},
                                     {{0, -1}, {2, 1}, {1, -1}},
                                     {{1, 1}, {0, 1}, {2, 1}},
                                     {{1, -1}, {0, 1}, {2, -1}},
                                     {{2, 1}, {0, 1}, {1, -1}},
                                     {{2, -1}, {0, -1}, {1, -1}}}};

Bounds magnitude(const Bounds& x) {
    const double least = x.low <= 0.0 && x.high >= 0.0 ? 0.0 : std::min(std::abs(x.low), std::abs(x.high));
    return {least, std::max(std::abs(x.low), std::abs(x.high)), x.nan};
}

Bounds times(const Bounds& a, const Bounds& b) {
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high, a.nan || b.nan};
}

Bounds along(const Direction& direction, const Bounds& x) {
    return times(Bounds::point(direction.sign), x);
}

// A coordinate divided by the largest magnitude; -1 to 1.
Bounds quotient(const Bounds& x, const Bounds& major) {
    if (major.low == 0.0) return {-1.0, 1.0, x.nan || major.nan};
    const Bounds all = times(x, {1.0 / major.high, 1.0 / major.low, major.nan});
    return {std::clamp(all.low, -1.0, 1.0), std::clamp(all.high, -1.0, 1.0), all.nan};
}

}  // namespace

std::vector<FacePoint> faces_of(const std::array<Bounds, 4>& direction, double error) {
    double least = 0.0;  // that the largest magnitude may have
    for (std::size_t axis = 0; axis < 3; ++axis) least = std::max(least, magnitude(direction.at(axis)).low);
    std::vector<FacePoint> all;
    for (const std::uint32_t face : {4U, 5U, 2U, 3U, 0U, 1U}) {
        const auto& [major, s, t] = faces.at(face);
        const Bounds size = magnitude(direction.at(major.axis));
        const bool other_side = along(major, direction.at(major.axis)).high < 0.0;
        if (other_side || size.high * (1.0 + error) < least) continue;
        const Bounds divisor{std::max(size.low, least / (1.0 + error)), std::max(size.high, least), size.nan};
        all.push_back({.face = face,
                       .quotients = {quotient(along(s, direction.at(s.axis)), divisor),
                                     quotient(along(t, direction.at(t.axis)), divisor)},
                       .major = divisor});
        if (error == 0.0) break;
    }
    return all;
}

std::array<Bounds, 2> slope_on(const FacePoint& on, const std::array<Bounds, 3>& change) {
    const auto& [major, s, t] = faces.at(on.face);
    const Bounds deeper = along(major, change.at(major.axis));
    const auto slope = [&](const Direction& direction, const Bounds& at) -> Bounds {
        const Bounds sideways = along(direction, change.at(direction.axis));
        const Bounds back = times(at, deeper);
        Bounds all = times({sideways.low - back.high, sideways.high - back.low, sideways.nan || back.nan},
                           {0.5 / on.major.high, 0.5 / on.major.low, on.major.nan});
        all.nan = all.nan || !std::isfinite(all.low) || !std::isfinite(all.high);
        return all;
    };
    return {slope(s, on.quotients[0]), slope(t, on.quotients[1])};
}

std::optional<FaceTexel> folded(const FaceTexel& texel, long size) {
    const auto is_outside = [size](long i) { return i < 0 || i >= size; };
    if (!is_outside(texel.x) && !is_outside(texel.y)) return texel;
    if (is_outside(texel.x) && is_outside(texel.y)) return std::nullopt;
    const auto& [major, s, t] = faces.at(texel.face);
    const auto middle = [size](long i) {
        return (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(size) - 1.0;
    };
    // The middle of the texel, folded at the edge; exact enough to be within its texel.
    std::array<double, 3> point{};
    point.at(s.axis) = s.sign * std::clamp(middle(texel.x), -1.0, 1.0);
    point.at(t.axis) = t.sign * std::clamp(middle(texel.y), -1.0, 1.0);
    point.at(major.axis) = major.sign * (1.0 - 1.0 / static_cast<double>(size));
    const Direction& beyond = is_outside(texel.x) ? s : t;
    const auto other = static_cast<std::uint32_t>(2 * beyond.axis + (point.at(beyond.axis) < 0.0 ? 1 : 0));
    const auto place = [&](const Direction& direction) {
        const double at = (direction.sign * point.at(direction.axis) + 1.0) / 2.0;
        return std::clamp(static_cast<long>(std::floor(at * static_cast<double>(size))), 0L, size - 1);
    };
    return FaceTexel{other, place(faces.at(other).s), place(faces.at(other).t)};
}

}  // namespace gloam::interpreter::internal
