// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_depth_key(double depth, double z_key) {
    const bool divides = z_key >= float_min && z_key <= 0x1p126;
    return !gloam_is_background(depth) && divides && depth < z_key ? min(depth / z_key, 1.0) : 1.0;
}

inline dvec2 gloam_pack_key(double key) {
    const double inside = key > 0.0 ? (key < 1.0 ? key : 1.0) : 0.0;
    const double whole = floor(inside * 65535.0 + 0.5);
    const double high = floor(whole * 0.00390625);
    return dvec2(high / 255.0, (whole - 256.0 * high) / 255.0);
}

inline double gloam_unpack_key(dvec2 packed_key) {
    const dvec2 inside(packed_key.x > 0.0 ? min(packed_key.x, 1.0) : 0.0,
                       packed_key.y > 0.0 ? min(packed_key.y, 1.0) : 0.0);
    const dvec2 bytes(floor(inside.x * 255.0 + 0.5), floor(inside.y * 255.0 + 0.5));
    return min((256.0 * bytes.x + bytes.y) / 65535.0, 1.0);
}

}  // namespace gloam::reference
