// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/borders.hpp"
#include "reference/geometry/normal.hpp"
#include "reference/geometry/position.hpp"

namespace gloam::reference {

// fetch_depth: called for pixels inside the image only.
inline dvec3 gloam_position_from_depth(glm::ivec2 pixel, glm::ivec2 size, dvec2 p00_p11,
                                       const Fetch<double>& fetch_depth) {
    if (pixel != clamp(pixel, glm::ivec2(0), size - 1)) return dvec3(0.0);
    return gloam_view_position_perspective(gloam_ndc_from_pixel(pixel, size), fetch_depth(pixel), p00_p11);
}

inline dvec3 gloam_normal_from_depth(glm::ivec2 pixel, glm::ivec2 size, dvec2 p00_p11,
                                     const Fetch<double>& fetch_depth) {
    const auto position = [&](int x, int y) {
        const glm::ivec2 at = gloam_clamp_to_edge(pixel, size) + glm::ivec2(x, y);
        return gloam_position_from_depth(at, size, p00_p11, fetch_depth);
    };
    return gloam_normal_from_neighbors(position(0, 0), position(-1, 0), position(1, 0), position(0, -1),
                                       position(0, 1));
}

}  // namespace gloam::reference
