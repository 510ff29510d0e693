// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "effect/internal/tiles.hpp"
#include "effect/settings.hpp"
#include "gpu/buffer.hpp"
#include "gpu/image.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

[[nodiscard]] std::size_t pixels_of(gpu::Extent extent);

// One channel of texels of four.
[[nodiscard]] std::vector<float> channel(std::span<const float> texels, std::size_t which);

// Of the images that hold a history.
[[nodiscard]] gpu::Format format_of(HistoryPrecision precision);

// Occlusion of 1 in a packed history, as GloamPackedHistory has it.
constexpr float packed_occlusion_unit = 1.0F / 32768.0F;

// What a history image holds for each pixel.
struct HistoryTexels {
    std::vector<float> occlusion;
    std::vector<float> samples;  // accumulated
};
[[nodiscard]] HistoryTexels history_in(const gpu::Image& image);

// Everything of the size of the image.
struct FrameImages {
    FrameImages(const gpu::Device& device, gpu::Extent size, HistoryPrecision precision);

    // Takes depth and its layers, normals and positions of the frame before. Throws std::invalid_argument
    // where one has another size than the images.
    void take(const gpu::Device& device, const scene::GBuffer& view);

    // Images for what is shown of history and filter; from the first settings that map them.
    void map(const gpu::Device& device);

    gpu::Image depth;
    gpu::Image normal;
    gpu::Image before;       // history of the last frame, at its pixels
    gpu::Image reprojected;  // the same at the pixels of this frame, when the view has moved
    gpu::Image after;        // history of this frame
    gpu::Image half_filtered;
    gpu::Image filtered;
    Tiles tiles;
    std::optional<gpu::Image> previous_position;
    std::optional<gpu::Image> layers;           // of depth behind the first, one in each channel
    std::optional<gpu::Image> mapped;           // what is shown of the history, where it is mapped at all
    std::optional<gpu::Image> filtered_mapped;  // and of the filter's result
};

}  // namespace gloam::effect
