// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_slice_clearance(GloamSlice<T> slice, vec3<T> position, vec2<T> direction, vec2<T> end,
                              GloamCamera<T> camera, T radius, T ball) {
    const vec2<T> unknown(T(0), T(0));
    if (!(min(end.x, end.y) >= T(0) && max(end.x, end.y) <= T(1) && ball >= T(0) && ball <= T(1)))
        return unknown;
    const vec2<T> pixels = gloam_camera_radius(radius, T(-position.z), camera) * vec2<T>(camera.size);
    const T squared = slice.weight * slice.weight;
    const vec2<T> shares(T(1) / pixels.x, T(1) / pixels.y);
    const T beside = T(0.52F) * length(shares) * (T(1) + gloam_sqrt((T(1) - squared) / squared));
    const T ratio = radius / length(position);
    const T along = abs(direction.x * slice.tangent.x + direction.y * slice.tangent.y);
    if (!(ratio <= T(0.5) && ratio >= T(0.0078125) && squared >= T(0.1F) && beside <= T(0.9F) &&
          along <= T(1.001F))) {
        return unknown;
    }
    const T nearer = (T(1) - ball * ratio) / (T(1) + ratio * (gloam_sqrt(T(1) - along * along) + beside));
    return vec2<T>(nearer * along, nearer * beside + T(2e-4F));
}

template <class T>
unsigned gloam_slice_taps(vec2<T> clearance, T ball, T jitter, unsigned steps) {
    if (ball <= T(0)) return 0U;
    if (!(ball < T(1) && clearance.x > T(0))) return steps;
    const T end = T(steps) * gloam_sqrt((ball + clearance.y) / clearance.x) - jitter;
    return end < T(steps) ? static_cast<unsigned>(to_int(max(T(ceil(end)), T(0)))) : steps;
}

}  // namespace gloam::reference
