// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/buffer.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// A list of tiles in the buffer of them, as glsl/passes/tiles/list.glsl has it, and an indirect dispatch.
struct TileList {
    std::uint32_t columns = 0;
    std::uint32_t rows = 0;
    std::uint32_t layers = 0;
    std::uint32_t tiles = 0;
};

// What is known of a tile after a frame, as glsl/passes/tiles/state.glsl has it.
struct TileState {
    std::uint32_t flags = 0;
    std::uint32_t samples = 0;  // and, from bit 24 on, pixels of which a march was ended
    std::uint32_t pixels =
        0;  // numbers of them in eight bits each: background, below the limit, frozen, filtered
};

enum class TileLists : std::uint8_t { shaded, filtered_x, filtered_y, sampled, open };

constexpr std::size_t tile_lists = 5;

// Images whose tiles may be known to hold nothing but background: bits of SelectParameters::written.
enum TileImage : std::uint32_t {
    image_first_history = 1,
    image_second_history = 2,
    image_reprojected = 4,
    image_filtered = 8,
    image_mapped = 16,
    image_filtered_mapped = 32
};

// Push constants of tiles/select.comp.
struct SelectParameters {
    std::array<std::int32_t, 2> size;
    std::array<std::int32_t, 2> band;
    std::uint32_t written;
    std::uint32_t background;
    std::uint32_t settled;
    std::uint32_t open;
};

// Of tiles/bound.comp.
struct BoundParameters {
    std::array<std::int32_t, 2> size;
};

// Of tiles/merge_bounds.comp.
struct MergeParameters {
    std::array<std::int32_t, 2> size;
    std::int32_t level;
};

// Of tiles/open.comp.
struct OpenParameters {
    std::array<float, 2> p00_p11;
    std::array<std::int32_t, 2> size;
    float radius;
    float bias;
    std::uint32_t points;
};

// And of tiles/select_filtered.comp.
struct SelectFilteredParameters {
    std::array<std::int32_t, 2> size;
    std::array<std::int32_t, 2> reach;
};

// How many tiles a frame ran on, and why it left others out.
struct SelectedTiles {
    std::uint32_t shaded = 0;
    std::uint32_t filtered = 0;
    std::uint32_t background = 0;
    std::uint32_t settled = 0;
    std::uint32_t open = 0;  // of those shaded: without a tap
    std::uint32_t filtered_enough = 0;
};

// When a frame runs over lists of tiles. Where the last frames of a moving view had next to nothing to leave
// out, lists cost more than they save: the next ones run over the whole image, to the same result. A view
// that stands still is always listed: it settles.
class Listing {
  public:
    void restart() { quiet_ = rest_ = 0; }

    [[nodiscard]] bool due(bool moved) const { return !moved || rest_ == 0; }

    // After a frame of `tiles` tiles, which was listed or not.
    void advance(bool listed, const SelectedTiles& found, std::size_t tiles);

  private:
    std::uint32_t quiet_ = 0;  // listed frames in a row that left out next to nothing
    std::uint32_t rest_ = 0;   // frames until the next list
};

// What is known of the tiles of an image from frame to frame, and the lists of those that passes run on.
class Tiles {
  public:
    Tiles(const gpu::Device& device, gpu::Extent extent);

    // Nothing is known any more.
    void forget();

    // Empties the lists and counts: before each run of the passes.
    void clear();

    // The states of this frame become those of the last.
    void advance() { std::swap(before_, after_); }

    [[nodiscard]] SelectedTiles counts() const;

    [[nodiscard]] const gpu::Buffer& before() const { return before_; }
    [[nodiscard]] const gpu::Buffer& after() const { return after_; }
    [[nodiscard]] const gpu::Buffer& lists() const { return lists_; }
    [[nodiscard]] const gpu::Buffer& open() const { return open_; }
    [[nodiscard]] const gpu::Buffer& bounds() const { return bounds_; }

  private:
    gpu::Buffer before_;
    gpu::Buffer after_;
    gpu::Buffer lists_;
    gpu::Buffer open_;
    gpu::Buffer bounds_;
};

// The beginning of the buffer of lists before a frame: every list empty.
[[nodiscard]] std::vector<std::byte> empty_lists();

// Levels of the pyramid of bounds, as glsl/passes/tiles/bounds.glsl has it: of tiles, and twice of 4 x 4.
constexpr std::uint32_t bound_levels = 3;

// Blocks of a level that cover an image, along x and y.
[[nodiscard]] gpu::Extent blocks_of(gpu::Extent extent, std::uint32_t level);

// Where a list is in the buffer, bytes.
[[nodiscard]] std::size_t offset_of(TileLists list);

// Whether a frame runs over lists of tiles at all.
[[nodiscard]] bool selects_tiles(const Settings& settings);

// Pixels that the settings' filter reads to each side, at most.
[[nodiscard]] std::int32_t filter_reach(const Settings& settings);

}  // namespace gloam::effect
