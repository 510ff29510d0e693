// SPDX-License-Identifier: MIT
#include "effect/internal/open_search.hpp"

#include <fmt/format.h>

#include "effect/methods.hpp"

namespace gloam::effect {

void OpenSearch::take(const View& view, const Settings& settings) {
    const OpenProof proof = method_named(settings.method).open_proof;
    provable_ = settings.skip_open && settings.layers == 1 && !settings.reject_taps &&
                !(settings.own.mip_distance > 0.0F) && proof != OpenProof::none &&
                !view.camera.orthographic();
    known_ = false;
    extent_ = view.extent;
    const std::array<std::int32_t, 2> size{static_cast<std::int32_t>(extent_.width),
                                           static_cast<std::int32_t>(extent_.height)};
    const glm::vec2 p = view.camera.p00_p11();
    bounding_ = {.size = size};
    for (std::uint32_t level = 1; level < bound_levels; ++level)
        merging_.at(level - 1) = {.size = size, .level = static_cast<std::int32_t>(level)};
    opening_ = {.p00_p11 = {p.x, p.y},
                .size = size,
                .radius = settings.radius,
                .bias = settings.bias,
                .points = proof == OpenProof::points ? 1U : 0U};
}

void OpenSearch::append_steps(Pipelines& pipelines, const Tiles& tiles, const gpu::Image& depth,
                              const gpu::Image& normal, std::vector<Step>& steps) {
    if (known_) return;
    const auto over_blocks = [&](std::uint32_t level) { return groups_for(blocks_of(extent_, level)); };
    steps.push_back(
        {"bound_tiles", &pipelines.bounding(), {depth, tiles.bounds()}, bytes_of(bounding_), over_blocks(0)});
    for (std::uint32_t level = 1; level < bound_levels; ++level) {
        steps.push_back({fmt::format("merge_bounds_{}", level),
                         &pipelines.merging(),
                         {tiles.bounds()},
                         bytes_of(merging_.at(level - 1)),
                         over_blocks(level)});
    }
    steps.push_back({"open_tiles",
                     &pipelines.opening(),
                     {depth, normal, tiles.bounds(), tiles.open()},
                     bytes_of(opening_),
                     over_blocks(0)});
    known_ = true;
}

void OpenSearch::advance(bool searched, const SelectedTiles& found) {
    if (!searched) {
        rest_ -= rest_ > 0 ? 1 : 0;
        return;
    }
    constexpr std::uint32_t worth_it = 8;  // the search takes about an eighth of the time of all samples
    constexpr std::uint32_t frames_without = 7;
    rest_ = worth_it * found.open < found.shaded ? frames_without : 0;
}

}  // namespace gloam::effect
