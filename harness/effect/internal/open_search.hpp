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

// Finds the tiles where nothing can block any sample. A search that finds few of them costs more than it
// saves: the next frames go without, to the same result.
class OpenSearch {
  public:
    // For the next frames: those of another view, whose open tiles are not known yet.
    void take(const View& view, const Settings& settings);

    // The next frame searches, if its settings allow it.
    void restart() { rest_ = 0; }

    // Whether the next frame has a list of open tiles. Not where samples are probes as well (`probes`), where
    // they see further layers, where some of them do not count, and where what they read may lie beyond their
    // reach.
    [[nodiscard]] bool searches(bool probes) const { return provable_ && !probes && rest_ == 0; }

    // The passes of a search, unless the view's open tiles are known. The steps hold until the next call of
    // a member.
    void append_steps(Pipelines& pipelines, const Tiles& tiles, const gpu::Image& depth,
                      const gpu::Image& normal, std::vector<Step>& steps);

    // After a frame, which has searched or not.
    void advance(bool searched, const SelectedTiles& found);

  private:
    gpu::Extent extent_;
    bool provable_ = false;
    bool known_ = false;      // which tiles of the view are open
    std::uint32_t rest_ = 0;  // frames until the next search
    BoundParameters bounding_{};
    std::array<MergeParameters, bound_levels - 1> merging_{};
    OpenParameters opening_{};
};

}  // namespace gloam::effect
