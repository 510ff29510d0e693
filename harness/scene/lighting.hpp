// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "scene/gbuffer.hpp"
#include "scene/scene.hpp"

namespace gloam::scene {

// Light that leaves the surfaces of a view towards the eye, split as an engine splits it: ambient light,
// which ambient occlusion darkens, and the direct light of one lamp, which it does not. Linear, 1 is white.
struct SplitLight {
    std::vector<glm::vec3> ambient;  // of a sky that nothing hides; 0 at the background
    std::vector<glm::vec3> direct;   // of the sun or lamp, its shadows traced; the sky at the background
};

struct LightingOptions {
    int frame = 0;         // of the scene
    int rays = 16;         // towards the sun or lamp from each pixel: its disc makes soft shadows
    unsigned threads = 0;  // 0: as many as the machine has
    std::function<void(double)> progress{};  // called with the part done, in [0, 1]
};

// The light of a view without its guard band: diffuse surfaces of GBuffer::color, or default_color. `scene`:
// what casts shadows, in the frame that the view shows; null: nothing does, and the sun shines. Normals that
// are missing come from the depth. The same bits for any number of threads. Throws std::invalid_argument for
// images whose size disagrees.
[[nodiscard]] SplitLight light_of(const GBuffer& view, const Scene* scene,
                                  const LightingOptions& options = {});

}  // namespace gloam::scene
