// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/background.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_layers_occlusion(double occlusion, double layer) {
    return max(gloam_unit_interval(occlusion), gloam_unit_interval(layer));
}

inline double gloam_layer_blocked(double sample_depth, double front, double back) {
    if (gloam_is_background(sample_depth) || gloam_is_background(front)) return 0.0;
    const bool before_back = gloam_is_background(back) || sample_depth <= back;
    return front <= sample_depth && before_back ? 1.0 : 0.0;
}

inline double gloam_layer_depth(double first, dvec3 further, int layer) {
    return layer == 0 ? first : double(abs(further[std::min(layer, 3) - 1]));
}

struct GloamLayersSeen {
    double occlusion;
    double before;
    bool front;
};

// A back closes what the layers before it have in front of the point.
inline GloamLayersSeen gloam_layers_add(GloamLayersSeen seen, double blocked, dvec3 further, double depth,
                                        int layer, int layers) {
    if (layer == 0) return {blocked, 0.0, true};
    const double signed_depth = further[std::min(layer, 3) - 1];
    const bool back = seen.front && signed_depth < 0.0;
    const bool last_of_many = layers > 2 && layer >= layers - 1;
    const bool ends = back && !last_of_many && (layers == 2 || layer + 1 < layers) && -signed_depth < depth;
    const double left = ends ? seen.before : seen.occlusion;
    return {back ? left : double(max(left, blocked)), left, signed_depth > 0.0};
}

}  // namespace gloam::reference
