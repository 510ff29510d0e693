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

template <class T>
unsigned gloam_round_half_up(T x) {
    const T whole = floor(x);
    return static_cast<unsigned>(to_int(whole)) + (x - whole >= T(0.5) ? 1U : 0U);
}

template <class T>
unsigned gloam_depth_to_code(T depth) {
    if (gloam_is_background(depth)) return 65535U;
    constexpr int smallest = -31;
    constexpr int largest = 32;
    if (depth >= T(0x1p32)) return 64513U;
    int exponent = largest - 1;
    while (exponent >= smallest && !(depth >= T(std::ldexp(1.0, exponent)))) --exponent;
    if (exponent < smallest) return 1U;
    const T mantissa = depth * T(std::ldexp(1.0, -exponent)) - T(1);
    return static_cast<unsigned>(exponent - smallest) * 1024U + gloam_round_half_up(mantissa * T(1024)) + 1U;
}

template <class T = double>
T gloam_depth_from_code(unsigned code) {
    if (code == 0U) return T(0);
    if (code >= 65535U) return gloam_background_depth<T>();
    const unsigned number = code - 1U;
    return T(number % 1024U + 1024U) * T(std::ldexp(1.0, static_cast<int>(number / 1024U) - 41));
}

template <class T>
GloamPackedHistory gloam_history_encode(GloamHistory<T> h) {
    const GloamHistory<T> s = gloam_history_sanitize(h);
    const T weight = s.weight < T(4095) ? s.weight : T(4095);
    return {gloam_round_half_up(s.occlusion * T(32768)), gloam_round_half_up(weight * T(16)),
            s.index % 65536U, gloam_depth_to_code(s.depth)};
}

template <class T = double>
vec4<T> gloam_packed_texel(GloamPackedHistory packed) {
    return {T(packed.occlusion % 65536U) * T(0x1p-15), T(packed.weight % 65536U) * T(0x1p-4),
            T(packed.index % 65536U), gloam_depth_from_code<T>(packed.depth % 65536U)};
}

template <class T = double>
GloamHistory<T> gloam_history_decode(GloamPackedHistory packed) {
    return gloam_history_unpack(gloam_packed_texel<T>(packed));
}

}  // namespace gloam::reference
