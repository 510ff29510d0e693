// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "effect/internal/tiles.hpp"
#include "effect/internal/view_images.hpp"
#include "effect/settings.hpp"
#include "gpu/buffer.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

[[nodiscard]] std::size_t pixels_of(gpu::Extent extent);

// One channel of an image of four: element `which` of each texel.
[[nodiscard]] std::vector<float> channel(std::span<const float> texels, std::size_t which);

// Format of the images that hold a history.
[[nodiscard]] gpu::Format format_of(HistoryPrecision precision);

// Format of the images that hold what is displayed.
[[nodiscard]] gpu::Format format_of(OutputFormat output);

// Occlusion that the integer 1 of a packed history stands for, as in GloamPackedHistory.
constexpr float packed_occlusion_unit = 1.0F / 32768.0F;

// A history image, by channel.
struct HistoryTexels {
    std::vector<float> occlusion;
    std::vector<float> samples;  // accumulated
};
[[nodiscard]] HistoryTexels history_in(const gpu::Image& image);

// All images and buffers that have the size of the view.
struct FrameImages {
    FrameImages(const gpu::Device& device, gpu::Extent size, HistoryPrecision precision);

    // Allocates the displacement of surface points, if the inputs have previous positions.
    void watch_objects(const gpu::Device& device);

    // Allocates the images for remapped results, if they do not exist yet in this format.
    void map(const gpu::Device& device, OutputFormat output);

    ViewImages inputs;
    gpu::Image before;       // history of the last frame, at its pixels
    gpu::Image reprojected;  // the same at the pixels of this frame, if the view has moved
    gpu::Image after;        // history of this frame
    gpu::Image half_filtered;
    gpu::Image filtered;
    Tiles tiles;
    std::optional<gpu::Image> displacement;     // of surface points, where there are previous positions
    std::optional<gpu::Image> mapped;           // remapped history, if anything is remapped
    std::optional<gpu::Image> filtered_mapped;  // remapped result of the filter
};

}  // namespace gloam::effect
