// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/borders.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/texel_position.hpp"
#include "reference/temporal/disocclusion.hpp"
#include "reference/temporal/history.hpp"

namespace gloam::reference {

// The mean of the four texels around that hold the surface, each weighted by its distance along x and y.
inline GloamHistory gloam_reprojected_history(dvec2 uv, glm::ivec2 size, double expected_depth,
                                              double epsilon, const Fetch<dvec4>& fetch_history) {
    GloamHistory mean = gloam_history_empty(expected_depth);
    if (!gloam_inside_unit(uv) || size.x < 1 || size.y < 1) return mean;
    const dvec2 x = gloam_texel_position(uv.x, size.x);
    const dvec2 y = gloam_texel_position(uv.y, size.y);
    double total = 0.0;
    double most = 0.0;
    for (const glm::ivec2 step : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const glm::ivec2 texel = gloam_clamp_to_edge(glm::ivec2(x[0], y[0]) + step, size);
        const GloamHistory one = gloam_history_unpack(fetch_history(texel));
        if (!gloam_depth_consistent(one.depth, expected_depth, epsilon)) continue;
        const double weight = (1.0 - abs(x[1] - step.x)) * (1.0 - abs(y[1] - step.y));
        total += weight;
        mean.occlusion += weight * one.occlusion;
        mean.weight += weight * one.weight;
        if (weight > most) mean.index = one.index;
        most = max(most, weight);
    }
    return gloam_history_sanitize(
        {min(mean.occlusion / total, 1.0), mean.weight / total, mean.index, mean.depth});
}

}  // namespace gloam::reference
