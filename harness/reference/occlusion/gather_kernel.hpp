// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
struct GloamKernel {
    T radius;
    T bias;
    T angle;
    unsigned first;
    unsigned count;
    T farthest;
    int layers;
    bool ends_marches;
};

template <class T>
struct GloamEstimate {
    T occlusion;
    T samples;
    unsigned left_out;
};

// (sum, samples taken) of the references of the gathers as an estimate.
template <class T>
GloamEstimate<T> estimate_of(vec2<T> sum) {
    const T mean = sum.y >= T(1) && sum.x > T(0) ? T(min(sum.x / sum.y, T(1))) : T(0);
    return {mean, sum.y, 0U};
}

template <class T>
bool gloam_can_gather(vec3<T> position, vec3<T> normal, T radius, GloamCamera<T> camera) {
    const T least(1e-18F);
    const T most(1e18F);
    const vec2<T> p(abs(camera.p00_p11.x), abs(camera.p00_p11.y));
    const bool point =
        abs(position.x) <= most && abs(position.y) <= most && -position.z >= least && -position.z <= most;
    const bool facing =
        gloam_is_finite3(normal) && max(max(abs(normal.x), abs(normal.y)), abs(normal.z)) >= float_min<T>();
    const bool projects =
        p.x >= least && p.y >= least && p.x <= most && p.y <= most && camera.size.x > 0 && camera.size.y > 0;
    return point && facing && projects && radius >= least && radius <= most;
}

template <class T>
GloamEstimate<T> gloam_estimate(T occluded, T whole, unsigned samples) {
    const bool known = whole >= float_min<T>() && occluded > T(0);
    if (!known) return {T(0), T(samples), 0U};
    return {occluded < whole ? T(occluded / whole) : T(1), T(samples), 0U};
}

template <class T>
bool gloam_tap_sees(T depth) {
    return depth > T(0) && depth <= T(1e18F);
}

}  // namespace gloam::reference
