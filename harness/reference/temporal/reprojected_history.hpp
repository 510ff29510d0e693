// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "reference/geometry/borders.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/texel_position.hpp"
#include "reference/temporal/disocclusion.hpp"
#include "reference/temporal/history.hpp"
#include "reference/temporal/validated_bilinear.hpp"

namespace gloam::reference {

inline GloamHistory gloam_reprojected_history(dvec2 uv, glm::ivec2 size, double expected_depth,
                                              double epsilon, const Fetch<dvec4>& fetch_history) {
    GloamHistory history = gloam_history_empty(expected_depth);
    if (!gloam_inside_unit(uv) || size.x < 1 || size.y < 1) return history;
    const dvec2 x = gloam_texel_position(uv.x, size.x);
    const dvec2 y = gloam_texel_position(uv.y, size.y);
    const glm::ivec2 first(int(x.x), int(y.x));
    std::array<GloamHistory, 4> texel;
    glm::bvec4 valid;
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 pixel = gloam_clamp_to_edge(first + glm::ivec2(i % 2, i / 2), size);
        texel[static_cast<std::size_t>(i)] = gloam_history_unpack(dvec4(fetch_history(pixel)));
        valid[i] = gloam_depth_consistent(texel[static_cast<std::size_t>(i)].depth, expected_depth, epsilon);
    }
    const dvec4 weights = gloam_validated_weights(gloam_bilinear_weights(dvec2(x.y, y.y)), valid);
    double most = 0.0;
    for (int i = 0; i < 4; ++i) {
        const GloamHistory& one = texel[static_cast<std::size_t>(i)];
        history.occlusion = history.occlusion + weights[i] * one.occlusion;
        history.weight = history.weight + weights[i] * one.weight;
        if (weights[i] > most) {
            most = weights[i];
            history.index = one.index;
        }
    }
    history.occlusion = min(history.occlusion, 1.0);
    return gloam_history_sanitize(history);
}

}  // namespace gloam::reference
