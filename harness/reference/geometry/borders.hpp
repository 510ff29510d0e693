// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T = double>
glm::ivec2 gloam_clamp_to_edge(glm::ivec2 pixel, glm::ivec2 size) {
    return glm::ivec2(clamp(pixel.x, 0, max(size.x, 1) - 1), clamp(pixel.y, 0, max(size.y, 1) - 1));
}

template <class T>
glm::ivec2 gloam_guard_band_border(glm::ivec2 size, T guard) {
    const T part = guard > T(0) ? (guard < T(1) ? guard : T(1)) : T(0);
    const auto axis = [&](int extent) {
        const T width = part * T(max(extent, 0));
        const T whole = floor(width);
        return to_int(whole + step(T(0.5), width - whole));
    };
    return glm::ivec2(axis(size.x), axis(size.y));
}

template <class T>
glm::ivec2 gloam_guard_band_size(glm::ivec2 size, T guard) {
    const glm::ivec2 border = gloam_guard_band_border(size, guard);
    return glm::ivec2(max(size.x, 0) + 2 * border.x, max(size.y, 0) + 2 * border.y);
}

template <class T>
vec2<T> gloam_guard_band_guard(glm::ivec2 size, T guard) {
    const glm::ivec2 border = gloam_guard_band_border(size, guard);
    return vec2<T>(T(border.x) / T(max(size.x, 1)), T(border.y) / T(max(size.y, 1)));
}

template <class T>
T gloam_guard_band_tan_half_fov(T tan_half_fov, T guard) {
    const T wider = tan_half_fov * (T(1) + T(2) * guard);
    return gloam_is_finite(wider) ? wider : T(0);
}

template <class T>
vec2<T> gloam_guard_band_inner_uv(vec2<T> outer_uv, vec2<T> guard) {
    const vec2<T> uv = outer_uv + guard * (T(2) * outer_uv - T(1));
    if (gloam_is_finite2(uv)) return uv;
    return vec2<T>(T(2), T(2));
}

template <class T>
vec2<T> gloam_guard_band_outer_uv(vec2<T> inner_uv, vec2<T> guard) {
    const vec2<T> uv = (inner_uv + guard) / (T(1) + T(2) * guard);
    if (gloam_is_finite2(uv)) return uv;
    return vec2<T>(T(2), T(2));
}

}  // namespace gloam::reference
