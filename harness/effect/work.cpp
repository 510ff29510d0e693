// SPDX-License-Identifier: MIT
#include "effect/internal/work.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace gloam::effect {

Work summed(std::span<const TileWork> tiles) {
    Work work{.tiles = tiles.size()};
    for (const TileWork& tile : tiles) {
        work.pixels += tile.pixels;
        work.background += tile.background;
        work.below_radius += tile.below_radius;
        work.samples += tile.samples;
        const bool left_out = tile.pixels == 0;  // in a guard band that is not sampled
        work.tiles_background += !left_out && tile.background == tile.pixels ? 1 : 0;
        work.tiles_skipped += tile.background + tile.below_radius == tile.pixels ? 1 : 0;
    }
    return work;
}

double total_ms(const Frame& frame) {
    double sum = 0.0;
    for (const PassTime& time : frame.times) sum += time.ms;
    return sum;
}

double median(std::span<const double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> sorted(values.begin(), values.end());
    std::ranges::sort(sorted);
    const std::size_t upper = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[upper] : 0.5 * (sorted[upper - 1] + sorted[upper]);
}

}  // namespace gloam::effect
