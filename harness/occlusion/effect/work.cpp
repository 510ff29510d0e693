// SPDX-License-Identifier: MIT
#include "effect/internal/work.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "effect/internal/passes.hpp"

namespace gloam::effect {

namespace {

// Shaded pixels along a tile's side. first: its first pixel. size: of the image. band: not shaded, on each
// side.
std::uint32_t shaded_side(std::uint32_t first, std::uint32_t size, std::uint32_t band) {
    const std::uint32_t begin = std::max(first, band);
    const std::uint32_t end = std::min(first + tile_side, size - band);
    return end > begin ? end - begin : 0;
}

}  // namespace

Work summed(std::span<const TileState> tiles, gpu::Extent extent, gpu::Extent band, std::uint32_t samples,
            bool selected) {
    constexpr std::uint32_t mask = 0xFF;
    const std::size_t columns = groups_for(extent)[0];
    Work work{.tiles = tiles.size()};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const TileState& tile = tiles[i];
        const auto x = static_cast<std::uint32_t>(i % columns) * tile_side;
        const auto y = static_cast<std::uint32_t>(i / columns) * tile_side;
        const std::uint32_t pixels =
            shaded_side(x, extent.width, band.width) * shaded_side(y, extent.height, band.height);
        const std::uint32_t background = tile.pixels & mask;
        const std::uint32_t below_radius = tile.pixels >> 8U & mask;
        work.pixels += pixels;
        work.background += background;
        work.below_radius += below_radius;
        const bool shaded = !selected || (tile.flags & state_shaded) != 0;
        if (shaded) work.samples += std::uint64_t{samples} * pixels - tile.missed;
        const bool left_out = pixels == 0;  // in a guard band that is not sampled
        work.tiles_background += !left_out && background == pixels ? 1 : 0;
        work.tiles_skipped += background + below_radius == pixels ? 1 : 0;
    }
    return work;
}

double median(std::span<const double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const std::size_t upper = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[upper] : 0.5 * (sorted[upper - 1] + sorted[upper]);
}

}  // namespace gloam::effect
