// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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
    unsigned threads = 0;                                        // 0: as many as the machine has
    std::function<void(double)> progress;                        // called with the part done, in [0, 1]
};

// Traced occlusion, rows from the top; 0 at the background. The same bits for any number of threads.
struct TracedTruth {
    std::vector<float> occlusion;       // in [0, 1], 1 where blocked
    std::vector<float> standard_error;  // of it
    std::uint64_t rays = 0;             // for each pixel with geometry
    std::uint64_t pixels = 0;           // with geometry
    std::uint64_t unmatched = 0;        // of them, those whose surface the geometry does not have there
};

// (G): the occlusion that the whole geometry of a scene makes in a frame, at the points that a G-buffer of
// that frame shows. The G-buffer says which surface a pixel sees, by its depth, and around which normal its
// hemisphere is, for that is what every estimator is given; the geometry says where the surface exactly lies:
// the point is moved along the view ray onto the triangle that it is within a thousandth of, and that is not
// turned away from the normal. Where there is none, on rays up to a hundredth of a pixel around the centre
// and within a thirtieth, it is taken as it is. Throws std::invalid_argument for settings out of range, a
// scene that validate() refuses and images whose size disagrees.
[[nodiscard]] TracedTruth trace_geometry(const Scene& scene, int frame, const GBuffer& view,
                                         const TruthSettings& settings);

// (D): the occlusion that the depth buffer alone can tell of: the surface of depth_field() at its own
// vertices, the normals as there. Throws std::invalid_argument like depth_field() and for settings out of
// range.
[[nodiscard]] TracedTruth trace_depth(const GBuffer& view, const TruthSettings& settings);

}  // namespace gloam::scene
