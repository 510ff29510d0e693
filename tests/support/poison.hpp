// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <iterator>

#include "scene/gbuffer.hpp"

namespace gloam::test {

// Writes what is no depth to every seventh pixel, and what is no normal to every eleventh.
inline void poison(scene::GBuffer& view) {
    constexpr float values[] = {NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e30F};
    for (std::size_t i = 0; i < view.depth.size(); i += 7) view.depth[i] = values[i % std::size(values)];
    for (std::size_t i = 0; i < view.normal.size(); i += 11) view.normal[i] = glm::vec3(values[i % 4]);
}

}  // namespace gloam::test
