// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

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
    const double whole = floor(x);
    return unsigned((whole)) + (x - whole >= 0.5 ? 1U : 0U);
}

inline unsigned gloam_depth_to_code(double depth) {
    if (gloam_is_background(depth)) return 65535U;
    constexpr int smallest = -31;
    constexpr int largest = 32;
    if (depth >= 0x1p32) return 64513U;
    int exponent = largest - 1;
    while (exponent >= smallest && !(depth >= double(std::ldexp(1.0, exponent)))) --exponent;
    if (exponent < smallest) return 1U;
    const double mantissa = depth * double(std::ldexp(1.0, -exponent)) - 1.0;
    return static_cast<unsigned>(exponent - smallest) * 1024U + gloam_round_half_up(mantissa * 1024.0) + 1U;
}

inline double gloam_depth_from_code(unsigned code) {
    if (code == 0U) return 0.0;
    if (code >= 65535U) return gloam_background_depth();
    const unsigned number = code - 1U;
    return double(number % 1024U + 1024U) * double(std::ldexp(1.0, static_cast<int>(number / 1024U) - 41));
}

inline GloamPackedHistory gloam_history_encode(GloamHistory h) {
    const GloamHistory s = gloam_history_sanitize(h);
    const double weight = s.weight < 4095.0 ? s.weight : 4095.0;
    return {gloam_round_half_up(s.occlusion * 32768.0), gloam_round_half_up(weight * 16.0), s.index % 65536U,
            gloam_depth_to_code(s.depth)};
}

inline dvec4 gloam_packed_texel(GloamPackedHistory packed) {
    return {double(packed.occlusion % 65536U) * 0x1p-15, double(packed.weight % 65536U) * 0x1p-4,
            double(packed.index % 65536U), gloam_depth_from_code(packed.depth % 65536U)};
}

inline GloamHistory gloam_history_decode(GloamPackedHistory packed) {
    return gloam_history_unpack(gloam_packed_texel(packed));
}

}  // namespace gloam::reference
