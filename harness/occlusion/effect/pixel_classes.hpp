// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "effect/history_map.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// A mask: one byte for each pixel, non-zero where it is set.
using Mask = std::vector<std::uint8_t>;

// The classes of pixels of a moving view that a temporal method treats differently, frame by frame. They do
// not overlap. A pixel in none of them has a history that is still short.
class PixelClasses {
  public:
    struct Settings {
        double radius =
            0.5;  // radius of influence, world units: how far a moving object affects the occlusion
        int settled_frames =
            32;  // a pixel is settled after it was seen for this many frames with nothing moving near it
        int memory = 8;  // frames for which a pixel counts as near after the object has left
    };

    explicit PixelClasses(const Settings& settings) : settings_(settings) {}

    // Takes the next frame. `history`: from the previous frame to this one; nullopt for the first frame and
    // after a camera cut. Throws std::invalid_argument when the size changes without a cut.
    void advance(const scene::GBuffer& view, const std::optional<HistoryMap>& history);

    [[nodiscard]] const Mask& disoccluded() const { return disoccluded_; }  // not seen in the previous frame
    // Not disoccluded, but within the projected radius of a moving surface: in this frame, in the previous
    // one, or in one of the last `memory` frames, followed along the surface.
    [[nodiscard]] const Mask& near_moving() const { return near_moving_; }
    [[nodiscard]] const Mask& settled() const { return settled_; }

  private:
    Settings settings_;
    Mask disoccluded_;
    Mask near_moving_;
    Mask settled_;
    Mask moving_;            // surfaces that moved, in the last frame
    std::vector<int> age_;   // frames since the point came into view
    std::vector<int> calm_;  // frames since something moved near it
};

// Distance of each pixel to the nearest set one, in pixels; +infinity when none is set. Exact (Felzenszwalb
// and Huttenlocher 2012). Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] std::vector<float> distance_to(const Mask& mask, gpu::Extent extent);

}  // namespace gloam::effect
