// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/background.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_layers_occlusion(T occlusion, T layer) {
    return max(gloam_unit_interval(occlusion), gloam_unit_interval(layer));
}

template <class T>
T gloam_layer_blocked(T sample_depth, T front, T back) {
    if (gloam_is_background(sample_depth) || gloam_is_background(front)) return T(0);
    const bool before_back = gloam_is_background(back) || sample_depth <= back;
    return front <= sample_depth && before_back ? T(1) : T(0);
}

template <class T>
T gloam_layer_depth(T first, vec3<T> further, int layer) {
    return layer == 0 ? first : T(abs(further[std::min(layer, 3) - 1]));
}

template <class T>
struct GloamLayersSeen {
    T occlusion;
    T before;
    bool front;
};

// A back closes what the layers before it have in front of the point.
template <class T>
GloamLayersSeen<T> gloam_layers_add(GloamLayersSeen<T> seen, T blocked, vec3<T> further, T depth, int layer,
                                    int layers) {
    if (layer == 0) return {blocked, T(0), true};
    const T signed_depth = further[std::min(layer, 3) - 1];
    const bool back = seen.front && signed_depth < T(0);
    const bool last_of_many = layers > 2 && layer >= layers - 1;
    const bool ends = back && !last_of_many && (layers == 2 || layer + 1 < layers) && -signed_depth < depth;
    const T left = ends ? seen.before : seen.occlusion;
    return {back ? left : T(max(left, blocked)), left, signed_depth > T(0)};
}

}  // namespace gloam::reference
