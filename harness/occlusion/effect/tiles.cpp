// SPDX-License-Identifier: MIT
#include "effect/internal/tiles.hpp"

#include <array>
#include <span>

namespace gloam::effect {

std::vector<std::byte> empty_lists() {
    std::array<TileList, header_lists> lists{};
    for (TileList& list : lists) list.layers = 1;
    lists.back() = {};
    const auto bytes = std::as_bytes(std::span(lists));
    return {bytes.begin(), bytes.end()};
}

SelectedTiles counts_in(const gpu::Buffer& buffer) {
    const auto lists = buffer.as<TileList>().first(header_lists);
    return {.shaded = lists[0].tiles,
            .filtered = lists[2].tiles,
            .background = lists.back().columns,
            .settled = lists.back().rows,
            .filtered_enough = lists.back().tiles};
}

void Listing::advance(bool listed, const SelectedTiles& found, std::size_t tiles) {
    if (!listed) {
        rest_ -= rest_ > 0 ? 1 : 0;
        return;
    }
    constexpr std::size_t worth_it = 16;   // lists take about a sixteenth of the time of a frame
    constexpr std::uint32_t patience = 4;  // after three frames it is known which images hold background
    constexpr std::uint32_t frames_without = 20;
    const std::size_t left_out = std::size_t{found.background} + found.settled + found.filtered_enough;
    quiet_ = worth_it * left_out < tiles ? quiet_ + 1 : 0;
    if (quiet_ < patience) return;
    quiet_ = 0;
    rest_ = frames_without;
}

std::size_t offset_of(TileLists list) {
    return static_cast<std::size_t>(list) * sizeof(TileList);
}

bool selects_tiles(const Settings& settings) {
    return settings.skip_background || settings.skip_settled || settings.skip_filtered;
}

}  // namespace gloam::effect
