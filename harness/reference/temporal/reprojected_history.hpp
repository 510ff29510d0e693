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

template <class T, class Fetch>
GloamHistory<T> gloam_reprojected_history(vec2<T> uv, glm::ivec2 size, T expected_depth, T epsilon,
                                          Fetch&& fetch_history) {
    GloamHistory<T> history = gloam_history_empty(expected_depth);
    if (!gloam_inside_unit(uv) || size.x < 1 || size.y < 1) return history;
    const vec2<T> x = gloam_texel_position(uv.x, size.x);
    const vec2<T> y = gloam_texel_position(uv.y, size.y);
    const glm::ivec2 first(to_int(x.x), to_int(y.x));
    std::array<GloamHistory<T>, 4> texel;
    glm::bvec4 valid;
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 pixel = gloam_clamp_to_edge(first + glm::ivec2(i % 2, i / 2), size);
        texel[static_cast<std::size_t>(i)] = gloam_history_unpack(vec4<T>(fetch_history(pixel)));
        valid[i] = gloam_depth_consistent(texel[static_cast<std::size_t>(i)].depth, expected_depth, epsilon);
    }
    const vec4<T> weights = gloam_validated_weights(gloam_bilinear_weights(vec2<T>(x.y, y.y)), valid);
    T most = T(0);
    for (int i = 0; i < 4; ++i) {
        const GloamHistory<T>& one = texel[static_cast<std::size_t>(i)];
        history.occlusion = history.occlusion + weights[i] * one.occlusion;
        history.weight = history.weight + weights[i] * one.weight;
        if (weights[i] > most) {
            most = weights[i];
            history.index = one.index;
        }
    }
    history.occlusion = min(history.occlusion, T(1));
    return gloam_history_sanitize(history);
}

}  // namespace gloam::reference
