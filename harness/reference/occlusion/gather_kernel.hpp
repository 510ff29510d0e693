// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/camera.hpp"
#include "reference/math.hpp"
#include "reference/occlusion/estimator.hpp"

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

inline bool gloam_can_gather(dvec3 position, dvec3 normal, double radius, const GloamCamera& camera) {
    const auto usable = [](double x) { return x >= 1e-18F && x <= 1e18F; };
    const bool placed = abs(position.x) <= 1e18F && abs(position.y) <= 1e18F && usable(-position.z);
    const bool projects = usable(abs(camera.p00_p11.x)) && usable(abs(camera.p00_p11.y));
    return placed && projects && length(normal) >= 1e-15 && length(normal) <= 1e15 && usable(radius) &&
           std::min(camera.size.x, camera.size.y) > 0;
}

inline GloamEstimate gloam_estimate(double occluded, double whole, unsigned samples) {
    return {gloam_weighted_ratio({occluded, whole}), static_cast<double>(samples), 0U};
}

inline bool gloam_tap_sees(double depth) {
    return depth >= 1e-18F && depth <= 1e18F;
}

}  // namespace gloam::reference
