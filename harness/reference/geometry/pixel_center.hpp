// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_nearest_index(T u, int resolution) {
    const int last = max(resolution, 1) - 1;
    const T scaled = u * T(resolution);
    return scaled >= T(1) ? (scaled < T(last) ? to_int(scaled) : last) : 0;
}

template <class T>
glm::ivec2 gloam_nearest_pixel(vec2<T> uv, glm::ivec2 resolution) {
    return glm::ivec2(gloam_nearest_index(uv.x, resolution.x), gloam_nearest_index(uv.y, resolution.y));
}

template <class T>
vec2<T> gloam_pixel_center(vec2<T> uv, glm::ivec2 resolution) {
    const glm::ivec2 size(max(resolution.x, 1), max(resolution.y, 1));
    const glm::ivec2 pixel = gloam_nearest_pixel(uv, size);
    return vec2<T>((T(pixel.x) + T(0.5)) / T(size.x), (T(pixel.y) + T(0.5)) / T(size.y));
}

template <class T>
bool gloam_inside_unit(vec2<T> uv) {
    return uv.x >= T(0) && uv.x <= T(1) && uv.y >= T(0) && uv.y <= T(1);
}

}  // namespace gloam::reference
