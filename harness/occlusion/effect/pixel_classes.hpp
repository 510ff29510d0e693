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

// Where a depth buffer tells least about occlusion. The masks may overlap; none holds background.
struct HardPlaces {
    // A surface within a tenth of the radius rises above the tangent plane, by 15 degrees or more.
    Mask contacts;
    // On what is less than half a radius wide, with a step of depth to both sides; and up to a quarter of the
    // radius beside it in the image.
    Mask thin;
    // Nearer to the image's edge than the radius.
    Mask rim;
};

// radius: of influence, world units. The view needs normals.
[[nodiscard]] HardPlaces hard_places(const scene::GBuffer& view, double radius);

// Distance of each pixel to the nearest set one, in pixels; +infinity when none is set. Exact (Felzenszwalb
// and Huttenlocher 2012). Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] std::vector<float> distance_to(const Mask& mask, gpu::Extent extent);

}  // namespace gloam::effect
