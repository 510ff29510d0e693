// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/tiles.hpp"

namespace gloam::effect {

// Sums of all tiles of an image, by rows; Work::converged stays 0.
// band: on each side, that is not shaded.
[[nodiscard]] Work summed(std::span<const TileState> tiles, gpu::Extent extent, gpu::Extent band);

// Of all passes. NaN where the device has no clock.
[[nodiscard]] double total_ms(const Frame& frame);

// The median; the mean of the middle two of an even number. NaN for none.
[[nodiscard]] double median(std::span<const double> values);

}  // namespace gloam::effect
