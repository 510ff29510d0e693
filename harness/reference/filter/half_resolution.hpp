// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline glm::ivec2 gloam_half_size(glm::ivec2 size) {
    return {size.x / 2 + size.x % 2, size.y / 2 + size.y % 2};
}

inline glm::ivec2 gloam_half_source(glm::ivec2 pixel) {
    return {pixel.x * 2, pixel.y * 2};
}

// The ray through the centre of the half-size pixel 0, without that through the centre of its source.
inline double gloam_half_shift(double p, int size) {
    if (size < 1 || !(abs(p) >= 1e-9 && abs(p) <= 1e9)) return 0.0;
    const int half = size / 2 + size % 2;
    const double half_p = p * size / (2.0 * half);  // covers 2 half pixels of the full image
    const double of_half = (1.0 / half - 1.0) / half_p;
    const double of_source = (1.0 / size - 1.0) / p;
    return size % 2 == 0 ? of_half - of_source : 0.0;
}

// The transposed inverse of x' = x - shift z, applied to the normal.
inline glm::dvec3 gloam_half_normal(glm::dvec3 normal, glm::dvec2 shift) {
    const glm::dmat3 sheared{{1, 0, 0}, {0, 1, 0}, {-shift.x, -shift.y, 1}};
    const glm::dvec3 turned = glm::transpose(glm::inverse(sheared)) * normal;
    const double length = glm::length(turned);
    return length > 0.0 && std::isfinite(length) ? turned / length : glm::dvec3(0.0);
}

}  // namespace gloam::reference
