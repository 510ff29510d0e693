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
    return GloamHistory<T>{T(0), T(0), 0U, gloam_is_background(depth) ? gloam_background_depth<T>() : depth};
}

template <class T>
GloamHistory<T> gloam_history_sanitize(GloamHistory<T> h) {
    const bool usable = h.occlusion > -float_min<T>() && h.occlusion <= T(1) && h.weight >= float_min<T>() &&
                        h.weight <= float_max<T>();
    if (!usable || gloam_is_background(h.depth)) return gloam_history_empty(h.depth);
    return GloamHistory<T>{h.occlusion >= float_min<T>() ? h.occlusion : T(0), h.weight, h.index % 16777216U,
                           h.depth};
}

template <class T>
vec4<T> gloam_history_pack(GloamHistory<T> h) {
    const GloamHistory<T> s = gloam_history_sanitize(h);
    return vec4<T>(s.occlusion, s.weight, T(s.index), s.depth);
}

template <class T>
GloamHistory<T> gloam_history_unpack(vec4<T> texel) {
    unsigned index = 0U;
    if (texel.z >= T(1) && texel.z < T(16777216)) index = static_cast<unsigned>(to_int(texel.z));
    return gloam_history_sanitize(GloamHistory<T>{texel.x, texel.y, index, texel.w});
}

template <class T = double>
unsigned gloam_next_index(unsigned index, unsigned k, unsigned table_size) {
    const unsigned size = table_size > 0U && table_size < 16777216U ? table_size : 16777216U;
    return (index % size + k % size) % size;
}

}  // namespace gloam::reference
