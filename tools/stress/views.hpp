// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <limits>
#include <vector>

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

// NaN, infinities, negative, zero, subnormal, tiny and huge.
[[nodiscard]] inline const std::vector<float>& bad_values() {
    using Limits = std::numeric_limits<float>;
    constexpr float nan = Limits::quiet_NaN();
    constexpr float inf = Limits::infinity();
    constexpr float largest_subnormal = 1.17549421e-38F;
    static const std::vector<float> all{nan,
                                        -nan,
                                        inf,
                                        -inf,
                                        0.0F,
                                        -0.0F,
                                        -1.0F,
                                        Limits::denorm_min(),
                                        largest_subnormal,
                                        Limits::min(),
                                        1e-20F,
                                        1e20F,
                                        -1e20F,
                                        Limits::max(),
                                        Limits::lowest()};
    return all;
}

}  // namespace gloam::stress
