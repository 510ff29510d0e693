// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {

// The header of a list of tiles, as in glsl/passes/tiles/list.glsl; also an indirect dispatch.
struct TileList {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t layers = 0;
    std::uint32_t tiles = 0;
};

// Flag of a tile that select.comp has listed, as in glsl/passes/tiles/state.glsl.
constexpr std::uint32_t state_shaded = 1;

// What is known about a tile after a frame, as in glsl/passes/tiles/state.glsl.
struct TileState {
    std::uint32_t flags = 0;
    std::uint32_t missed = 0;  // samples not taken
    std::uint32_t pixels =
        0;  // counts of its pixels, eight bits each: background, below the limit, frozen, filtered
};

enum class TileLists : std::uint8_t { shaded, filtered_x, filtered_y };

constexpr std::size_t tile_lists = 3;
constexpr std::size_t header_lists = tile_lists + 1;  // headers of the buffer: the last one holds counts

// Images that may hold nothing but background in a tile: bits of SelectParameters::written.
enum TileImage : std::uint32_t {
    image_first_history = 1,
    image_second_history = 2,
    image_reprojected = 4,
    image_filtered = 8,
    image_mapped = 16,
    image_filtered_mapped = 32
};

// How many tiles a frame shaded, and how many it skipped for which reason.
struct SelectedTiles {
    std::uint32_t shaded = 0;
    std::uint32_t filtered = 0;
    std::uint32_t background = 0;
    std::uint32_t settled = 0;
    std::uint32_t filtered_enough = 0;
};

// Decides when a frame runs over lists of tiles. If the last frames of a moving view skipped next to nothing,
// lists cost more than they save; then the next frames run over the whole image. The result is the same. A
// view that stands still always uses lists, because it settles.
class Listing {
  public:
    void restart() { quiet_ = rest_ = 0; }

    [[nodiscard]] bool due(bool moved) const { return !moved || rest_ == 0; }

    // Call it after each frame of `tiles` tiles. `listed`: whether it ran over lists. `found`: its counts.
    void advance(bool listed, const SelectedTiles& found, std::size_t tiles);

  private:
    std::uint32_t quiet_ = 0;  // successive listed frames that skipped next to nothing
    std::uint32_t rest_ = 0;   // frames until the next list
};

// The counts of a frame, from the buffer of lists.
[[nodiscard]] SelectedTiles counts_in(const gpu::Buffer& lists);

// The beginning of the buffer of lists before a frame: every list is empty.
[[nodiscard]] std::vector<std::byte> empty_lists();

// Offset of a list's header in the buffer, bytes.
[[nodiscard]] std::size_t offset_of(TileLists list);

// Whether frames with these settings run over lists of tiles.
[[nodiscard]] bool selects_tiles(const Settings& settings);

}  // namespace gloam::effect
