// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "scene/mesh.hpp"
#include "scene/truth.hpp"

struct RTCDeviceTy;
struct RTCSceneTy;

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
    glm::dvec3 facet{0};    // unit: the triangle's normal, against the ray
    glm::dvec3 weights{0};  // of the triangle's corners; their sum is 1
    double reach = 0.0;     // the largest coordinate there or of a side: corners are rounded to 2^-24 of it
};

// Triangles for ray tracing; the only user of Embree. Every triangle blocks on both sides. Thread-safe.
class RayScene {
  public:
    // The triangles of a mesh with triangles; its normals are not used.
    // Throws std::runtime_error if Embree fails.
    explicit RayScene(const Mesh& mesh);

    // The first triangle between the distances `near` and `far` along a direction, in units of its length.
    // It traces one ray at a time; for rays that diverge from a point this is 1.5 times as fast as packets of
    // 16.
    [[nodiscard]] std::optional<RayHit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                  float near, float far) const;

    // The same as a point on the triangle. nullopt also for a triangle without area.
    [[nodiscard]] std::optional<RaySurface> surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                    double near, double far) const;

    // All of them, nearest first.
    [[nodiscard]] std::vector<RaySurface> surfaces(const glm::dvec3& origin, const glm::dvec3& direction,
                                                   double near, double far) const;

  private:
    [[nodiscard]] std::optional<RaySurface> surface_of(const RayHit& hit, const glm::dvec3& origin,
                                                       const glm::dvec3& direction) const;

    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> indices_;
    std::shared_ptr<RTCDeviceTy> device_;
    std::shared_ptr<RTCSceneTy> scene_;
};

[[nodiscard]] inline double largest(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// A point whose occlusion is estimated.
struct Receiver {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 0, 1};  // unit: the hemisphere is around it
    glm::dvec3 facet{0, 0, 1};  // unit: normal of the triangle that contains the point, on the receiving side
    double clearance = 0.0;     // world units: rays start this far from the triangle
};

struct OcclusionEstimate {
    double occlusion = 0.0;       // in [0, 1]
    double standard_error = 0.0;  // of it, from 16 independent parts; with Falloff::step 1 / rays at least
};

// Estimates the occlusion of points by tracing rays:
//   (1 / pi) * integral over the hemisphere of V(w) D(d(w)) (n . w) dw
// Here V = 1 where the ray is blocked at the distance d. With Weighting::uniform the factor is 1 / (2 pi),
// without (n . w). Directions are points of Sobol' sequences of that density. The rays are divided into 16
// equal parts, each with its own scrambling; the means of the parts give the standard error (15 degrees of
// freedom). Thread-safe.
//
// A direction can leave through the back of the triangle on which it starts, because a smooth normal differs
// from the facet's. It is then mirrored at the triangle, so that the facets of a smooth shape do not occlude
// themselves.
class OcclusionTracer {
  public:
    // Coordinates are single precision, which is most exact near the origin. Throws std::invalid_argument for
    // settings out of range.
    OcclusionTracer(const Mesh& mesh, const RaySettings& settings);

    // Number of rays of an estimate.
    [[nodiscard]] std::size_t rays() const;

    // The estimate for one point; each seed gives another scrambling of the directions.
    [[nodiscard]] OcclusionEstimate occlusion(const Receiver& receiver, std::uint64_t seed) const;

    // The first surface between the distances `near` and `far` from an origin along a unit direction, as a
    // receiver on that side: the point in double on its triangle; both normals are the triangle's own.
    [[nodiscard]] std::optional<Receiver> surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                  double near, double far) const;

  private:
    // The mean weight over the rays of one part.
    [[nodiscard]] double part_mean(const Receiver& receiver, std::uint64_t seed) const;

    RaySettings settings_;
    std::vector<glm::uvec2> points_;  // of the Sobol' sequence, bits of coordinates least significant first
    RayScene scene_;
};

}  // namespace gloam::scene
