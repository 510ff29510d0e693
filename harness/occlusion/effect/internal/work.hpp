// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

#include "effect/ambient_occlusion.hpp"
#include "effect/internal/tiles.hpp"

namespace gloam::effect {

// Sums over all tiles of an image, given by rows; Work::converged stays 0. band: guard band on each side that
// is not shaded. samples: that a pixel may take. selected: only flagged tiles are shaded.
[[nodiscard]] Work summed(std::span<const TileState> tiles, gpu::Extent extent, gpu::Extent band,
                          std::uint32_t samples, bool selected);

// The median; for an even number of values the mean of the middle two. NaN for no value.
[[nodiscard]] double median(std::span<const double> values);

}  // namespace gloam::effect
