// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "scene/lighting.hpp"

namespace gloam::scene {

// The light of a picture at several samples of each pixel, so that its edges are smooth. The occlusion stays
// that of the pixels: a sample shows the pixel of `pixel`.
struct PictureLight {
    gpu::Extent extent;                // in pixels of the view
    int samples = 1;                   // on each side of a pixel
    SplitLight light;                  // of each sample: extent * samples on each side, rows from the top
    std::vector<glm::vec3> albedo;     // of each sample; 0 at the background
    std::vector<std::uint32_t> pixel;  // of each sample: the pixel whose surface it shows

    [[nodiscard]] gpu::Extent sampled() const {
        const auto count = static_cast<std::uint32_t>(samples);
        return {extent.width * count, extent.height * count};
    }

    // A value for each sample, from those of the pixels. Throws std::invalid_argument for another size.
    [[nodiscard]] std::vector<float> spread(const std::vector<float>& of_pixels) const;

    // The mean of each pixel's samples. Throws std::invalid_argument for another size.
    [[nodiscard]] std::vector<glm::vec3> mean(const std::vector<glm::vec3>& of_samples) const;
};

// The light of a view without its guard band, at the samples of `fine`: the same view with `samples` times as
// many pixels on each side. A sample shows its own pixel, unless it is off the plane of that pixel's surface
// by more than 0.6 % of its depth; then that of the 3 x 3 pixels around it whose plane is nearest. Throws
// std::invalid_argument for sizes that disagree, and like light_of().
[[nodiscard]] PictureLight picture_light(const GBuffer& view, const GBuffer& fine, int samples,
                                         const Scene* scene, const LightingOptions& options = {});

}  // namespace gloam::scene
