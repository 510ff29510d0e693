// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace gloam::reference {

inline unsigned gloam_whole_samples(unsigned count, unsigned unit) {
    const unsigned taps = std::max(unit, 1U);
    return count < taps ? taps : count - count % taps;
}

}  // namespace gloam::reference
