// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T = double>
glm::ivec2 gloam_clamp_to_edge(glm::ivec2 pixel, glm::ivec2 size) {
    const auto axis = [](int p, int extent) {
        if (p < 0 || extent < 1) return 0;
        return p < extent ? p : extent - 1;
    };
    return glm::ivec2(axis(pixel.x, size.x), axis(pixel.y, size.y));
}

template <class T>
glm::ivec2 gloam_guard_band_border(glm::ivec2 size, T guard) {
    T part = T(0);
    if (guard > T(0)) part = guard;
    if (guard > T(1)) part = T(1);
    const auto axis = [&](int extent) { return extent < 1 ? 0 : to_int(floor(part * T(extent) + T(0.5))); };
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
    const auto axis = [](int b, int extent) { return extent < 1 ? T(0) : T(b) / T(extent); };
    return vec2<T>(axis(border.x, size.x), axis(border.y, size.y));
}

template <class T>
T gloam_guard_band_tan_half_fov(T tan_half_fov, T guard) {
    const T wider = (T(1) + T(2) * guard) * tan_half_fov;
    if (gloam_is_finite(wider)) return wider;
    return T(0);
}

template <class T>
vec2<T> gloam_guard_band_inner_uv(vec2<T> outer_uv, vec2<T> guard) {
    const auto axis = [](T uv, T g) { return uv * (T(1) + T(2) * g) - g; };
    const vec2<T> uv(axis(outer_uv.x, guard.x), axis(outer_uv.y, guard.y));
    if (gloam_is_finite2(uv)) return uv;
    return vec2<T>(T(2), T(2));
}

template <class T>
vec2<T> gloam_guard_band_outer_uv(vec2<T> inner_uv, vec2<T> guard) {
    const auto axis = [](T uv, T g) { return (uv + g) / (T(1) + T(2) * g); };
    const vec2<T> uv(axis(inner_uv.x, guard.x), axis(inner_uv.y, guard.y));
    if (gloam_is_finite2(uv)) return uv;
    return vec2<T>(T(2), T(2));
}

}  // namespace gloam::reference
