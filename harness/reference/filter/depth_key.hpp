// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_depth_key(double depth, double z_key) {
    const bool divides = z_key >= float_min && z_key <= 0x1p126;
    return gloam_is_background(depth) || !divides ? 1.0 : min(depth / z_key, 1.0);
}

// The high and the low byte of round(65535 key).
inline dvec2 gloam_pack_key(double key) {
    const auto bytes = std::div(std::lround(65535.0 * gloam_unit_interval(key)), 256L);
    return dvec2(bytes.quot, bytes.rem) / 255.0;
}

inline double gloam_unpack_key(dvec2 packed_key) {
    const auto byte = [](double x) { return std::round(255.0 * gloam_unit_interval(x)); };
    return (256.0 * byte(packed_key.x) + byte(packed_key.y)) / 65535.0;
}

}  // namespace gloam::reference
