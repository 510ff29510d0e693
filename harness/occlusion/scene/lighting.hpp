// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/mesh.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// Light that leaves the surfaces of a view towards the eye, split as in an engine: ambient light, which
// ambient occlusion darkens, and the direct light of one lamp, which it does not. Linear, 1 is white.
struct SplitLight {
    std::vector<glm::vec3> ambient;  // of an unoccluded sky; 0 at the background
    std::vector<glm::vec3> direct;   // of the sun or lamp, shadows traced; the sky at the background
};

struct LightingOptions {
    int frame = 0;         // of the scene
    int rays = 16;         // towards the sun or lamp from each pixel: its disc causes soft shadows
    unsigned threads = 0;  // 0: one for each processor
    std::function<void(double)> progress{};  // called with the completed part, in [0, 1]
};

// The light of a view without its guard band: diffuse surfaces with GBuffer::color, or default_color.
// `scene`: the scene that casts shadows, in the frame that the view shows; nullptr: no shadows, light of the
// sun. Missing normals are reconstructed from depth. Bit-identical for any number of threads. Throws
// std::invalid_argument for images of another size.
[[nodiscard]] SplitLight light_of(const GBuffer& view, const Scene* scene,
                                  const LightingOptions& options = {});

// A depth buffer as a surface in view space: one vertex at the centre of each pixel, in the order of the
// pixels, and two triangles between four pixels with geometry. Nothing is connected to the background.
//
// thickness: assumed thickness behind the surface, world units, > 0. +infinity: solid, so the surface is the
// height field of the depth buffer, and neighbours are connected over any jump of depth. Finite: the surface
// ends at a larger jump, unless the jump continues a slope (1 / depth is linear over a plane).
//
// normals: one for each pixel. They are the view's own; if it has none, they follow from the surface, from
// the nearer neighbour on each axis. Background 0. Throws std::invalid_argument for images of another size, a
// view without geometry, and a thickness that is not > 0.
[[nodiscard]] Mesh depth_field(const GBuffer& view,
                               double thickness = std::numeric_limits<double>::infinity());

}  // namespace gloam::scene
