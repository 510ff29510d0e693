// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
int gloam_depth_rank(vec4<T> depths, int index) {
    const int own = std::clamp(index, 0, 3);
    const T depth = depths[own];
    int rank = 0;
    for (int i = 0; i < 4; ++i) {
        if (depths[i] < depth || (depths[i] == depth && i < own)) ++rank;
    }
    return rank;
}

template <class T>
vec4<T> gloam_mssao_weights(vec4<T> depths, T tolerance) {
    vec4<T> weights(T(0), T(0), T(0), T(0));
    vec4<T> d = depths;
    int surfaces = 0;
    for (int i = 0; i < 4; ++i) {
        const bool background = gloam_is_background(depths[i]);
        if (background) d[i] = gloam_background_depth<T>();
        if (!background) ++surfaces;
    }
    if (surfaces == 0) return weights;
    const int chosen = surfaces == 1 ? 0 : 1;
    const T nearest = min(min(d.x, d.y), min(d.z, d.w));
    const T farthest = max(max(d.x, d.y), max(d.z, d.w));
    const bool together = surfaces == 4 && farthest - nearest <= tolerance;
    for (int i = 0; i < 4; ++i) {
        const int rank = gloam_depth_rank(d, i);
        const bool taken = rank == chosen || (together && rank == 2);
        weights[i] = taken ? (together ? T(0.5) : T(1)) : T(0);
    }
    return weights;
}

template <class T>
vec3<T> gloam_mssao_normal(vec3<T> second, vec3<T> third) {
    const vec3<T> alone = gloam_safe_normalize(second, vec3<T>(T(0), T(0), T(0)));
    return gloam_safe_normalize(T(0.5) * (second + third), alone);
}

}  // namespace gloam::reference
