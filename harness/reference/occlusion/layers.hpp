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
    return front <= sample_depth && (sample_depth <= back || gloam_is_background(back)) ? 1.0 : 0.0;
}

inline double gloam_layer_depth(double first, dvec3 further, int layer) {
    return layer == 0 ? first : abs(further[std::min(layer, 3) - 1]);
}

// Depths at a pixel: of the visible surface in x, signed ones of layers 1 to 3 in y, z and w.
inline double depth_of_layer(dvec4 depths, int layer) {
    return gloam_layer_depth(depths.x, {depths.y, depths.z, depths.w}, layer);
}

struct GloamLayersSeen {
    double occlusion;
    double before;
    bool front;
};

// A back right behind a front closes that object: where it lies before the point, what its front blocked is
// taken back. The last of three or more layers closes nothing.
inline GloamLayersSeen gloam_layers_add(const GloamLayersSeen& seen, double blocked, dvec3 further,
                                        double depth, int layer, int layers) {
    if (layer == 0) return {blocked, 0.0, true};
    const double signed_depth = further[std::min(layer, 3) - 1];
    const bool back = seen.front && signed_depth < 0.0;
    const bool closes = back && (layers == 2 || layer < layers - 1) && -signed_depth < depth;
    const double left = closes ? seen.before : seen.occlusion;
    return {back ? left : max(left, blocked), left, signed_depth > 0.0};
}

}  // namespace gloam::reference
