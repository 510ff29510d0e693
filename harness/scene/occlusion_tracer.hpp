// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "scene/falloff.hpp"
#include "scene/mesh.hpp"

namespace gloam::scene {

// How the directions of the hemisphere count.
enum class Weighting {
    cosine,   // by the cosine to the normal: TSSAO-1
    uniform,  // all alike
};

struct RaySettings {
    double radius = 0.5;  // world units, > 0; +infinity allowed with Falloff::step
    Falloff falloff = Falloff::linear;
    int rays = 1024;  // for each point, 32 to 2^24; rounded up to a multiple of 16, best a power of two
    Weighting weighting = Weighting::cosine;
};

// Throws std::invalid_argument that names the first setting outside its range.
void validate(const RaySettings& settings);

// A point that receives light.
struct Receiver {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 0, 1};  // unit: the hemisphere is around it
    glm::dvec3 facet{0, 0, 1};   // unit: of the triangle that the point lies on, on the side that is lit
    double clearance = 0.0;      // world units: rays start this far from the triangle
};

struct OcclusionEstimate {
    double occlusion = 0.0;       // in [0, 1]
    double standard_error = 0.0;  // of it, from 16 independent parts; with Falloff::step 1 / rays at least
};

// Estimates the occlusion of points by tracing rays:
// (1 / pi) * integral over the hemisphere of V(w) D(d(w)) (n . w) dw, with V = 1 where the ray is blocked at
// the distance d; 1 / (2 pi) and without (n . w) where all directions count alike. Directions are points of
// Sobol' sequences of that weight. The rays are divided into 16 equal parts, each with its own scrambling;
// the means of the parts give the standard error (15 degrees of freedom). Several threads may use it at once.
//
// A direction may leave through the back of the triangle it starts on, because a smooth normal is not the
// facet's. It is mirrored at the triangle, so that the facets of a smooth shape do not shade themselves.
class OcclusionTracer {
  public:
    // The triangles of a mesh; its normals are not used. Coordinates are single precision: best near the
    // origin. Throws std::invalid_argument for settings out of range, no triangles, indices that do not fit
    // or positions that are not finite.
    OcclusionTracer(Mesh mesh, const RaySettings& settings);
    ~OcclusionTracer();
    OcclusionTracer(OcclusionTracer&&) noexcept;
    OcclusionTracer& operator=(OcclusionTracer&&) noexcept;

    // How many rays an estimate takes.
    [[nodiscard]] std::size_t rays() const;

    // The estimate for one point; each seed scrambles the directions in its own way.
    [[nodiscard]] OcclusionEstimate occlusion(const Receiver& receiver, std::uint64_t seed) const;

    // The first surface between the distances `near` and `far` from an origin along a unit direction, lit
    // from that side: the point in double on its triangle, both normals the triangle's own.
    [[nodiscard]] std::optional<Receiver> surface(const glm::dvec3& origin, const glm::dvec3& direction,
                                                  double near, double far) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::scene
