// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

struct GloamHistory {
    double occlusion;
    double weight;
    unsigned index;
    double depth;
};

inline GloamHistory gloam_history_empty(double depth) {
    return GloamHistory{0.0, 0.0, 0U, gloam_is_background(depth) ? gloam_background_depth() : depth};
}

inline GloamHistory gloam_history_sanitize(GloamHistory h) {
    const bool usable =
        h.occlusion > -float_min && h.occlusion <= 1.0 && h.weight >= float_min && h.weight <= float_max;
    if (!usable || gloam_is_background(h.depth)) return gloam_history_empty(h.depth);
    return GloamHistory{h.occlusion >= float_min ? h.occlusion : 0.0, h.weight, h.index % 16777216U, h.depth};
}

inline dvec4 gloam_history_pack(GloamHistory h) {
    const GloamHistory s = gloam_history_sanitize(h);
    return dvec4(s.occlusion, s.weight, double(s.index), s.depth);
}

inline GloamHistory gloam_history_unpack(dvec4 texel) {
    unsigned index = 0U;
    if (texel.z >= 1.0 && texel.z < 16777216.0) index = unsigned((texel.z));
    return gloam_history_sanitize(GloamHistory{texel.x, texel.y, index, texel.w});
}

inline unsigned gloam_next_index(unsigned index, unsigned k, unsigned table_size) {
    const unsigned size = table_size > 0U && table_size < 16777216U ? table_size : 16777216U;
    return (index % size + k % size) % size;
}

}  // namespace gloam::reference
