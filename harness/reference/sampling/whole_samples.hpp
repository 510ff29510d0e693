// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace gloam::reference {

inline unsigned gloam_whole_samples(unsigned count, unsigned unit) {
    const unsigned taps = std::max(unit, 1U);
    return std::max(count / taps, 1U) * taps;
}

inline unsigned gloam_paired_samples(unsigned count) {
    return count + count % 2U;
}

}  // namespace gloam::reference
