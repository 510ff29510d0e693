// SPDX-License-Identifier: MIT
#pragma once

#include "scene/camera.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::scene {

// A guard band (TSSAO-BORDER): the view is rendered larger, so that surfaces near the frame's edge have
// neighbours, and the result is cropped. The band is a whole number of pixels on each side, and the larger
// projection follows from these pixels. The frame's pixels therefore have the same view rays as without a
// band.

// The band in pixels, on the left and right (width) and at top and bottom (height): guard times each side of
// the frame, rounded to the nearest pixel, halves up. guard: 0 to 0.5; usual values are 0.05 to 0.1. Throws
// std::invalid_argument for other values.
[[nodiscard]] gpu::Extent guard_border(gpu::Extent frame, double guard);

// The size of the frame with its band.
[[nodiscard]] gpu::Extent with_border(gpu::Extent frame, gpu::Extent border);

// The size of a view without its band. Throws std::invalid_argument for a band that leaves no pixel.
[[nodiscard]] gpu::Extent frame_of(const GBuffer& view);

// The camera of the larger view: tan(fov'/2) = (1 + 2 border / frame) tan(fov/2) along each axis. Its aspect
// is that of with_border().
[[nodiscard]] Camera with_border(const Camera& camera, gpu::Extent frame, gpu::Extent border);

// The pixels of an image of `view` that belong to the frame.
template <class Texel>
[[nodiscard]] std::vector<Texel> cropped(const GBuffer& view, const std::vector<Texel>& image) {
    const gpu::Extent frame = frame_of(view);
    if (frame == view.extent || image.empty()) return image;
    std::vector<Texel> inner;
    inner.reserve(std::size_t{frame.width} * frame.height);
    for (std::size_t y = 0; y < frame.height; ++y) {
        const std::size_t first = (y + view.border.height) * view.extent.width + view.border.width;
        for (std::size_t x = 0; x < frame.width; ++x) inner.push_back(image[first + x]);
    }
    return inner;
}

// The frame without its band: cropped images, projection, and motion that is valid only if it began in the
// frame. A view without a band is returned unchanged.
[[nodiscard]] GBuffer cropped(const GBuffer& view);

}  // namespace gloam::scene
