// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline dvec2 gloam_slice_clearance(GloamSlice slice, dvec3 position, dvec2 direction, dvec2 end,
                                   GloamCamera camera, double radius, double ball) {
    const dvec2 unknown(0.0, 0.0);
    if (!(min(end.x, end.y) >= 0.0 && max(end.x, end.y) <= 1.0 && ball >= 0.0 && ball <= 1.0)) return unknown;
    const dvec2 pixels = gloam_camera_radius(radius, -position.z, camera) * dvec2(camera.size);
    const double squared = slice.weight * slice.weight;
    const dvec2 shares(1.0 / pixels.x, 1.0 / pixels.y);
    const double beside = double(0.52F) * length(shares) * (1.0 + gloam_sqrt((1.0 - squared) / squared));
    const double ratio = radius / length(position);
    const double along = abs(direction.x * slice.tangent.x + direction.y * slice.tangent.y);
    if (!(ratio <= 0.5 && ratio >= 0.0078125 && squared >= double(0.1F) && beside <= double(0.9F) &&
          along <= double(1.001F))) {
        return unknown;
    }
    const double nearer = (1.0 - ball * ratio) / (1.0 + ratio * (gloam_sqrt(1.0 - along * along) + beside));
    return dvec2(nearer * along, nearer * beside + double(2e-4F));
}

inline unsigned gloam_slice_taps(dvec2 clearance, double ball, double jitter, unsigned steps) {
    if (ball <= 0.0) return 0U;
    if (!(ball < 1.0 && clearance.x > 0.0)) return steps;
    const double end = double(steps) * gloam_sqrt((ball + clearance.y) / clearance.x) - jitter;
    return end < double(steps) ? unsigned((max(double(ceil(end)), 0.0))) : steps;
}

}  // namespace gloam::reference
