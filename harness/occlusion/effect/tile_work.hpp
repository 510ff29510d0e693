// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

inline constexpr std::uint32_t tile_side = 8;  // pixels

// Tiles that cover a view.
[[nodiscard]] backend::Extent tiles_of(backend::Extent view);

// What a frame does in a tile of 8 x 8 pixels of the view, the most that it does in any of its pixels.
enum class TileWork {
    background,   // nothing: it has no surface
    below_pixel,  // nothing: the radius is less than a pixel
    half,         // every second pixel is swept in both directions
    full          // each pixel is
};
// Of each tile, by rows, before the frame marks any. view: with its guard band.
[[nodiscard]] std::vector<TileWork> tile_work_of(const scene::GBuffer& view, const Settings& settings);

// The share of the tiles, in [0, 1], that each kind of work has.
struct TileShares {
    double background = 0.0;
    double below_pixel = 0.0;
    double half = 0.0;
    double full = 0.0;
};
[[nodiscard]] TileShares shares_of(const std::vector<TileWork>& tiles);

}  // namespace gloam::effect
