// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/occlusion_tracer.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

struct TruthSettings {
    RaySettings rays;
    double thickness = std::numeric_limits<double>::infinity();  // trace_depth(): as in depth_field()
    unsigned threads = 0;                                        // 0: one for each processor
    std::function<void(double)> progress;                        // called with the completed part, in [0, 1]
};

// Traced occlusion, rows from the top; 0 at the background. Bit-identical for any number of threads.
struct TracedTruth {
    std::vector<float> occlusion;       // in [0, 1], 1 where blocked
    std::vector<float> standard_error;  // of it
    std::uint64_t rays = 0;             // for each pixel with geometry
    std::uint64_t pixels = 0;           // with geometry
    std::uint64_t unmatched = 0;        // of these, pixels whose surface was not found in the geometry
};

// (G), geometry truth: the occlusion by the whole geometry of a scene in a frame, at the points that a
// G-buffer of that frame shows. The G-buffer's depth determines the visible surface, and its normal the
// hemisphere, because every estimator gets these. The geometry determines the exact position: the point is
// moved along the view ray onto the triangle within a thousandth of its distance. A triangle that faces away
// from the normal has its own. If there is none, the point stays as it is. Throws std::invalid_argument for
// settings out of range, a scene that validate() rejects and images of another size.
[[nodiscard]] TracedTruth trace_geometry(const Scene& scene, int frame, const GBuffer& view,
                                         const TruthSettings& settings);

// (D), depth truth: the occlusion by the surface that the depth buffer shows. It is traced from the vertices
// of depth_field(), with its normals. Throws std::invalid_argument like depth_field() and for settings out of
// range.
[[nodiscard]] TracedTruth trace_depth(const GBuffer& view, const TruthSettings& settings);

// A folder of traced truth, keyed by a hash of everything that the truth depends on: triangles as the frame's
// camera sees them, depth, normals, projection, settings. A damaged or truncated file counts as missing. A
// file that cannot be written is ignored.
class TruthCache {
  public:
    // folder: created if it is missing; empty: no cache.
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // Like trace_geometry() and trace_depth(), from the cache if possible. They throw like those.
    [[nodiscard]] TracedTruth geometry(const Scene& scene, int frame, const GBuffer& view,
                                       const TruthSettings& settings) const;
    [[nodiscard]] TracedTruth depth(const GBuffer& view, const TruthSettings& settings) const;

    // (G) at the same surface points in the frame before, with the same rays: its difference from geometry()
    // is what the motion of objects changed, without noise. Needs frame > 0 and GBuffer::object.
    [[nodiscard]] std::vector<float> before(const Scene& scene, int frame, const GBuffer& view,
                                            const TruthSettings& settings) const;

  private:
    std::filesystem::path folder_;
};

}  // namespace gloam::scene
