// SPDX-License-Identifier: MIT
#pragma once

#include <bit>

namespace gloam::reference {

inline unsigned gloam_bit_count(unsigned bits) {
    return static_cast<unsigned>(std::popcount(bits));
}

}  // namespace gloam::reference
