// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "base/hidden.hpp"

namespace gloam::scene {

// The first triangle along a ray.
struct RayHit {
    std::uint32_t triangle = 0;
    float distance = 0.0F;
};

// Where a ray meets the first triangle, in double.
struct RaySurface {
    std::uint32_t triangle = 0;
    double distance = 0.0;  // along the ray, in units of its direction; on the triangle's plane
    double found = 0.0;     // the same before it was made exact: a ray from behind it does not meet it again
    glm::dvec3 facet{0};    // unit: the triangle's normal, against the ray
    glm::dvec3 weights{0};  // of the triangle's corners; their sum is 1
};

// Triangles for ray tracing; the only user of Embree. Every triangle blocks on both sides. Thread-safe.
class RayScene {
  public:
    // Throws std::invalid_argument if there are no triangles, an index is out of range or a position is not
    // finite; std::runtime_error if Embree fails.
    RayScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices);

    [[nodiscard]] const std::vector<glm::vec3>& positions() const { return positions_; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

    // The first triangle between the distances `near` and `far` along a direction, in units of its length.
    // It traces one ray at a time; for rays that diverge from a point this is 1.5 times as fast as packets of
    // 16.
    [[nodiscard]] std::optional<RayHit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                  float near, float far) const;

    // The same as a point on the triangle. nullopt also for a triangle without area.
    [[nodiscard]] std::optional<RaySurface> surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                    double near, double far) const;

    // The corners of a triangle, in double.
    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::uint32_t triangle) const;

  private:
    struct Impl;
    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> indices_;
    base::Hidden<Impl> impl_;
};

[[nodiscard]] inline double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// Well-mixed bits of a number, the same on every machine (the finaliser of SplitMix64).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

// The first points of the two-dimensional Sobol' sequence, with a new scrambling for each use.
class SobolPoints {
  public:
    explicit SobolPoints(std::size_t count);

    [[nodiscard]] std::size_t size() const { return reversed_.size(); }

    // Point `index` in (0, 1)^2 with the scrambling `seed`. Scramblings of different seeds are independent,
    // each point is uniform, and the points of one seed keep the strata of the sequence: nested uniform
    // scrambling (Owen), with the hash of Laine and Karras.
    [[nodiscard]] glm::dvec2 scrambled(std::size_t index, std::uint64_t seed) const;

  private:
    struct Bits {
        std::uint32_t x;
        std::uint32_t y;
    };
    std::vector<Bits> reversed_;  // the coordinates' 32 bits, least significant first
};

}  // namespace gloam::scene
