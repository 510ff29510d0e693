// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// For comparisons in which NaN is itself and -0 is not 0.
inline std::vector<std::uint32_t> bits_of(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) bits.push_back(std::bit_cast<std::uint32_t>(value));
    return bits;
}

// The settings with every skip off.
inline Settings without_skips(Settings settings) {
    settings.skip_background = false;
    settings.skip_open = false;
    settings.skip_closed = false;
    settings.skip_settled = false;
    settings.skip_filtered = false;
    return settings;
}

}  // namespace gloam::effect
