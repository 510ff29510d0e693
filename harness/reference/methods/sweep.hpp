// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/into_slice.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/occlusion/depth_rejection.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/sweep.hpp"
#include "reference/sampling/slice_sample.hpp"
#include "reference/sampling/whole_samples.hpp"

namespace gloam::reference {

struct GloamSweep {
    unsigned steps;
    unsigned falloff;
};

// Slice by slice the directions that each tap uncovers on either side, with the falloff at their distance;
// the surface points are those of gloam_gtao. What lies behind a horizon is I(H) - I(h), calculated anew for
// each tap.
inline GloamEstimate gloam_sweep(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                 const GloamKernel& kernel, const GloamSweep& own,
                                 const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return {};
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 view = camera.orthographic ? dvec3(0.0, 0.0, 1.0) : normalize(-position);
    const dvec2 uv = gloam_camera_uv(position, camera);
    const dvec2 axes = gloam_camera_radius(kernel.radius, -position.z, camera);
    const unsigned steps = std::max(own.steps, 1U);
    const unsigned samples = gloam_whole_samples(kernel.count, 2U * steps);
    dvec2 sum(0.0);
    for (unsigned s = 1; s <= samples / (2U * steps); ++s) {
        const GloamSliceSample sample =
            gloam_slice_sample(kernel.first / (2U * steps) + s, gloam_kernel_turns(kernel.angle));
        const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
        const GloamSlice slice = gloam_slice(sample.direction * upright, view, n);
        const auto occluded = [&](double towards) {
            const GloamSlice half_plane = gloam_sweep_slice(slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            for (unsigned i = 0; i < steps; ++i) {
                const double share = towards * pow((i + sample.jitter) / steps, 2);
                const glm::ivec2 pixel =
                    gloam_nearest_pixel(uv + share * axes * sample.direction, camera.size);
                const dvec3 point = gloam_camera_position(pixel, fetch_depth(pixel), camera);
                const bool tells = point != dvec3(0.0) && pixel != gloam_nearest_pixel(uv, camera.size) &&
                                   !gloam_tap_rejected(-position.z, fetch_depth(pixel), kernel.farthest);
                const dvec3 offset = gloam_into_slice(point - position, cross(slice.tangent, slice.view), n);
                const dvec2 within = dvec2(dot(offset, slice.view), towards * dot(offset, slice.tangent));
                const double sine = sqrt(max(1.0 - side.horizon * side.horizon, 0.0));
                side.behind = gloam_sweep_behind({side.horizon, sine}, half_plane);
                side = gloam_sweep_tap(side, half_plane, within / kernel.radius, tells,
                                       dot(point - position, n) > kernel.bias, own.falloff);
            }
            return side.occluded;
        };
        if (slice.weight > 0.0)
            sum += slice.weight * dvec2(occluded(1.0) + occluded(-1.0), gloam_slice_whole(slice));
    }
    return gloam_estimate(sum.x, sum.y, samples);
}

}  // namespace gloam::reference
