// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/into_slice.hpp"
#include "reference/methods/slice_taps.hpp"
#include "reference/occlusion/sweep.hpp"

namespace gloam::reference {

struct GloamSweep {
    unsigned steps;
    double feature_thickness;
    unsigned falloff;
};

// Slice by slice the directions that each tap uncovers on either side, with the falloff at their distance.
// What lies behind a horizon is I(H) - I(h), calculated anew for each tap.
inline GloamEstimate gloam_sweep(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                 const GloamKernel& kernel, const GloamSweep& own,
                                 const Fetch<double>& fetch_depth) {
    const unsigned steps = std::max(own.steps, 1U);
    const auto add = [&](const GloamSlice& slice, dvec3 n, const auto& tap) {
        const auto occluded = [&](double towards) {
            const GloamSlice half_plane = gloam_sweep_slice(slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            for (unsigned i = 0; i < steps; ++i) {
                const SliceTap seen = tap(towards, i);
                const dvec3 offset = gloam_into_slice(seen.offset, cross(slice.tangent, slice.view), n);
                const dvec2 within = dvec2(dot(offset, slice.view), towards * dot(offset, slice.tangent));
                const double sine = sqrt(max(1.0 - side.horizon * side.horizon, 0.0));
                side.behind = gloam_sweep_behind({side.horizon, sine}, half_plane);
                side = gloam_sweep_tap(side, half_plane, within / kernel.radius, seen.tells,
                                       dot(seen.offset, n) > kernel.bias, own.falloff,
                                       clamp(own.feature_thickness, 0.0, 1e18));
            }
            return side.occluded + side.feature;
        };
        if (!(slice.weight > 0.0)) return dvec2(0.0);
        return slice.weight * dvec2(occluded(1.0) + occluded(-1.0), gloam_slice_whole(slice));
    };
    return gather_slices(position, normal, camera, kernel, steps, fetch_depth, add);
}

}  // namespace gloam::reference
