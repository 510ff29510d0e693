// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/temporal/history.hpp"

namespace gloam::reference {

struct GloamPackedHistory {
    unsigned occlusion;
    unsigned weight;
    unsigned index;
    unsigned depth;
    friend bool operator==(const GloamPackedHistory&, const GloamPackedHistory&) = default;
};

inline unsigned gloam_round_half_up(double x) {
    return static_cast<unsigned>(std::floor(x + 0.5));
}

// 1024 (e + m) + 1 of the depth 2^(e - 31) (1 + m).
inline unsigned gloam_depth_to_code(double depth) {
    if (gloam_is_background(depth)) return 65535U;
    const double d = std::clamp(depth, 0x1p-31, 0x1p32);
    const int exponent = std::ilogb(d);
    return gloam_round_half_up(1024.0 * (exponent + 31 + d / std::ldexp(1.0, exponent) - 1.0)) + 1U;
}

inline double gloam_depth_from_code(unsigned code) {
    if (code == 0U) return 0.0;
    if (code >= 65535U) return infinity;
    const auto [exponent, mantissa] = std::div(static_cast<int>(code) - 1, 1024);
    return std::ldexp(1.0 + mantissa / 1024.0, exponent - 31);
}

inline GloamPackedHistory gloam_history_encode(const GloamHistory& h) {
    const GloamHistory s = gloam_history_sanitize(h);
    return {gloam_round_half_up(0x1p15 * s.occlusion), gloam_round_half_up(16.0 * min(s.weight, 4095.0)),
            s.index % 65536U, gloam_depth_to_code(s.depth)};
}

inline dvec4 gloam_packed_texel(const GloamPackedHistory& packed) {
    return {(packed.occlusion % 65536U) / 0x1p15, (packed.weight % 65536U) / 16.0, packed.index % 65536U,
            gloam_depth_from_code(packed.depth % 65536U)};
}

inline GloamHistory gloam_history_decode(const GloamPackedHistory& packed) {
    return gloam_history_unpack(gloam_packed_texel(packed));
}

}  // namespace gloam::reference
