// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "effect/internal/passes.hpp"
#include "effect/internal/pipelines.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/tiles.hpp"
#include "effect/settings.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// Finds the tiles in which nothing can block any sample. A search that finds few of them costs more than it
// saves; then the next frames do not search. The result of a frame is the same either way.
class OpenSearch {
  public:
    // Takes another view, whose open tiles are unknown, and its settings.
    void take(const View& view, const Settings& settings);

    // Lets the next frame search, if its settings allow it.
    void restart() { rest_ = 0; }

    // Whether the next frame has a list of open tiles. False if samples are probes as well (`probes`), if
    // they see further layers, if some samples do not count, or if they may read depth from beyond their
    // reach.
    [[nodiscard]] bool searches(bool probes) const { return provable_ && !probes && rest_ == 0; }

    // Appends the passes of a search, unless the view's open tiles are known. The steps are valid until the
    // next call of a member.
    void append_steps(Pipelines& pipelines, const Tiles& tiles, const gpu::Image& depth,
                      const gpu::Image& normal, std::vector<Step>& steps);

    // Call it after each frame. `searched`: whether the frame has searched. `found`: its counts.
    void advance(bool searched, const SelectedTiles& found);

  private:
    gpu::Extent extent_;
    bool provable_ = false;
    bool known_ = false;      // which tiles of the view are open is known
    std::uint32_t rest_ = 0;  // frames until the next search
    BoundParameters bounding_{};
    std::array<MergeParameters, bound_levels - 1> merging_{};
    OpenParameters opening_{};
};

}  // namespace gloam::effect
