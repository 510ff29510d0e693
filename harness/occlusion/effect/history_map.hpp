// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/gbuffer.hpp"

namespace gloam::effect {

// Where the surface point of each pixel was seen in the previous frame, calculated in double on the host. It
// judges temporal methods, so it is independent of their reprojection. A pixel saw the point if it is one of
// the four around the point's earlier place and its surface lies within two pixels' width of the point's
// tangent plane.
class HistoryMap {
  public:
    // view: its earlier positions come from the first of these that it has: previous_position; its motion,
    // with the depth from the cameras; the cameras alone, where previous_from_current precedes previous_view.
    // A view without any of them stands still. Both views need normals. Throws std::invalid_argument when the
    // sizes disagree.
    HistoryMap(const scene::GBuffer& view, const scene::GBuffer& previous);

    // Whether the pixel's point was seen in the previous frame; false at the background.
    [[nodiscard]] bool seen(std::size_t pixel) const { return taps_[pixel][0].weight > 0.0F; }

    // The pixel of the previous frame that saw the point best. Requires seen().
    [[nodiscard]] std::size_t nearest(std::size_t pixel) const { return taps_[pixel][0].pixel; }

    // An image of the previous frame at the point's earlier place: bilinear over the pixels that saw the
    // point. Requires seen().
    [[nodiscard]] double sample(std::size_t pixel, std::span<const float> previous) const;

    // Whether the surface point moved in the world: by more than a fiftieth of a pixel's width.
    [[nodiscard]] bool moved(std::size_t pixel) const { return moved_[pixel] != 0; }

  private:
    struct Tap {
        std::uint32_t pixel = 0;
        float weight = 0.0F;  // 0: did not see the point; the largest comes first, and they sum to 1
    };
    std::vector<std::array<Tap, 4>> taps_;
    std::vector<std::uint8_t> moved_;
};

// Flicker: the mean magnitude of the change of an image from frame to frame at the same surface points. It
// is taken over the points that were seen before and, when `mask` is not empty, are set in it; 0 when there
// are none. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] double mean_change(const HistoryMap& history, std::span<const float> image,
                                 std::span<const float> previous, std::span<const std::uint8_t> mask = {});

}  // namespace gloam::effect
