// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_nearest_index(T u, int resolution) {
    if (resolution < 1) return 0;
    if (u >= T(1)) return resolution - 1;
    if (u > T(0)) return to_int(floor(u * T(resolution)));
    return 0;
}

template <class T>
glm::ivec2 gloam_nearest_pixel(vec2<T> uv, glm::ivec2 resolution) {
    return glm::ivec2(gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y));
}

template <class T>
vec2<T> gloam_pixel_center(vec2<T> uv, glm::ivec2 resolution) {
    const auto axis = [](T u, int extent) {
        const int pixels = extent < 1 ? 1 : extent;
        return (T(gloam_nearest_index(u, pixels)) + T(0.5)) / T(pixels);
    };
    return vec2<T>(axis(uv.x, resolution.x), axis(uv.y, resolution.y));
}

template <class T>
bool gloam_inside_unit(vec2<T> uv) {
    return uv.x >= T(0) && uv.y >= T(0) && uv.x <= T(1) && uv.y <= T(1);
}

}  // namespace gloam::reference
