// SPDX-License-Identifier: MIT
#include "effect/tile_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::effect {
namespace {

// Pixels of the radius at this depth, along the longer side of a pixel.
double reach_of(const scene::GBuffer& view, double radius, double depth) {
    const glm::mat4& projection = view.camera.proj_vk;
    const double across = std::max(view.extent.width * std::abs(double{projection[0][0]}),
                                   view.extent.height * std::abs(double{projection[1][1]}));
    return 0.5 * across * radius / (view.camera.orthographic() ? 1.0 : depth);
}

// The depth of the nearest surface in a tile; infinity: it has none.
float nearest_in(const scene::GBuffer& view, std::uint32_t column, std::uint32_t row) {
    float nearest = std::numeric_limits<float>::infinity();
    for (std::uint32_t y = tile_side * row; y < std::min(tile_side * (row + 1), view.extent.height); ++y)
        for (std::uint32_t x = tile_side * column; x < std::min(tile_side * (column + 1), view.extent.width);
             ++x)
            if (const float depth = view.depth[std::size_t{y} * view.extent.width + x]; depth > 0.0F)
                nearest = std::min(nearest, depth);
    return nearest;
}

}  // namespace

backend::Extent tiles_of(backend::Extent view) {
    return {(view.width + tile_side - 1) / tile_side, (view.height + tile_side - 1) / tile_side};
}

std::vector<TileWork> tile_work_of(const scene::GBuffer& view, const Settings& settings) {
    const backend::Extent count = tiles_of(view.extent);
    const bool all = settings.passes == Passes::study || settings.resolution == Resolution::full;
    std::vector<TileWork> tiles;
    for (std::uint32_t row = 0; row < count.height; ++row)
        for (std::uint32_t column = 0; column < count.width; ++column) {
            const double depth = nearest_in(view, column, row);
            if (std::isinf(depth))
                tiles.push_back(TileWork::background);
            else if (reach_of(view, double{settings.radius}, depth) < 1.0)
                tiles.push_back(TileWork::below_pixel);
            else
                tiles.push_back(all ? TileWork::full : TileWork::half);
        }
    return tiles;
}

TileShares shares_of(const std::vector<TileWork>& tiles) {
    const auto share = [&](TileWork work) {
        return static_cast<double>(std::ranges::count(tiles, work)) / static_cast<double>(tiles.size());
    };
    return {share(TileWork::background), share(TileWork::below_pixel), share(TileWork::half),
            share(TileWork::full)};
}

}  // namespace gloam::effect
