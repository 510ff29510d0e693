// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// A depth buffer as a surface in view space: one vertex at the centre of each pixel, in the order of the
// pixels, and two triangles between four pixels with geometry. Nothing is connected to the background.
//
// thickness: assumed thickness behind the surface, world units, > 0. +infinity: solid, so the surface is the
// height field of the depth buffer, and neighbours are connected over any jump of depth. Finite: the surface
// ends at a larger jump, unless the jump continues a slope (1 / depth is linear over a plane).
//
// normals: one for each pixel. They are the view's own; if it has none, they follow from the surface, from
// the nearer neighbour on each axis. Background 0. Throws std::invalid_argument for a view without
// geometry.
[[nodiscard]] Mesh depth_field(const GBuffer& view,
                               double thickness = std::numeric_limits<double>::infinity());

// Weight of a blocker by its distance.
enum class Falloff {
    linear,     // 1 - d / R
    quadratic,  // 1 - d^2 / R^2
    step,       // 1 up to R
};

// Of "linear", "quadratic" or "step".
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

struct TruthSettings {
    RaySettings rays;
    double thickness = std::numeric_limits<double>::infinity();  // trace_depth(): as in depth_field()
    std::function<void(double)> progress;                        // called with the completed part, in [0, 1]
    // Folder of traced truth, by a hash of everything that the truth depends on: triangles as the frame's
    // camera sees them, depth, normals, projection, settings. It is created if it is missing. A damaged or
    // truncated file counts as missing, one that cannot be written is ignored. Empty: none.
    std::filesystem::path cache{};
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
// settings out of range.
[[nodiscard]] TracedTruth trace_geometry(const Scene& scene, int frame, const GBuffer& view,
                                         const TruthSettings& settings);

// (D), depth truth: the occlusion by the surface that the depth buffer shows. It is traced from the vertices
// of depth_field(), with its normals. Throws std::invalid_argument like depth_field() and for settings out of
// range.
[[nodiscard]] TracedTruth trace_depth(const GBuffer& view, const TruthSettings& settings);

// (G) at the same surface points in the frame before, with the same rays: its difference from
// trace_geometry() is what the motion of objects changed, without noise. Needs frame > 0 and GBuffer::object.
[[nodiscard]] std::vector<float> trace_before(const Scene& scene, int frame, const GBuffer& view,
                                              const TruthSettings& settings);

}  // namespace gloam::scene
