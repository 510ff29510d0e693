// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_depth_key(T depth, T z_key) {
    const bool divides = z_key >= float_min<T>() && z_key <= T(0x1p126);
    return !gloam_is_background(depth) && divides && depth < z_key ? min(depth / z_key, T(1)) : T(1);
}

template <class T>
vec2<T> gloam_pack_key(T key) {
    const T inside = key > T(0) ? (key < T(1) ? key : T(1)) : T(0);
    const T whole = floor(inside * T(65535) + T(0.5));
    const T high = floor(whole * T(0.00390625));
    return vec2<T>(high / T(255), (whole - T(256) * high) / T(255));
}

template <class T>
T gloam_unpack_key(vec2<T> packed_key) {
    const vec2<T> inside(packed_key.x > T(0) ? min(packed_key.x, T(1)) : T(0),
                         packed_key.y > T(0) ? min(packed_key.y, T(1)) : T(0));
    const vec2<T> bytes(floor(inside.x * T(255) + T(0.5)), floor(inside.y * T(255) + T(0.5)));
    return min((T(256) * bytes.x + bytes.y) / T(65535), T(1));
}

}  // namespace gloam::reference
