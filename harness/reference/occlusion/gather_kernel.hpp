// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

struct GloamKernel {
    double radius;
    double bias;
    double angle;
    unsigned first;
    unsigned count;
    double farthest;
    int layers;
    bool ends_marches;
};

struct GloamEstimate {
    double occlusion;
    double samples;
    unsigned left_out;
};

// (sum, samples taken) of the references of the gathers as an estimate.
inline GloamEstimate estimate_of(dvec2 sum) {
    const double mean = sum.y >= 1.0 && sum.x > 0.0 ? double(min(sum.x / sum.y, 1.0)) : 0.0;
    return {mean, sum.y, 0U};
}

inline bool gloam_can_gather(dvec3 position, dvec3 normal, double radius, GloamCamera camera) {
    const double least(1e-18F);
    const double most(1e18F);
    const dvec2 p(abs(camera.p00_p11.x), abs(camera.p00_p11.y));
    const bool point =
        abs(position.x) <= most && abs(position.y) <= most && -position.z >= least && -position.z <= most;
    const bool facing =
        gloam_is_finite3(normal) && max(max(abs(normal.x), abs(normal.y)), abs(normal.z)) >= float_min;
    const bool projects =
        p.x >= least && p.y >= least && p.x <= most && p.y <= most && camera.size.x > 0 && camera.size.y > 0;
    return point && facing && projects && radius >= least && radius <= most;
}

inline GloamEstimate gloam_estimate(double occluded, double whole, unsigned samples) {
    const bool known = whole >= float_min && occluded > 0.0;
    if (!known) return {0.0, double(samples), 0U};
    return {occluded < whole ? double(occluded / whole) : 1.0, double(samples), 0U};
}

inline bool gloam_tap_sees(double depth) {
    return depth > 0.0 && depth <= double(1e18F);
}

}  // namespace gloam::reference
