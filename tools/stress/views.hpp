// SPDX-License-Identifier: MIT
#pragma once

#include <cfloat>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/gbuffer.hpp"

namespace gloam::stress {

// A wall across the whole view, at depth 3 along the axis. slope: by how much it recedes to the right.
[[nodiscard]] inline scene::GBuffer wall(gpu::Extent extent, double slope = 0.0) {
    scene::GBuffer view{.extent = extent};
    view.camera =
        scene::make_frame({}, static_cast<double>(extent.width) / static_cast<double>(extent.height));
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    view.normal.assign(pixels, glm::vec3(glm::normalize(glm::dvec3(slope, 0.0, 1.0))));
    for (std::size_t i = 0; i < pixels; ++i)
        view.depth.push_back(
            static_cast<float>(3.0 / (1.0 - slope * scene::PixelPositions(view).at(i, 1.0).x)));
    return view;
}

// NaN, infinities, negative, zero, subnormal (the least and the largest), tiny and huge.
inline constexpr float bad_values[]{NAN,    -NAN,  INFINITY,     -INFINITY,       0.0F,
                                    -0.0F,  -1.0F, FLT_TRUE_MIN, 1.17549421e-38F, FLT_MIN,
                                    1e-20F, 1e20F, -1e20F,       FLT_MAX,         -FLT_MAX};

}  // namespace gloam::stress
