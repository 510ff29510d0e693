// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "effect/ambient_occlusion.hpp"

namespace gloam::effect {

// What ambient_occlusion.comp writes for each group, as it declares it.
struct TileWork {
    std::uint32_t samples;
    std::uint32_t background;
    std::uint32_t below_radius;
    std::uint32_t pixels;
};

// Sums of all tiles; Work::converged stays 0.
[[nodiscard]] Work summed(std::span<const TileWork> tiles);

// Of all passes. NaN where the device has no clock.
[[nodiscard]] double total_ms(const Frame& frame);

// The median; the mean of the middle two of an even number. NaN for none.
[[nodiscard]] double median(std::span<const double> values);

}  // namespace gloam::effect
