// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/normal.hpp"
#include "reference/geometry/position.hpp"

namespace gloam::reference {

// fetch_depth: double(glm::ivec2), called for pixels inside the image only.
inline dvec3 gloam_position_from_depth(glm::ivec2 pixel, glm::ivec2 size, dvec2 p00_p11,
                                       const Fetch<double>& fetch_depth) {
    const bool inside = pixel.x >= 0 && pixel.x < size.x && pixel.y >= 0 && pixel.y < size.y;
    if (!inside) return dvec3(0.0);
    const double depth = fetch_depth(pixel);
    return gloam_view_position_perspective(gloam_ndc_from_pixel(pixel, size), depth, p00_p11);
}

inline dvec3 gloam_normal_from_depth(glm::ivec2 pixel, glm::ivec2 size, dvec2 p00_p11,
                                     const Fetch<double>& fetch_depth) {
    const glm::ivec2 at(max(min(pixel.x, size.x - 1), 0), max(min(pixel.y, size.y - 1), 0));
    const auto position = [&](int dx, int dy) {
        return gloam_position_from_depth(at + glm::ivec2(dx, dy), size, p00_p11, fetch_depth);
    };
    return gloam_normal_from_neighbors(position(0, 0), position(-1, 0), position(1, 0), position(0, -1),
                                       position(0, 1));
}

}  // namespace gloam::reference
