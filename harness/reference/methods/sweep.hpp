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
// What lies behind a horizon is I(H) - I(h), calculated anew for each tap. A further layer is as far behind
// the tap before as the first one, and the next tap begins at the first.
inline GloamEstimate gloam_sweep(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                 const GloamKernel& kernel, const GloamSweep& own,
                                 const Fetch<dvec4>& fetch_layers) {
    const unsigned steps = std::max(own.steps, 1U);
    const double thickness = own.feature_thickness > 0.0 ? std::min(own.feature_thickness, 1e18) : 0.0;
    const auto add = [&](const GloamSlice& slice, dvec3 n, const auto& tap) {
        const auto occluded = [&](double towards) {
            const GloamSlice half_plane = gloam_sweep_slice(slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            const auto look = [&](unsigned i, int layer) {
                const SliceTap seen = tap(towards, i, layer);
                const dvec3 offset = gloam_into_slice(seen.offset, cross(slice.tangent, slice.view), n);
                const dvec2 within = dvec2(dot(offset, slice.view), towards * dot(offset, slice.tangent));
                const double sine = sqrt(max(1.0 - side.horizon * side.horizon, 0.0));
                const bool rises = dot(seen.offset, n) > kernel.bias;
                side.behind = gloam_sweep_behind({side.horizon, sine}, half_plane);
                side = layer == 0 ? gloam_sweep_tap(side, half_plane, within / kernel.radius, seen.tells,
                                                    rises, own.falloff, thickness)
                                  : gloam_sweep_uncover(side, half_plane, within / kernel.radius, seen.tells,
                                                        rises, own.falloff);
            };
            for (unsigned i = 0; i < steps; ++i) {
                const double before = side.before;
                double nearest = before;
                for (int layer = 0; layer < kernel.layers; ++layer) {
                    side.before = before;
                    look(i, layer);
                    if (layer == 0) nearest = side.before;
                }
                side.before = nearest;
            }
            return side.occluded + side.feature;
        };
        if (!(slice.weight > 0.0)) return dvec2(0.0);
        return slice.weight * dvec2(occluded(1.0) + occluded(-1.0), gloam_slice_whole(slice));
    };
    return gather_slices(position, normal, camera, kernel, steps, fetch_layers, add);
}

}  // namespace gloam::reference
