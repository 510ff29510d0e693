// SPDX-License-Identifier: MIT
#pragma once

namespace gloam::reference {

template <class T = double>
unsigned gloam_bit_count(unsigned bits) {
    const unsigned pairs = bits - ((bits >> 1U) & 0x55555555U);
    const unsigned nibbles = (pairs & 0x33333333U) + ((pairs >> 2U) & 0x33333333U);
    return (((nibbles + (nibbles >> 4U)) & 0x0F0F0F0FU) * 0x01010101U) >> 24U;
}

}  // namespace gloam::reference
