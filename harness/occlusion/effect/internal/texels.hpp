// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

// Conversion of vectors to the texels of an image of four channels, and back.
namespace gloam::effect {

// Texels (x, y, z, 0).
[[nodiscard]] inline std::vector<float> texels_of(std::span<const glm::vec3> vectors) {
    std::vector<float> texels;
    texels.reserve(4 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z, 0.0F});
    return texels;
}

// The first three channels of each texel.
[[nodiscard]] inline std::vector<glm::vec3> vectors_of(const std::vector<float>& texels) {
    std::vector<glm::vec3> vectors(texels.size() / 4);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        vectors[i] = {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]};
    return vectors;
}

}  // namespace gloam::effect
