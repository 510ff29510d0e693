// SPDX-License-Identifier: MIT
#include "effect/internal/tiles.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "effect/internal/passes.hpp"

namespace gloam::effect {
namespace {

std::size_t tiles_of(gpu::Extent extent) {
    const auto groups = groups_for(extent);
    return std::size_t{groups[0]} * groups[1];
}

std::size_t bounds_of(gpu::Extent extent) {
    std::size_t sum = 0;
    for (std::uint32_t level = 0; level < bound_levels; ++level) {
        const gpu::Extent blocks = blocks_of(extent, level);
        sum += std::size_t{blocks.width} * blocks.height;
    }
    return sum;
}

}  // namespace

gpu::Extent blocks_of(gpu::Extent extent, std::uint32_t level) {
    const std::uint32_t side = tile_side << (2 * level);
    return {(extent.width + side - 1) / side, (extent.height + side - 1) / side};
}

Tiles::Tiles(const gpu::Device& device, gpu::Extent extent)
    : before_(device, tiles_of(extent) * sizeof(TileState)),
      after_(device, tiles_of(extent) * sizeof(TileState)),
      lists_(device, header_lists * sizeof(TileList) + tile_lists * tiles_of(extent) * sizeof(std::uint32_t)),
      open_(device, tiles_of(extent) * sizeof(std::uint32_t)),
      bounds_(device, bounds_of(extent) * 4 * sizeof(float)) {
    forget();
}

void Tiles::forget() {
    std::ranges::fill(before_.as<TileState>(), TileState{});
    std::ranges::fill(open_.as<std::uint32_t>(), 0U);
    clear();
}

void Tiles::clear() {
    std::ranges::fill(after_.as<TileState>(), TileState{});
    std::ranges::copy(empty_lists(), lists_.bytes().begin());
}

std::vector<std::byte> empty_lists() {
    std::array<TileList, header_lists> lists{};
    for (TileList& list : lists) list.layers = 1;
    lists.back() = {};
    const auto bytes = std::as_bytes(std::span(lists));
    return {bytes.begin(), bytes.end()};
}

SelectedTiles Tiles::counts() const {
    const auto lists = lists_.as<TileList>().first(header_lists);
    return {.shaded = lists[0].tiles,
            .filtered = lists[2].tiles,
            .background = lists.back().columns,
            .settled = lists.back().rows,
            .open = lists[4].tiles,
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
    const std::size_t left_out =
        std::size_t{found.background} + found.settled + found.open + found.filtered_enough;
    quiet_ = worth_it * left_out < tiles ? quiet_ + 1 : 0;
    if (quiet_ < patience) return;
    quiet_ = 0;
    rest_ = frames_without;
}

std::size_t offset_of(TileLists list) {
    return static_cast<std::size_t>(list) * sizeof(TileList);
}

bool selects_tiles(const Settings& settings) {
    return settings.skip_background || settings.skip_open || settings.skip_settled || settings.skip_filtered;
}

std::int32_t filter_reach(const Settings& settings) {
    // SAO's taps are two pixels apart.
    return settings.filter == Filter::sao ? 2 * settings.filter_half_width : settings.filter_half_width;
}

}  // namespace gloam::effect
