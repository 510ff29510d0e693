// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "reference/geometry/background.hpp"

namespace gloam::reference {

struct GloamHistory {
    double occlusion;
    double weight;
    unsigned index;
    double depth;
};

inline GloamHistory gloam_history_empty(double depth) {
    return {0.0, 0.0, 0U, gloam_is_background(depth) ? infinity : depth};
}

inline bool gloam_history_usable(double occlusion, double weight) {
    const bool occludes = occlusion > -float_min && occlusion <= 1.0;
    return occludes && weight >= float_min && weight <= float_max;
}

inline GloamHistory gloam_history_sanitize(GloamHistory h) {
    if (!gloam_history_usable(h.occlusion, h.weight) || gloam_is_background(h.depth))
        return gloam_history_empty(h.depth);
    if (h.occlusion < float_min) h.occlusion = 0.0;
    h.index %= 1U << 24U;
    return h;
}

inline dvec4 gloam_history_pack(const GloamHistory& h) {
    const GloamHistory s = gloam_history_sanitize(h);
    return {s.occlusion, s.weight, s.index, s.depth};
}

inline GloamHistory gloam_history_unpack(dvec4 texel) {
    const double index = texel.z >= 0.0 && texel.z < 0x1p24 ? texel.z : 0.0;
    return gloam_history_sanitize({texel.x, texel.y, static_cast<unsigned>(index), texel.w});
}

// (j + k) mod N, in 64 bits.
inline unsigned gloam_next_index(unsigned index, unsigned k, unsigned table_size) {
    const std::uint64_t size = table_size - 1U < 1U << 24U ? table_size : 1U << 24U;
    return static_cast<unsigned>((std::uint64_t{index} + k) % size);
}

}  // namespace gloam::reference
