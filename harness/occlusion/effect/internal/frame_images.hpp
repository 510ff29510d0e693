// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

[[nodiscard]] std::size_t pixels_of(gpu::Extent extent);

// One channel of an image of four: element `which` of each texel.
[[nodiscard]] std::vector<float> channel(std::span<const float> texels, std::size_t which);

// Format of the images that hold what is displayed.
[[nodiscard]] gpu::Format format_of(OutputFormat output);

// A history image, by channel.
struct HistoryTexels {
    std::vector<float> occlusion;
    std::vector<float> samples;  // accumulated
};
[[nodiscard]] HistoryTexels history_in(const gpu::Image& image);

// The texels (x, y, z, 0) of an image of four channels, and back.
using scene::vectors_of;
[[nodiscard]] inline std::vector<float> texels_of(std::span<const glm::vec3> vectors) {
    std::vector<float> texels;
    texels.reserve(4 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z, 0.0F});
    return texels;
}

}  // namespace gloam::effect
