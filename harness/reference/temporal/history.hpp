// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
struct GloamHistory {
    T occlusion;
    T weight;
    unsigned index;
    T depth;
};

template <class T>
GloamHistory<T> gloam_history_empty(T depth) {
    T kept = gloam_background_depth<T>();
    if (!gloam_is_background(depth)) kept = depth;
    return GloamHistory<T>{T(0), T(0), 0U, kept};
}

template <class T>
GloamHistory<T> gloam_history_sanitize(GloamHistory<T> h) {
    const bool occlusion = h.occlusion >= T(0) && h.occlusion <= T(1);
    const bool weight = h.weight > T(0) && gloam_is_finite(h.weight);
    if (!occlusion || !weight || gloam_is_background(h.depth)) return gloam_history_empty(h.depth);
    h.index = h.index & 0xFFFFFFU;
    return h;
}

template <class T>
vec4<T> gloam_history_pack(GloamHistory<T> h) {
    const GloamHistory<T> s = gloam_history_sanitize(h);
    return vec4<T>(s.occlusion, s.weight, T(s.index), s.depth);
}

template <class T>
GloamHistory<T> gloam_history_unpack(vec4<T> texel) {
    unsigned index = 0U;
    if (texel.z >= T(1) && texel.z < T(16777216)) index = static_cast<unsigned>(to_int(floor(texel.z)));
    return gloam_history_sanitize(GloamHistory<T>{texel.x, texel.y, index, texel.w});
}

template <class T = double>
unsigned gloam_next_index(unsigned index, unsigned k, unsigned table_size) {
    const unsigned long long largest = 16777216ULL;
    const unsigned long long size = table_size == 0U || table_size > largest ? largest : table_size;
    return static_cast<unsigned>((static_cast<unsigned long long>(index) + k) % size);
}

}  // namespace gloam::reference
