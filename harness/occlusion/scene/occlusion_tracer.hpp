// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "base/hidden.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// Weight of a blocker by its distance.
enum class Falloff {
    linear,     // 1 - d / R
    quadratic,  // 1 - d^2 / R^2
    step,       // 1 up to R
};

// The weight in [0, 1] of a blocker at `distance` (>= 0) for a radius > 0 (the same unit); 0 beyond the
// radius.
[[nodiscard]] double falloff_weight(Falloff falloff, double distance, double radius);

// "linear", "quadratic", "step", and back.
[[nodiscard]] const char* name_of(Falloff falloff);
[[nodiscard]] std::optional<Falloff> falloff_named(std::string_view name);

// The weight of the hemisphere's directions.
enum class Weighting {
    cosine,   // by the cosine to the normal: TSSAO-1
    uniform,  // the same for all directions
};

struct RaySettings {
    double radius = 0.5;  // world units, > 0; +infinity allowed with Falloff::step
    Falloff falloff = Falloff::linear;
    int rays = 1024;  // for each point, 32 to 2^24; rounded up to a multiple of 16, best a power of two
    Weighting weighting = Weighting::cosine;
};

// Throws std::invalid_argument that names the first setting out of range.
void validate(const RaySettings& settings);

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
    // Takes the triangles of a mesh; its normals are not used. Coordinates are single precision, which is
    // most exact near the origin. Throws std::invalid_argument for settings out of range, no triangles,
    // indices out of range and positions that are not finite.
    OcclusionTracer(Mesh mesh, const RaySettings& settings);

    // Number of rays of an estimate.
    [[nodiscard]] std::size_t rays() const;

    // The estimate for one point; each seed gives another scrambling of the directions.
    [[nodiscard]] OcclusionEstimate occlusion(const Receiver& receiver, std::uint64_t seed) const;

    // The first surface between the distances `near` and `far` from an origin along a unit direction, as a
    // receiver on that side: the point in double on its triangle; both normals are the triangle's own.
    [[nodiscard]] std::optional<Receiver> surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                  double near, double far) const;

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::scene
