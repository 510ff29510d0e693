// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/into_slice.hpp"
#include "reference/methods/slice_taps.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/occlusion/gtao.hpp"

namespace gloam::reference {

struct GloamGtao {
    unsigned steps;
};

// Slice by slice the highest horizon on either side, over all layers.
inline GloamEstimate gloam_gtao(dvec3 position, dvec3 normal, const GloamCamera& camera,
                                const GloamKernel& kernel, const GloamGtao& own,
                                const Fetch<dvec4>& fetch_layers) {
    const unsigned steps = std::max(own.steps, 1U);
    const auto add = [&](const GloamSlice& slice, dvec3 n, const auto& tap) {
        const auto horizon = [&](double side) {
            double highest = -1.0;
            for (unsigned i = 0; i < steps; ++i) {
                for (int layer = 0; layer < kernel.layers; ++layer) {
                    const SliceTap seen = tap(side, i, layer);
                    if (!seen.tells || !(dot(seen.offset, n) > kernel.bias)) continue;
                    const dvec3 offset = gloam_into_slice(seen.offset, cross(slice.tangent, slice.view), n);
                    const double weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
                    highest = gloam_gtao_horizon(highest, -side * slice.normal.y, offset, slice.view, weight);
                }
            }
            return highest;
        };
        return gloam_gtao_add(dvec2(0.0), slice, {horizon(-1.0), horizon(1.0)});
    };
    return gather_slices(position, normal, camera, kernel, steps, fetch_layers, add);
}

}  // namespace gloam::reference
