// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
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
    // A view without any of them stands still. Both views need normals, and have one size.
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

// A mask: one byte for each pixel, non-zero where it is set.
using Mask = std::vector<std::uint8_t>;

// Flicker: the mean magnitude of the change of an image from frame to frame at the same surface points, less
// the change that is `due` there (empty: none). It is taken over the points that were seen before and, when
// `mask` is not empty, are set in it; nullopt when there are none. All images have one size.
[[nodiscard]] std::optional<double> mean_change(const HistoryMap& history, std::span<const float> image,
                                                std::span<const float> previous,
                                                std::span<const float> due = {}, const Mask& mask = {});

// What a temporal method must do at a pixel. Each surface belongs to the first of these that fits.
enum class PixelClass : std::uint8_t {
    disoccluded,  // newly uncovered: its point was not seen in the frame before
    moving,       // its surface moved
    near_moving,  // near what moves or has just moved
    settled,      // seen for many frames in which nothing moved within the radius
    young,        // its history is still short
    background,
};

// Names of all but the background, in that order.
inline constexpr std::array<std::string_view, 5> pixel_class_names{"disoccluded", "moving", "near_moving",
                                                                   "settled", "young"};

// The classes of the pixels of a moving view, frame by frame.
class PixelClasses {
  public:
    struct Settings {
        double radius = 0.5;      // of influence, world units: how far a moving object affects the occlusion
        int settled_frames = 32;  // after which a pixel is settled
        double near = 24.0;       // pixels from what moves, in the image, where that is within the radius
        int memory = 4;           // frames for which a surface counts as near what has moved there
    };

    explicit PixelClasses(const Settings& settings) : settings_(settings) {}

    // Takes the next frame. `history`: from the previous frame to this one; nullopt for the first frame and
    // after a camera cut. The size changes with a cut alone.
    void advance(const scene::GBuffer& view, const std::optional<HistoryMap>& history);

    [[nodiscard]] PixelClass at(std::size_t pixel) const { return classes_[pixel]; }
    [[nodiscard]] Mask mask(PixelClass one) const;

  private:
    Settings settings_;
    std::vector<PixelClass> classes_;
    Mask moving_;             // surfaces that moved, in the last frame
    std::vector<int> quiet_;  // frames for which the point was seen and nothing moved within the radius
    std::vector<int> calm_;   // frames since something moved near it
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
// and Huttenlocher 2012).
[[nodiscard]] std::vector<float> distance_to(const Mask& mask, backend::Extent extent);

}  // namespace gloam::effect
