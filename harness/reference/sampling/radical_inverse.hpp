// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

// a_0 / b + a_1 / b^2 + ... of the digits a_m of the index.
inline double gloam_radical_inverse(unsigned index, unsigned base) {
    const unsigned b = std::clamp(base, 2U, 1U << 24U);
    double sum = 0.0;
    double place = 1.0;
    for (unsigned rest = index % (1U << 24U); rest > 0U; rest /= b) sum += rest % b * (place /= b);
    return sum;
}

inline double gloam_radical_inverse_base2(unsigned index) {
    return gloam_radical_inverse(index, 2U);
}

}  // namespace gloam::reference
